// The one place where the two types of a pair are resolved. Free of Bullet, as all that is compiled once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "dgd/query_types.h"
#include "posed_shape.h"

namespace dgd_bullet {

using ErasedSet = dgd::RoundedSet<SupportCore>;

template <class Set>
constexpr bool kIsErased = std::is_same_v<Set, ErasedSet>;

/// A set behind a function pointer; refers to it.
template <class Set>
ErasedSet Erase(const Set& set) {
  if constexpr (kIsErased<Set>) {
    return set;
  } else {
    return {SupportCore(set.core), set.radius};
  }
}
inline ErasedSet Erase(const ShapeSet& shape) {
  return std::visit([](const auto& set) { return Erase(set); }, shape);
}

template <class Set, class... Sets>
constexpr std::ptrdiff_t IndexAmong(std::type_identity<std::variant<Sets...>>) {
  const std::array is_set{std::is_same_v<Set, Sets>...};
  return std::find(is_set.begin(), is_set.end(), true) - is_set.begin();
}
/// As IsInOrder() says of two shapes with these sets.
template <class SetA, class SetB>
constexpr bool kIsInOrder =
    IndexAmong<SetA>(std::type_identity<ShapeSet>()) <= IndexAmong<SetB>(std::type_identity<ShapeSet>());

/// Calls ask(set_a, set_b, settings). A shape that only Bullet can evaluate, and what meets it, go through a function
/// pointer, and the tolerance is raised to what its rounding allows. So do two that are not in order, which would be
/// compiled a second time for what callers avoid.
template <class Ask>
decltype(auto) VisitPair(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                         Ask&& ask) {
  return std::visit(
      [&]<class SetA, class SetB>(const SetA& set_a, const SetB& set_b) {
        if constexpr (kIsErased<SetA> || kIsErased<SetB> || !kIsInOrder<SetA, SetB>) {
          const ErasedSet erased_a = Erase(set_a), erased_b = Erase(set_b);
          dgd::Settings<double> raised = settings;
          raised.relative_tolerance =
              std::max({settings.relative_tolerance, erased_a.core.Accuracy(), erased_b.core.Accuracy()});
          return ask(erased_a, erased_b, raised);
        } else {
          return ask(set_a, set_b, settings);
        }
      },
      shape_a.set, shape_b.set);
}

}  // namespace dgd_bullet
