// From plain numbers to a set of any type behind one name.
#pragma once

#include "support/pairs/erased_core.h"
#include "support/pairs/set_numbers.h"

namespace dgd_test {

/// Throws std::invalid_argument for a type of another dimension.
template <class S, int L>
AnySet<S, L> MakeSet(const SetNumbers& set);

}  // namespace dgd_test
