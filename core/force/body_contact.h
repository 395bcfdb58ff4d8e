// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <vector>

#include "force/gap_energy.h"
#include "force/term.h"
#include "force/touch_parts.h"

namespace slipstitch {

/// Yarn against dynamic spheres, at points along it: as ColliderContact, but both sides move. Stencils are the points
/// that can touch: x0 and x1 of the yarn's segment, then the sphere's centre.
class BodyContact {
 public:
  static constexpr int kSize = 9;
  static constexpr std::string_view kName = "body_contact";

  struct Pair {
    int sample = 0, body = 0;  // of TouchParts::all_samples, of Model::bodies
    auto operator<=>(const Pair&) const = default;
  };

  explicit BodyContact(const Model& model) : BodyContact(model, touch_parts(model)) {}
  BodyContact(const Model& model, SharedTouchParts parts);
  int size() const { return static_cast<int>(pairs_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_of(pairs_[static_cast<std::size_t>(k)]); }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext& step);
  const SharedTouchParts& parts() const { return parts_; }

  long revision() const { return revision_; }
  long search_bytes() const;
  long searches() const { return searches_; }
  /// Takes in as stencils the pairs that the way from q to q + a dq could bring together. They carry no energy at q.
  void watch(const VecX& q, const VecX& dq, double a);
  /// Largest share <= a of that way on which nothing passes into a sphere. Only after `watch` of the same way.
  double max_step(const VecX& q, const VecX& dq, double a) const;
  bool outgrown(const VecX& q) const;
  /// Where handles have moved yarn from q0 into a sphere: moves what they leave free of it out, else the sphere.
  void push_out(const VecX& q0, VecX& q);

  const std::vector<Pair>& pairs() const { return pairs_; }
  const Body& body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
  std::array<int, kSize> coords_of(const Pair& pair) const;
  double share_of(const Pair& pair) const { return sample(pair).share; }
  Vec3 from_centre(const Pair& pair, const VecX& q) const;     // of the sphere to the point [m]
  double normal_force(const Pair& pair, const VecX& q) const;  // [N], >= 0

 private:
  const TouchSample& sample(const Pair& pair) const { return parts_->all_samples[pair.sample]; }
  double touching(const Pair& pair) const { return body(pair.body).radius_m + parts_->radius - sample(pair).slack; }
  bool push_apart(const Pair& pair, const VecX& q0, VecX& q) const;

  SharedTouchParts parts_;
  std::vector<Body> bodies_;
  std::vector<char> held_;  // per node: a handle moves it
  std::vector<Pair> pairs_;
  std::vector<char> paired_;  // per sample and body
  long revision_ = 0, searches_ = 0;
};
static_assert(ForceTerm<BodyContact>);

}  // namespace slipstitch
