#include "support/pairs/any_pair_bodies.h"

template class dgd_test::AnyPair<float, 2>;
