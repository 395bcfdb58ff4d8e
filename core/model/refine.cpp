// SPDX-License-Identifier: MIT
#include "model/refine.h"

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

void clear_visits(Topology& topology) {
  topology.yarn_first.clear();
  topology.visit_node.clear();
  topology.visit_slides.clear();
  topology.visit_owned.clear();
  topology.segment_kind.clear();
}

void push_visit(const Topology& coarse, int i, int piece, Refined& refined) {
  Topology& fine = refined.topology;
  refined.coarse_visit.push_back(i);
  refined.piece.push_back(piece);
  fine.visit_node.push_back(piece == 0 ? coarse.visit_node[idx(i)] : fine.num_nodes++);
  fine.visit_slides.push_back(piece == 0 ? coarse.visit_slides[idx(i)] : 0);
  if (!coarse.visit_owned.empty()) fine.visit_owned.push_back(coarse.visit_owned[idx(i)]);
  fine.segment_kind.push_back(coarse.segment_kind[idx(i)]);
  fine.visit_extra.push_back(piece == 0 ? 0 : 1);
}

}  // namespace

Refined refine(const Topology& coarse, int extra) {
  Refined refined;
  refined.topology = coarse;
  Topology& fine = refined.topology;
  clear_visits(fine);
  std::vector<int> fine_visit(idx(coarse.num_visits()));
  for (int y = 0; y < coarse.num_yarns(); ++y) {
    fine.yarn_first.push_back(fine.num_visits());
    for (int i = coarse.yarn_first[idx(y)]; i < coarse.yarn_first[idx(y) + 1]; ++i) {
      fine_visit[idx(i)] = fine.num_visits();
      const int pieces = coarse.segment_kind[idx(i)] == SegmentKind::free ? extra : 0;
      for (int piece = 0; piece <= pieces; ++piece) push_visit(coarse, i, piece, refined);
    }
  }
  fine.yarn_first.push_back(fine.num_visits());
  fine.rest_arc = along(refined, coarse.rest_arc, extra);
  for (StitchContact& contact : fine.contacts)
    for (auto* visits : {&contact.u_visit, &contact.v_visit})
      for (int& visit : *visits) visit = fine_visit[idx(visit)];
  return refined;
}

std::vector<double> along(const Refined& refined, const std::vector<double>& coarse, int extra) {
  std::vector<double> fine;
  for (std::size_t j = 0; j < refined.piece.size(); ++j) {
    const std::size_t i = idx(refined.coarse_visit[j]);
    const double share = refined.piece[j] / (extra + 1.0);
    fine.push_back(refined.piece[j] == 0 ? coarse[i] : (1.0 - share) * coarse[i] + share * coarse[i + 1]);
  }
  return fine;
}

}  // namespace slipstitch
