// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <limits>
#include <string_view>
#include <vector>

#include "math/types.h"
#include "model/state.h"

namespace slipstitch {

/// One of the known places that a solve starts from, with its weight.
struct Past {
  double weight = 1.0;
  const VecX* q = nullptr;  // [m] (num_coords)
  const VecX* p = nullptr;  // [kg m/s] (num_coords); not of measures
};

/// One solve of a step, constant during it. Every integrator (sim/integrate.cpp) is made of solves like implicit
/// Euler's: with q* and p* weighted sums of what is known, it finds q with
///   M (q - q*)/h = p* + h (dT/dq + F),
/// and a rate at its end is the change of what it measures, against a weighted sum of that, over h.
struct StepContext {
  double h = 0.0;                                     // of that equation [s]
  const State& start;                                 // last known state, from which contacts, friction and yield go on
  double duration = h;                                // from there to where the solve ends [s]
  std::vector<Past> past{{1.0, &start.q, &start.p}};  // what q* and p* are sums of; weights sum to 1
  std::vector<Past> rate_past = past;                 // likewise of what is measured, without p
  const VecX* near_q = &start.q;                      // where M and dT/dq are taken [m] (num_coords)
  const VecX* near_v = &start.v;                      // [m/s] (num_coords)

  /// q* or p*: the weighted sum of f(past), from `zero`.
  template <class T, class F>
  T sum(T zero, F&& f) const {
    for (const Past& known : past) zero += known.weight * f(known);
    return zero;
  }
  /// That of a measure f(q).
  template <class T, class F>
  T measured(T zero, F&& f) const {
    for (const Past& known : rate_past) zero += known.weight * f(*known.q);
    return zero;
  }
  double end_t() const { return start.t + duration; }
};

/// h before the first step: change costs nothing.
inline constexpr double kNoStepYet = std::numeric_limits<double>::infinity();

/// One effect: a pool of stencils, each a smooth function of kSize full coordinates. A pool whose effect is off is
/// empty. Energies in J; rate-dependent effects give the incremental potential of the step, so that minus its
/// gradient is the force at the end of the step.
template <class T>
concept ForceTerm = requires(T& term, const T& cterm, int k, const StepContext& step, const Vec<T::kSize>& q,
                             Vec<T::kSize>* g, Mat<T::kSize>* hess) {
  { T::kName } -> std::convertible_to<std::string_view>;
  { cterm.size() } -> std::same_as<int>;
  { cterm.coords(k) } -> std::convertible_to<std::array<int, T::kSize>>;  // full coordinates of stencil k
  { cterm.eval(k, q, g, hess) } -> std::same_as<double>;  // energy; exact gradient and Hessian where non-null
  { term.begin_step(step) } -> std::same_as<void>;        // lag what the step treats as constant
};

/// convex_hessian: the Hessian without what can be negative, positive semidefinite. A term without one has a Hessian
/// that never is indefinite.
template <class T>
concept HasConvexHessian = requires(const T& cterm, int k, const Vec<T::kSize>& q, Mat<T::kSize>& hess) {
  { cterm.convex_hessian(k, q, hess) } -> std::same_as<void>;
};

/// For V = f(s(q)): stress is f', extrapolated linearly from q by dq; hessian_at is f'' ds ds^T + stress dds.
template <class T>
concept HasStress = requires(const T& cterm, int k, const Vec<T::kSize>& q, double stress, Mat<T::kSize>& hess) {
  { cterm.stress(k, q, q) } -> std::same_as<double>;
  { cterm.hessian_at(k, q, stress, hess) } -> std::same_as<void>;
};

/// A term whose stencils change: revision() changes whenever it has dropped or replaced some. Those that it only adds
/// come last.
template <class T>
concept HasChangingStencils = requires(const T& cterm) {
  { cterm.revision() } -> std::same_as<long>;
};

/// A term that searches for its stencils among all that could be one.
template <class T>
concept SearchesStencils = requires(const T& cterm) {
  { cterm.search_bytes() } -> std::same_as<long>;  // of what it searches in
  { cterm.searches() } -> std::same_as<long>;      // up to now
};

/// A term that takes in stencils for a move before it is made.
template <class T>
concept WatchesMoves = requires(T& term, const VecX& q, double a) {
  { term.watch(q, q, a) } -> std::same_as<void>;  // from q by a dq
};

/// A term that some moves would carry into states it forbids, or past them.
template <class T>
concept LimitsMoves = requires(const T& cterm, const VecX& q, double a) {
  { cterm.max_step(q, q, a) } -> std::same_as<double>;  // largest share <= a of the way from q by dq
};

/// A term that a step could outgrow: whose points in a segment that touches something a long step has taken too far
/// apart.
template <class T>
concept CanBeOutgrown = requires(const T& cterm, const VecX& q) {
  { cterm.outgrown(q) } -> std::same_as<bool>;
};

/// A term that can tell whether something would pass something else on the straight way from q0 to q.
template <class T>
concept SeesPassing = requires(T& term, const VecX& q) {
  { term.passes(q, q) } -> std::same_as<bool>;
};

/// A term that can take q out of states that scripts have made forbidden on the way from q0.
template <class T>
concept PushesOut = requires(T& term, const VecX& q0, VecX& q) {
  { term.push_out(q0, q) } -> std::same_as<void>;
};

}  // namespace slipstitch
