// The one place where the two types of a pair are resolved. Free of Bullet, as all that is compiled once.
#pragma once

#include <algorithm>
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
constexpr std::size_t IndexAmong(std::type_identity<std::variant<Sets...>>) {
  std::size_t index = 0;
  static_cast<void>(((!std::is_same_v<Set, Sets> && ++index > 0) && ...));
  return index;
}
/// Of an alternative of ShapeSet.
template <class Set>
constexpr std::size_t kIndex = IndexAmong<Set>(std::type_identity<ShapeSet>());

/// Calls ask(set_a, set_b, settings). A shape that only Bullet can evaluate, and what meets it, go through a function
/// pointer, and the tolerance is raised to what its rounding allows. So do two in the order that callers avoid, since
/// they would be compiled a second time.
template <class Ask>
decltype(auto) VisitPair(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                         Ask&& ask) {
  return std::visit(
      [&]<class SetA, class SetB>(const SetA& set_a, const SetB& set_b) {
        if constexpr (kIsErased<SetA> || kIsErased<SetB> || kIndex < SetA >> kIndex<SetB>) {
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
