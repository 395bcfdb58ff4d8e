// SPDX-License-Identifier: MIT
#pragma once

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// Dead loads, V = -f . x at a node.
class DeadLoad {
 public:
  static constexpr int kSize = 3;
  static constexpr std::string_view kName = "dead_load";

  explicit DeadLoad(const Model& model);
  int size() const { return static_cast<int>(node_.size()); }
  std::array<int, kSize> coords(int k) const {
    const int x = 3 * node_[static_cast<std::size_t>(k)];
    return {x, x + 1, x + 2};
  }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
    const Vec3& f = force_[static_cast<std::size_t>(k)];
    if (g) *g = -f;
    if (hess) hess->setZero();
    return -f.dot(q);
  }
  void begin_step(const StepContext&) {}

 private:
  std::vector<int> node_;    // (size)
  std::vector<Vec3> force_;  // [N] (size)
};
static_assert(ForceTerm<DeadLoad>);

}  // namespace slipstitch
