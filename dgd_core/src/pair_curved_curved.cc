#include "pair_solver_definitions.h"

namespace dgd {

template struct PairSolver<CurvedSet, CurvedSet>;

}  // namespace dgd
