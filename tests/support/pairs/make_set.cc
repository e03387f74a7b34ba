#include "support/pairs/make_set.h"

#include <utility>

#include "support/pairs/with_core.h"

namespace dgd_test {

template <class S, int L>
AnySet<S, L> MakeSet(const SetNumbers& set) {
  return WithCore<S, L>(set, [&](auto core) -> AnySet<S, L> {
    return dgd::RoundedSet{Erase(std::move(core)), static_cast<S>(set.radius)};
  });
}

template AnySet<double, 3> MakeSet<double, 3>(const SetNumbers& set);
template AnySet<float, 3> MakeSet<float, 3>(const SetNumbers& set);
template AnySet<double, 2> MakeSet<double, 2>(const SetNumbers& set);
template AnySet<float, 2> MakeSet<float, 2>(const SetNumbers& set);

}  // namespace dgd_test
