// From plain numbers to a set of any type behind one name.
#pragma once

#include "support/pairs/any_pair.h"
#include "support/pairs/set_numbers.h"

namespace dgd_test {

/// Throws std::invalid_argument for a type of another dimension.
template <class S, int L>
typename AnyPair<S, L>::Set MakeSet(const SetNumbers& set);

}  // namespace dgd_test
