// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "collide/near_segments.h"
#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// Yarn against yarn that is no neighbour: gap_energy() of every two points, one on each of two segments, at most a
/// radius apart along them at rest, with gap = |x - y| - d. A sum over both yarns, after Kaldor, James and Marschner,
/// "Simulating knitted cloth at the yarn level", ACM TOG 27(3), 2008, 4.3. Points up to 2.6 radii apart, as on a
/// segment that has taken in yarn, leave no hole for yarn to pass through. Where a segment gets new points that begin
/// too deep in other yarn, that the old ones let in, its d with that is less at first, and grows back step by step.
///
/// Within three courses and wales, and within an arc of pi R of one yarn or across a node of two (the shortest way
/// round between points 2R apart), d = min(2R, distance of the two segments in the relaxed fabric as placed at the
/// start): it feels nothing, though its drawn yarns overlap. Everywhere else d = 2R. Strangers that overlap at the
/// start all the same, as in a scene that starts folded, keep that distance for ever, as the energy knows no deeper
/// overlap than R/10; start_overlaps() counts them. Segments that share a node, or whose nodes a segment joins, never
/// touch here: their contacts hold them.
///
/// Nothing passes through: a pair is a stencil before any move that could bring it to d, and max_step() keeps its
/// points from each other. What bounds the cost: NearSegments searches boxes anew only once segments have moved by half
/// a radius against each other; between searches a move costs a sum of three numbers for every pair found, and an exact
/// distance where those allow a touch. Stencils stay until they are mostly idle, so that the matrix seldom changes
/// shape.
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
  long search_bytes() const;
  long searches() const { return near_.searches(); }
  /// Takes in as stencils the pairs that the way from q to q + a dq could bring together. They carry no energy at q.
  void watch(const VecX& q, const VecX& dq, double a);
  /// Largest share <= a of that way on which nothing passes through. Only after `watch` of the same way.
  double max_step(const VecX& q, const VecX& dq, double a) const;
  bool outgrown(const VecX& q) const;
  /// Whether points pass each other on the way from q0 to q: come as near as half of d.
  bool passes(const VecX& q0, const VecX& q);
  /// Pairs of segments that overlap at the start and are no neighbours in pattern or yarn; handles may hold one of
  /// them.
  int start_overlaps() const { return start_overlaps_; }
  /// Moves yarn out of yarn that handles have moved from q0 into it, as far as handles allow.
  void push_out(const VecX& q0, VecX& q);

 private:
  struct Segment {
    int visit = 0;
    std::array<int, 6> coords;   // x0, x1
    int arc_coord = 0;           // of u0; u1 is the next
    double sampled = 0.0;        // length of yarn that its points were last chosen for [m]
    std::array<bool, 2> held{};  // by handles, at either end
  };
  struct Pair {
    int a = 0, b = 0;  // segments
    int pieces_a = 1, pieces_b = 1;
    double distance = 0.0;  // d
  };
  void find_neighbours(const Topology& topology);
  void find_start_distances(const Model& model);
  bool neighbours(const Segment& a, const Segment& b) const;
  std::vector<std::array<int, 6>> segment_ends() const;
  bool can_touch(int a, int b) const;
  double contact_distance(int a, int b) const;
  long key(int a, int b) const { return static_cast<long>(a) * static_cast<long>(segments_.size()) + b; }
  static double length_of(const Segment& segment, const VecX& q);  // of its yarn, stretched [m]
  bool follow(const VecX& q);
  void renew_points(const VecX& q, const std::vector<char>& changed);
  void tighten(const VecX& q);
  double closest_points(const Pair& pair, const VecX& q) const;
  int pieces(const Segment& segment, double distance) const;
  void forget_pairs();
  void drop_idle(const VecX& q);
  Pair pair_of(int a, int b, double touch) const;
  bool push_apart(const Pair& pair, const VecX& q0, VecX& q) const;
  template <class F>
  void for_each_point_pair(const Pair& pair, F&& f) const;
  double room(const Pair& pair) const { return pair.distance - depth(pair); }
  double depth(const Pair& pair) const;

  double radius_ = 0.0, k_ = 0.0;
  std::vector<Segment> segments_;
  std::vector<std::vector<int>> joined_;  // per node: nodes that a segment joins to it, ascending, itself too
  std::unordered_map<long, double> start_distance_;  // by key(): d of pairs with d < 2R
  std::unordered_map<long, double> slack_;           // by key(): of pairs with less than their d for now
  double tightened_at_ = -1.0;                       // time of start [s]; -1: never
  int start_overlaps_ = 0;
  NearSegments near_;
  std::vector<Pair> pairs_;
  std::unordered_set<long> taken_;  // keys of pairs_
  long revision_ = 0;
};
static_assert(ForceTerm<SelfCollision>);

}  // namespace slipstitch
