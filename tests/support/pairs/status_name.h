// What a status is called where a failing case is printed.
#pragma once

#include "dgd/growth_distance.h"

namespace dgd_test {

inline const char* NameOf(dgd::Status status) {
  static constexpr const char* kNames[] = {"optimal",  "separated",          "colliding",
                                           "touching", "coincident centers", "iteration limit",
                                           "stalled",  "no interior",        "invalid input"};
  return kNames[static_cast<int>(status)];
}

}  // namespace dgd_test
