#include "support/pairs/make_set.h"

#include <utility>

#include "support/pairs/with_core.h"

namespace dgd_test {

template <class S, int L>
typename AnyPair<S, L>::Set MakeSet(const SetNumbers& set) {
  return WithCore<S, L>(set, [&](auto core) -> typename AnyPair<S, L>::Set {
    return dgd::RoundedSet{Erase(std::move(core)), static_cast<S>(set.radius)};
  });
}

template AnyPair<double, 3>::Set MakeSet<double, 3>(const SetNumbers& set);
template AnyPair<float, 3>::Set MakeSet<float, 3>(const SetNumbers& set);
template AnyPair<double, 2>::Set MakeSet<double, 2>(const SetNumbers& set);
template AnyPair<float, 2>::Set MakeSet<float, 2>(const SetNumbers& set);

}  // namespace dgd_test
