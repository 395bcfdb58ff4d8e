// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/topology.h"

namespace slipstitch {

/// "course 3, wale 5 (left clasp)" of a stitch contact, or "bind-off".
std::string describe_contact(const Topology& topology, int contact);

/// The stitch contact of a visit, or "point 2 of yarn 0" where there is none.
std::string describe_visit(const Topology& topology, int yarn, int visit);

/// The same of a full coordinate: of the node's first visit, or "dynamic sphere 0".
std::string describe_coordinate(const Topology& topology, int coord);

}  // namespace slipstitch
