// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

struct DragParameters {
  double linear = 0.0;     // c1 [N s/m^2]
  double quadratic = 0.0;  // c2 [N s^2/m^3]
};

/// E = h D_n (1/2 c1 |w|^2 + 1/3 c2 |w|^3), w = (x0 + x1 - start)/(2 h) - air: the velocity of a segment's midpoint
/// relative to the air over the step, start = (x0 + x1)*. Force -(c1 + c2 |w|) w per metre. Convex.
struct DragStep {
  double h = 0.0;             // [s]
  Vec3 air = Vec3::Zero();    // [m/s]
  double length = 0.0;        // D_n [m]
  Vec3 start = Vec3::Zero();  // [m]
};
double air_drag_energy(const DragParameters& p, const DragStep& step, const Vec<6>& q, Vec<6>* g, Mat<6>* hess);

/// Drag of the air on every segment, alike along and across the yarn. The velocity is that of the nodes: yarn that
/// slides along itself through held contacts feels none.
class AirDrag {
 public:
  static constexpr int kSize = 6;
  static constexpr std::string_view kName = "air_drag";

  explicit AirDrag(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
    const auto i = static_cast<std::size_t>(k);
    return air_drag_energy(parameters_, {h_, air_, length_[i], start_[i]}, q, g, hess);
  }
  void begin_step(const StepContext& step);

 private:
  const Model* model_ = nullptr;  // outlives the pool
  DragParameters parameters_;
  std::vector<std::array<int, kSize>> coords_;  // x0, x1 (size)
  std::vector<int> arc_coord_;                  // of u0; u1 is the next (size)
  std::vector<double> length_;                  // D [m] (size)
  std::vector<Vec3> start_;                     // (x0 + x1)* [m] (size)
  Vec3 air_ = Vec3::Zero();                     // [m/s]
  double h_ = 1.0;                              // [s]; before the first step nothing has a length
};
static_assert(ForceTerm<AirDrag>);

}  // namespace slipstitch
