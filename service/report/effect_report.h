// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "study/effect_study.h"

namespace slipstitch {

/// A study and the pictures beside it.
struct EffectReport {
  EffectStudy study;
  std::string stem;     // of its files
  std::string picture;  // growing_picture(); may be empty
};

/// Files of the plot and of the picture, beside that of effect_markdown().
std::string plot_file(const EffectReport& report);     // effects/STEM.svg
std::string picture_file(const EffectReport& report);  // effects/STEM-growing.svg

/// One row an effect and scene, all that was measured on both sides; numbers with 9 digits, empty where there is no
/// comparison.
std::string effect_csv(std::span<const EffectReport> reports);

/// How far every effect moves the fabric, and the time it takes, as SVG.
std::string effect_plot(const EffectStudy& study);

/// Tables, plots and pictures of all scenes, and what every effect is. Refers to the files of the plots and pictures.
std::string effect_markdown(std::span<const EffectReport> reports, const std::string& command);

/// The same as one self-contained page.
std::string effect_page(std::span<const EffectReport> reports, const std::string& command);

}  // namespace slipstitch
