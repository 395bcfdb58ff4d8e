// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "evaluation.h"
#include "force/yarn_forces.h"
#include "sample_models.h"

namespace slipstitch::testing {

template <class Tuple>
struct AsTypes;
template <class... T>
struct AsTypes<std::tuple<T...>> {
  using Types = ::testing::Types<T...>;
};
using Terms = AsTypes<YarnForces>::Types;

struct TermNames {
  template <class T>
  static std::string GetName(int) {
    return std::string(T::kName);
  }
};

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// One stencil of a term in one pose.
struct Sample {
  VecX q;
  std::vector<int> coords;
  Energy energy;
  std::function<void(const VecX&, MatX&)> convex_hessian;  // the Hessian itself where the term offers no other
  std::function<double(const VecX&, const VecX&)> stress;  // empty where the term has none
  std::function<void(const VecX&, double, MatX&)> hessian_at;
  double step = 0.0;                   // of Pose
  int order = 0;
};

/// Every stencil of the term of a model, at every sample pose that it does not forbid. At least one must act.
template <class Term>
void for_each_sample_of(const Model& model, const std::function<void(const Sample&)>& visit) {
  constexpr int N = Term::kSize;
  std::mt19937_64 random(7);
  const State start = state_at(model, model.start_q, random);
  Term term(model);
  term.begin_step(StepContext{1e-3, start});
  int acting = 0;
  for (const Pose& pose : sample_poses(model)) {
    for (int k = 0; k < term.size(); ++k) {
      const std::array<int, static_cast<std::size_t>(N)> coords = term.coords(k);
      Sample sample{VecX(N), {coords.begin(), coords.end()}, {}, {}, {}, {}, pose.step, pose.order};
      for (int i = 0; i < N; ++i) sample.q[i] = pose.q[coords[static_cast<std::size_t>(i)]];
      sample.energy = with_dynamic_size<N>(
          [&term, k](const Vec<N>& q, Vec<N>* g, Mat<N>* hess) { return term.eval(k, q, g, hess); });
      const double V = sample.energy(sample.q, nullptr, nullptr);
      if (!std::isfinite(V)) continue;
      acting += V != 0.0;
      sample.convex_hessian = [&term, k](const VecX& q, MatX& hess) {
        Mat<N> fixed;
        if constexpr (HasConvexHessian<Term>) term.convex_hessian(k, q, fixed);
        else term.eval(k, q, nullptr, &fixed);
        hess = fixed;
      };
      if constexpr (HasStress<Term>) {
        sample.stress = [&term, k](const VecX& q, const VecX& dq) { return term.stress(k, q, dq); };
        sample.hessian_at = [&term, k](const VecX& q, double stress, MatX& hess) {
          Mat<N> fixed;
          term.hessian_at(k, q, stress, fixed);
          hess = fixed;
        };
      }
      visit(sample);
    }
  }
  EXPECT_GE(acting, 10);
}

/// On the clasped yarns with every effect; of bending also without plasticity, which puts another energy in its place.
template <class Term>
void for_each_sample(const std::function<void(const Sample&)>& visit) {
  Model model = everything_on();
  for_each_sample_of<Term>(model, visit);
  if constexpr (std::is_same_v<Term, Bending>) {
    model.effects.plasticity.reset();
    for_each_sample_of<Term>(model, visit);
  }
}

}  // namespace slipstitch::testing
