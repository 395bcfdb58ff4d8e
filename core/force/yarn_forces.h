// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <type_traits>

#include "force/air_drag.h"
#include "force/bending.h"
#include "force/bending_jamming.h"
#include "force/body_contact.h"
#include "force/body_friction.h"
#include "force/body_gravity.h"
#include "force/body_inertia.h"
#include "force/collider_contact.h"
#include "force/collider_friction.h"
#include "force/contact_length.h"
#include "force/damping.h"
#include "force/dead_load.h"
#include "force/force_list.h"
#include "force/gravity.h"
#include "force/inertia.h"
#include "force/parallel_contact.h"
#include "force/self_collision.h"
#include "force/sliding_friction.h"
#include "force/stretch.h"
#include "force/wrapping.h"

namespace slipstitch {

/// The one list of force terms. Whatever stands here is assembled, tested and reported.
using YarnForces =
    std::tuple<Inertia, Gravity, Stretch, Bending, BendingJamming, Wrapping, ContactLength, ParallelContact,
               SlidingFriction, DampingStretch, DampingBending, DampingWrapping, DampingSliding, AirDrag, DeadLoad,
               ColliderContact, ColliderFriction, SelfCollision, BodyInertia, BodyGravity, BodyContact, BodyFriction>;

inline constexpr std::size_t kNumTerms = std::tuple_size_v<YarnForces>;

inline YarnForces make_forces(const Model& model) { return make_list<YarnForces>(model); }

/// Terms whose energy is stored and can be given back or dissipated no further: the potential energy of the yarn.
template <class Term>
inline constexpr bool kIsPotential =
    !(std::is_same_v<Term, Inertia> || std::is_same_v<Term, SlidingFriction> || std::is_same_v<Term, DampingStretch> ||
      std::is_same_v<Term, DampingBending> || std::is_same_v<Term, DampingWrapping> ||
      std::is_same_v<Term, DampingSliding> || std::is_same_v<Term, AirDrag> || std::is_same_v<Term, ColliderFriction> ||
      std::is_same_v<Term, BodyInertia> || std::is_same_v<Term, BodyFriction>);

}  // namespace slipstitch
