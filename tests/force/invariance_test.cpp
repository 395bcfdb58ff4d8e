// SPDX-License-Identifier: MIT
#include "terms_under_test.h"

namespace slipstitch::testing {
namespace {

// Weight and dead loads act in a given direction, inertia and drag against a given motion.
template <class T>
constexpr bool kKnowsSpace = T::kName == "gravity" || T::kName == "inertia" || T::kName == "dead_load" ||
                             T::kName == "air_drag" || T::kName == "colliders" || T::kName == "collider_friction" ||
                             T::kName == "body_inertia" || T::kName == "body_gravity";
// The surface that a point slides on is that of the start of the step.
template <class T>
constexpr bool kKnowsDirection = kKnowsSpace<T> || T::kName == "body_friction";
// These compare arc length with its value at the start of the step or with an anchor.
template <class T>
constexpr bool kKnowsArcOrigin =
    T::kName == "inertia" || T::kName == "sliding_friction" || T::kName == "damping_sliding";

template <class T>
class Invariance : public ::testing::Test {};
TYPED_TEST_SUITE(Invariance, Terms, TermNames);

constexpr int kNumPositions = 27;  // coordinates of the clasped yarns and their sphere that are positions

struct Evaluated {
  const Sample& s;
  VecX g;
  MatX hess;
  double V;

  explicit Evaluated(const Sample& sample) : s(sample) { V = s.energy(s.q, &g, &hess); }

  bool is_position(Eigen::Index i) const { return s.coords[static_cast<std::size_t>(i)] < kNumPositions; }
  bool starts_position(Eigen::Index i) const {
    return is_position(i) && s.coords[static_cast<std::size_t>(i)] % 3 == 0;
  }
  double unit() const { return 8 * static_cast<double>(s.q.size()) * kEpsilon; }
  // Rounding of the energy and of the gradient when coordinates of size `size` are rounded.
  double energy_noise(double size) const {
    const double rounded = unit() * size;
    return unit() * std::abs(V) + rounded * (g.norm() + rounded * hess.norm());
  }
  double gradient_noise(double size) const { return unit() * (g.norm() + hess.norm() * size); }
};

// The sample with every position moved keeps its energy.
void expect_same_energy(const Evaluated& e, const std::function<Vec3(const Vec3&)>& move) {
  VecX q = e.s.q;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (e.starts_position(i)) q.segment<3>(i) = move(q.segment<3>(i));
  }
  EXPECT_NEAR(e.s.energy(q, nullptr, nullptr), e.V, e.energy_noise(e.s.q.norm() + q.norm()));
}

void expect_translation_invariant(const Sample& s) {
  const Evaluated e(s);
  expect_same_energy(e, [](const Vec3& x) { return Vec3(x + Vec3(2e-3, -3e-3, 1e-3)); });
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < s.q.size(); ++i) {
    if (e.starts_position(i)) sum += e.g.segment<3>(i);
  }
  EXPECT_LE(sum.norm(), e.gradient_noise(s.q.norm()));
}

void expect_rotation_invariant(const Sample& s) {
  const Evaluated e(s);
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -2) / 3).toRotationMatrix();
  expect_same_energy(e, [&](const Vec3& x) { return Vec3(turn * x); });
  Vec3 torque = Vec3::Zero();
  for (Eigen::Index i = 0; i < s.q.size(); ++i) {
    if (e.starts_position(i)) torque += Vec3(s.q.segment<3>(i)).cross(Vec3(e.g.segment<3>(i)));
  }
  EXPECT_LE(torque.norm(), e.gradient_noise(s.q.norm()) * s.q.norm());
}

void expect_arc_origin_free(const Sample& s) {
  const Evaluated e(s);
  VecX q = s.q;
  double sum = 0.0;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (e.is_position(i)) continue;
    q[i] += 5e-3;
    sum += e.g[i];
  }
  EXPECT_NEAR(s.energy(q, nullptr, nullptr), e.V, e.energy_noise(s.q.norm() + q.norm()));
  EXPECT_LE(std::abs(sum), e.gradient_noise(s.q.norm()));
}

TYPED_TEST(Invariance, TranslationChangesNoEnergyAndForcesSumToZero) {
  if constexpr (!kKnowsSpace<TypeParam>) for_each_sample<TypeParam>(expect_translation_invariant);
}

TYPED_TEST(Invariance, RotationChangesNoEnergyAndTorquesSumToZero) {
  if constexpr (!kKnowsDirection<TypeParam>) for_each_sample<TypeParam>(expect_rotation_invariant);
}

TYPED_TEST(Invariance, OriginOfArcLengthDoesNotMatter) {
  if constexpr (!kKnowsArcOrigin<TypeParam>) for_each_sample<TypeParam>(expect_arc_origin_free);
}

}  // namespace
}  // namespace slipstitch::testing
