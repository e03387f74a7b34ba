#include "pair_solver_definitions.h"

namespace dgd {

template struct PairSolver<CustomSet, CustomSet>;

}  // namespace dgd
