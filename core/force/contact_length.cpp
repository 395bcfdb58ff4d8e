// SPDX-License-Identifier: MIT
#include "force/contact_length.h"

#include <algorithm>

namespace slipstitch {

double contact_length_energy(double k_l, double L, const Vec<2>& q, Vec<2>* g, Mat<2>* hess) {
  const double strain = (q[1] - q[0] - L) / L;
  if (g) *g << -k_l * strain, k_l * strain;
  if (hess) *hess << k_l / L, -k_l / L, -k_l / L, k_l / L;
  return 0.5 * k_l * L * strain * strain;
}

ContactLength::ContactLength(const Model& model) {
  const auto& effect = model.effects.contact_length;
  if (!effect) return;
  k_l_ = effect->stiffness_n.value_or(model.yarn.stretch_n);
  const Topology& topology = model.topology;
  for (const StitchContact& contact : topology.contacts) {
    if (!contact.owned) continue;
    for (const auto& visits : {contact.u_visit, contact.v_visit}) {
      const int first = std::min(visits[0], visits[1]);  // arc length may run against the contact's labels
      coords_.push_back({topology.arc_coord(first), topology.arc_coord(first + 1)});
      rest_.push_back(rest_length(topology, first));
    }
  }
}

}  // namespace slipstitch
