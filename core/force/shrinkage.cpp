// SPDX-License-Identifier: MIT
#include "force/shrinkage.h"

namespace slipstitch {
namespace {

constexpr int kU0 = 3, kU1 = 7;

}  // namespace

double length_factor(const std::vector<LengthKeyframe>& keyframes, double t) {
  LengthKeyframe before;
  for (const LengthKeyframe& next : keyframes) {
    if (t < next.t) return before.factor + (t - before.t) / (next.t - before.t) * (next.factor - before.factor);
    before = next;
  }
  return before.factor;
}

Vec<8> scaled_arcs(const Vec<8>& q, double factor) {
  Vec<8> scaled = q;
  scale_arc_rows(factor, scaled);
  return scaled;
}

void scale_arc_rows(double factor, Vec<8>& g) {
  g[kU0] *= factor;
  g[kU1] *= factor;
}

void scale_arc_rows(double factor, Mat<8>& hess) {
  for (int i : {kU0, kU1}) {
    hess.row(i) *= factor;
    hess.col(i) *= factor;
  }
}

}  // namespace slipstitch
