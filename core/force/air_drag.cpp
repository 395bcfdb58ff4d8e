// SPDX-License-Identifier: MIT
#include "force/air_drag.h"

#include "force/segments.h"
#include "force/wind.h"

namespace slipstitch {
namespace {

constexpr double kAirDensity = 1.2;          // [kg/m^3], at 20 C
constexpr double kCylinderDragFactor = 1.2;  // C_d of a cylinder across the flow, Reynolds numbers 10^2 to 10^5

}  // namespace

double air_drag_energy(const DragParameters& p, const DragStep& step, const Vec<6>& q, Vec<6>* g, Mat<6>* hess) {
  const Vec3 w = (q.head<3>() + q.tail<3>() - step.start) / (2.0 * step.h) - step.air;
  const double speed = w.norm();
  const double per_speed = p.linear + p.quadratic * speed;  // force per metre and speed
  if (g) {
    const Vec3 half = (0.5 * step.length * per_speed) * w;
    *g << half, half;
  }
  if (hess) {
    Mat3 block = per_speed * Mat3::Identity();
    if (speed > 0.0) block += (p.quadratic / speed * w) * w.transpose();
    block *= step.length / (4.0 * step.h);
    *hess << block, block, block, block;
  }
  return step.h * step.length * speed * speed * (0.5 * p.linear + p.quadratic * speed / 3.0);
}

AirDrag::AirDrag(const Model& model) : model_(&model) {
  if (!model.effects.air_drag) return;
  const AirDragEffect& effect = *model.effects.air_drag;
  const double diameter = 2.0 * model.yarn.radius_m;
  parameters_ = {effect.linear_ns_per_m2,
                 effect.quadratic_ns2_per_m3.value_or(0.5 * kAirDensity * kCylinderDragFactor * diameter)};
  for_each_owned_segment(model.topology, [&](int, int i) {
    const auto c = segment_coords(model.topology, i);
    coords_.push_back({c[0], c[1], c[2], c[4], c[5], c[6]});
    arc_coord_.push_back(c[3]);
  });
  length_.resize(coords_.size());
  start_.resize(coords_.size(), Vec3::Zero());
}

void AirDrag::begin_step(const StepContext& step) {
  if (coords_.empty()) return;
  h_ = step.h;
  air_ = air_velocity(model_->effects, step.end_t());
  const VecX& near = *step.near_q;
  for (std::size_t k = 0; k < coords_.size(); ++k) {
    start_[k] = step.measured(Vec3(Vec3::Zero()), [&](const VecX& q) {
      return Vec3(q.segment<3>(coords_[k][0]) + q.segment<3>(coords_[k][3]));
    });
    length_[k] = near[arc_coord_[k] + 1] - near[arc_coord_[k]];
  }
}

}  // namespace slipstitch
