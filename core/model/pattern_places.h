// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "model/topology.h"

namespace slipstitch {

/// Where the segments of a topology lie in its pattern and along its yarns.
class PatternPlaces {
 public:
  explicit PatternPlaces(const Topology& topology);

  /// Whether segments i and j lie at most `reach` courses and at most `reach` wales apart, around a tube too. A segment
  /// lies in the stitches of its first visit; turns and tails lie where the stitch before them is. False for bare
  /// yarns.
  bool near_in_pattern(int i, int j, int reach) const;

  /// Whether less than `arc` [m] of yarn at rest lies between segments i and j, along one yarn or over one node that
  /// two visits share.
  bool near_on_yarn(int i, int j, double arc) const;

 private:
  struct Place {  // the stitches that have a node: courses and wales, both ends included
    std::array<int, 2> course{0, -1}, wale{0, -1};
    bool empty() const { return course[1] < course[0]; }
    void add(const Stitch& stitch);
  };
  void find_places();
  void extend_along_yarns();
  int wales_apart(const Place& a, const Place& b) const;
  double arc_to_visit(int segment, int visit) const;

  const Topology& topology_;                // outlives this
  std::vector<int> yarn_;                   // (num_visits)
  std::vector<Place> place_;                // (num_visits)
  std::vector<std::array<int, 2>> shared_;  // visits of one node
  bool round_ = false;                      // the yarn goes straight on from the last wale to the first
};

}  // namespace slipstitch
