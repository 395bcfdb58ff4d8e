// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "study/work_precision.h"

namespace slipstitch {

/// A study among several, whose own report lies in the folder accuracy/STEM beside what is written here.
struct NamedStudy {
  WorkPrecision study;
  std::string stem;
};

std::string accuracy_folder(const NamedStudy& named);  // accuracy/STEM

/// Of several scenes: how the default compares with the baseline in each and in the middle of all, then every study's
/// tables and plots, to which it refers as files.
std::string accuracy_markdown(std::span<const NamedStudy> studies, const std::string& command);

}  // namespace slipstitch
