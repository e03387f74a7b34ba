// The scalars that typed tests run with.
#pragma once

#include <gtest/gtest.h>

namespace dgd_test {

using Scalars = ::testing::Types<double, float>;

}  // namespace dgd_test
