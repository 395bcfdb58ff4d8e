// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "collide/rigid_body.h"
#include "force/gap_energy.h"
#include "force/term.h"
#include "force/touch_parts.h"

namespace slipstitch {

/// Yarn against rigid bodies, at points along it: gap = distance of the centreline to the surface, less the radius.
/// No accepted step leaves a point deeper than a tenth of the radius, or, new among points that let a body between
/// them, than it began. Between points an edge reaches deeper: a third of a radius, or a whole one where yarn grows
/// quickly.
///
/// The stencils are the pairs that can touch within the step, and those that a move could bring to touch later.
class ColliderContact {
 public:
  static constexpr int kSize = 6;
  static constexpr std::string_view kName = "colliders";

  struct Pair {
    int sample = 0, body = 0;
    bool operator==(const Pair&) const = default;
  };

  explicit ColliderContact(const Model& model) : ColliderContact(model, touch_parts(model)) {}
  ColliderContact(const Model& model, SharedTouchParts parts);
  int size() const { return static_cast<int>(pairs_.size()); }
  std::array<int, kSize> coords(int k) const { return sample_of(k).coords; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext& step);
  const SharedTouchParts& parts() const { return parts_; }

  /// Changes whenever begin_step changes the stencils.
  long revision() const { return revision_; }
  long search_bytes() const;
  long searches() const { return searches_; }
  /// Takes in as stencils the pairs that the way from q to q + a dq could bring together. They carry no energy at q.
  void watch(const VecX& q, const VecX& dq, double a);
  /// Largest share <= a of that way on which nothing passes into a body. Only after `watch` of the same way.
  double max_step(const VecX& q, const VecX& dq, double a) const;
  bool outgrown(const VecX& q) const;
  /// Moves points out of bodies that have moved over them, as far as handles allow, and no farther than need be.
  void push_out(const VecX& q0, VecX& q) const;

  const TouchSample& sample(int i) const { return parts_->samples[i]; }
  const RigidBody& body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
  const std::vector<Pair>& pairs() const { return pairs_; }
  double gap(const Pair& pair, const VecX& q) const;
  double normal_force(const Pair& pair, const VecX& q) const;  // [N], >= 0

 private:
  double touching(int i) const { return radius_ - sample(i).slack; }  // distance at which sample i does [m]
  void look_around(int s, const Vec3& x, double reach);
  const TouchSample& sample_of(int k) const { return sample(pairs_[static_cast<std::size_t>(k)].sample); }
  double keep_apart(const Pair& pair, const VecX& q, const VecX& dq, double a) const;
  bool push_out_once(std::span<const RigidBody> before, const VecX& q0, VecX& q) const;

  SharedTouchParts parts_;
  double radius_, depth_, k_;      // [m], [m], [N]
  std::vector<char> held_;         // per node: a handle moves it
  std::vector<RigidBody> bodies_;  // where they are at the end of the step
  std::vector<Pair> pairs_;
  std::vector<double> clear_;  // per sample: least gap to the bodies it is not paired with [m]
  std::vector<Vec3> start_;    // per sample: where that was so [m]
  std::vector<char> paired_;   // per sample and body
  double start_t_ = 0.0;       // of the step [s]
  long revision_ = 0, searches_ = 0;
};
static_assert(ForceTerm<ColliderContact>);

}  // namespace slipstitch
