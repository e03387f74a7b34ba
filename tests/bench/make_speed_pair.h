// The pairs of types of MakeSpeedPair(); for its translation units, one for each dimension.
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "bench/typed_speed_pair.h"
#include "support/pairs/with_core.h"

namespace dgd_bench {

/// Types that all meet each other, in the order in which they come first in a pair.
template <class... Cores>
struct CoreList {
  template <class Core>
  static constexpr std::size_t PlaceOf() {
    std::size_t place = 0;
    const bool is_in_list = ((std::same_as<Core, Cores> || (++place, false)) || ...);
    return is_in_list ? place : sizeof...(Cores);
  }

  template <class Core1, class Core2>
  static constexpr bool kHasPair = PlaceOf<Core1>() <= PlaceOf<Core2>() && PlaceOf<Core2>() < sizeof...(Cores);
};

/// @tparam Lists  CoreList each.
template <int L, class... Lists>
std::unique_ptr<SpeedPair<L>> MakeOf(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using Made = std::unique_ptr<SpeedPair<L>>;
  return dgd_test::WithCore<double, L>(set_1, [&](auto core_1) -> Made {
    return dgd_test::WithCore<double, L>(set_2, [&](auto core_2) -> Made {
      using Core1 = std::remove_cvref_t<decltype(core_1)>;
      using Core2 = std::remove_cvref_t<decltype(core_2)>;
      if constexpr ((Lists::template kHasPair<Core1, Core2> || ...)) {
        return std::make_unique<TypedSpeedPair<Core1, Core2>>(core_1, set_1.radius, std::move(core_2), set_2.radius);
      } else if constexpr ((Lists::template kHasPair<Core2, Core1> || ...)) {
        return MakeOf<L, Lists...>(set_2, set_1);
      } else {
        throw std::invalid_argument("no benchmark of this pair of types");
      }
    });
  });
}

}  // namespace dgd_bench
