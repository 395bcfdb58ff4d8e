// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <type_traits>

#include "force/touch_parts.h"
#include "model/model.h"

namespace slipstitch {

template <class Term>
Term make_term(const Model& model, const SharedTouchParts& parts) {
  if constexpr (std::is_constructible_v<Term, const Model&, SharedTouchParts>) {
    return Term(model, parts);
  } else {
    return Term(model);
  }
}

template <class List>
List make_list(const Model& model) {
  const SharedTouchParts parts = touch_parts(model);
  return [&]<class... T>(std::type_identity<std::tuple<T...>>) {
    return List{make_term<T>(model, parts)...};
  }(std::type_identity<List>{});
}

template <class Term, class List>
inline constexpr bool kIsListed = false;
template <class Term, class... T>
inline constexpr bool kIsListed<Term, std::tuple<T...>> = (std::is_same_v<Term, T> || ...);

/// The term of a list; one without stencils where the list does not have it.
template <class Term, class List>
const Term& term_of(const List& list) {
  if constexpr (kIsListed<Term, List>) {
    return std::get<Term>(list);
  } else {
    static const Model nothing;
    static const Term empty(nothing);
    return empty;
  }
}

}  // namespace slipstitch
