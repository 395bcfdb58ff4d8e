// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// Yarn against yarn that is no neighbour: gap_energy() of every two points, one on each of two segments, at most a
/// radius apart along them at rest, with gap = |x - y| - d. A sum over both yarns, after Kaldor, James and Marschner,
/// "Simulating knitted cloth at the yarn level", ACM TOG 27(3), 2008, 4.3. Points up to 2.6 radii apart, as on a
/// segment that has taken in yarn, leave no hole for yarn to pass through.
///
/// d = 2R, but no more than the distance of the two segments at the start of the scene: a relaxed fabric feels nothing,
/// though its drawn yarns overlap. Segments that share a node, or whose nodes a segment joins, never touch here: their
/// contacts hold them.
class SelfCollision {
 public:
  static constexpr int kSize = 12;
  static constexpr std::string_view kName = "self_collision";

  explicit SelfCollision(const Model& model);
  int size() const { return static_cast<int>(pairs_.size()); }
  std::array<int, kSize> coords(int k) const;
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext& step);

  long revision() const { return revision_; }
  /// Takes in as stencils the pairs that the way from q to q + a dq could bring together. They carry no energy at q.
  void watch(const VecX& q, const VecX& dq, double a);
  /// Largest share <= a of that way on which nothing passes through. Only after `watch` of the same way.
  double max_step(const VecX& q, const VecX& dq, double a) const;
  /// Moves yarn out of yarn that handles have moved from q0 into it, as far as handles allow.
  void push_out(const VecX& q0, VecX& q);

 private:
  struct Segment {
    std::array<int, 6> coords;   // x0, x1
    int pieces = 1;              // with a point in the middle of each; for ever, or a rest could become forbidden
    std::array<bool, 2> held{};  // by handles, at either end
  };
  struct Pair {
    int a = 0, b = 0;  // segments
    int pieces_a = 1, pieces_b = 1;
    double distance = 0.0;  // d
  };
  void find_neighbours(const Topology& topology);
  bool neighbours(const Segment& a, const Segment& b) const;
  double contact_distance(const Segment& a, const Segment& b) const;
  Eigen::AlignedBox3d swept_box(const Segment& segment, const VecX& q, const VecX& dq) const;
  bool push_apart(const Pair& pair, VecX& q) const;
  bool add_pair(int a, int b);
  template <class F>
  void for_each_point_pair(const Pair& pair, F&& f) const;
  double room(const Pair& pair) const { return pair.distance - depth(pair); }
  double depth(const Pair& pair) const;

  double radius_ = 0.0, k_ = 0.0;
  VecX start_q_;
  std::vector<Segment> segments_;
  std::vector<std::vector<int>> joined_;  // per node: nodes that a segment joins to it, ascending, itself too
  std::vector<Pair> pairs_;
  std::unordered_map<long, int> pair_index_;
  long revision_ = 0;
};
static_assert(ForceTerm<SelfCollision>);

}  // namespace slipstitch
