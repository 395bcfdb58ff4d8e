// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "math/types.h"
#include "model/issue.h"

namespace slipstitch {

/// "frames_per_s: is 1001 frames, expected at most 1000 frames".
Issue too_many(const std::string& path, const std::string& count, int limit, const std::string& things);

/// Collects problems. Every rule refuses what is not finite.
class Checker {
 public:
  explicit Checker(Issues& issues) : issues_(issues) {}

  void fail(const std::string& path, const std::string& value, const std::string& expected) {
    issues_.push_back({path, value, expected});
  }
  void too_big(const std::string& path, const std::string& count, int limit, const std::string& things) {
    issues_.push_back(too_many(path, count, limit, things));
  }
  void positive(const std::string& path, double value) { require(value > 0.0, path, value, "a finite number > 0"); }
  void not_negative(const std::string& path, double value) {
    require(value >= 0.0, path, value, "a finite number >= 0");
  }
  void finite(const std::string& path, double value) { require(true, path, value, "a finite number"); }
  void finite(const std::string& path, const Vec3& value);
  /// Adds an issue unless `holds` and `value` is finite.
  void require(bool holds, const std::string& path, double value, const std::string& expected);
  void require_index(const std::string& path, int value, int smallest, int largest);

 private:
  Issues& issues_;
};

std::string number_text(double value);
std::string element(const std::string& path, std::size_t index);

}  // namespace slipstitch
