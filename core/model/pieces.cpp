// SPDX-License-Identifier: MIT
#include "model/pieces.h"

#include <numeric>

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

/// What piece each yarn belongs to: the number of its first yarn.
std::vector<int> first_yarns(const Scene& scene, int num_yarns) {
  std::vector<int> first(idx(num_yarns));
  std::iota(first.begin(), first.end(), 0);
  for (const Crossing& crossing : scene.crossings) {
    const int a = first[idx(crossing.yarn_a)], b = first[idx(crossing.yarn_b)];
    for (int& yarn : first)
      if (yarn == a || yarn == b) yarn = std::min(a, b);
  }
  return first;
}

/// The yarns a selector takes nodes of: one, or all of them.
bool takes(const Selector& where, int yarn, int num_bare) {
  if (std::holds_alternative<AllNodes>(where)) return true;
  if (const auto* point = std::get_if<YarnPoint>(&where)) return point->yarn == yarn;
  return yarn == num_bare;  // stitches are the knit's
}

}  // namespace

std::vector<Piece> pieces_of(const Scene& scene) {
  const int num_bare = static_cast<int>(scene.yarns.size()), num_yarns = num_bare + (scene.knit ? 1 : 0);
  const std::vector<int> first = first_yarns(scene, num_yarns);
  std::vector<Piece> pieces;
  std::vector<int> number(idx(num_yarns), -1);
  for (int yarn = 0; yarn < num_yarns; ++yarn) {
    int& of_piece = number[idx(first[idx(yarn)])];
    if (of_piece < 0) {
      of_piece = static_cast<int>(pieces.size());
      pieces.emplace_back();
    }
    Piece& piece = pieces[idx(of_piece)];
    piece.yarns.push_back(yarn);
    for (const Handle& handle : scene.handles) piece.held |= takes(handle.where, yarn, num_bare);
    for (const Guide& guide : scene.guides) piece.held |= guide.yarn == yarn;
    piece.thrown |= yarn < num_bare && !scene.yarns[idx(yarn)].velocity_m_per_s.isZero(0.0);
    for (const InitialVelocity& start : scene.initial_velocities)
      piece.thrown |= takes(start.where, yarn, num_bare) && !start.velocity_m_per_s.isZero(0.0);
  }
  return pieces;
}

}  // namespace slipstitch
