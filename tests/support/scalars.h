// The scalars that typed tests run with.
#pragma once

#include <gtest/gtest.h>

namespace dgd_test {

/// With sanitizers double alone, where not all is built: they look at the same lines, and float takes as long again.
#ifdef DGD_TEST_ONE_SCALAR
using Scalars = ::testing::Types<double>;
#else
using Scalars = ::testing::Types<double, float>;
#endif

}  // namespace dgd_test
