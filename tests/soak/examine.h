// One case, asked in all chosen ways, each answer checked against its certificate and against the others.
#pragma once

#include <string>

#include "soak/soak_case.h"
#include "support/pairs/tally.h"

namespace dgd_soak {

struct Modes {
  bool cold = true;
  bool warm = true;    ///< The motion, each frame from the last one's warm start.
  bool yes_no = true;  ///< The collision check against the growth distance.
};

/// What the soak asks with, beside the sets.
struct Query {
  Modes modes;
  /// Of optimal results in double; 0 for the library's. Float always takes the library's.
  double tolerance = 0;
};

/// Examines the case in scalar S, counts it in the tally, and says what is wrong: nothing if all is well.
template <class S>
std::string Examine(const SoakCase& soak_case, const Query& query, dgd_test::Tally& tally);

/// Every number of the case, the iterations, results and certificates of the ways it is asked: for --replay.
template <class S>
std::string Describe(const SoakCase& soak_case, const Query& query);

}  // namespace dgd_soak
