// SPDX-License-Identifier: MIT
#pragma once

#include "model/rest_cell.h"

namespace slipstitch {

/// Numbers and unplaced positions (x course, y wale, z right side) of a finished knit's nodes: base nodes stitch by
/// stitch (RestCell's order), then the bind-off's, the turns', the two tail ends.
///
/// Bind-off: a chain of clasps between neighbouring heads of the last course. The heads of wales w and w + 1 hook into
/// each other sideways over the wale boundary between them: nodes `bottom` and `top` of bind_off(w). The outermost
/// heads end in plain nodes, bind_off(0) and bind_off(wales).
class KnitLayout {
 public:
  KnitLayout(const Pattern& pattern, const RestCell& cell);

  int num_nodes() const { return tails_ + 2; }
  int base(int course, int wale, BaseNode node) const {
    return kNodesPerStitch * ((course - 1) * wales_ + wale - 1) + node;
  }
  int bind_off(int boundary, bool top) const { return bind_off_ + 2 * boundary + (top ? 1 : 0); }
  /// The two nodes in which a flat knit's yarn turns from `course` to the next one.
  int turn(int course, bool upper) const { return turns_ + 2 * (course - 1) + (upper ? 1 : 0); }
  int tail(bool end) const { return tails_ + (end ? 1 : 0); }
  /// Node k (geometric order) of a loop; heads of the last course are bind-off nodes.
  int loop_node(int course, int wale, int k) const;
  /// Whether yarn may slide through the node: it lies in a clasp.
  bool in_clasp(int node) const;

  const std::vector<Vec3>& positions() const { return position_; }
  /// Arc length over polyline length in the cell at rest.
  double rest_ratio() const { return rest_ratio_; }

 private:
  Vec3 plane_position(int course, int wale, BaseNode node) const;
  void place_bind_off();
  void place_turns();
  void place_tails();

  const RestCell& cell_;
  int courses_, wales_;
  bool in_the_round_;
  int bind_off_, turns_, tails_;
  double rest_ratio_ = 1.0;
  std::vector<Vec3> position_;
};

}  // namespace slipstitch
