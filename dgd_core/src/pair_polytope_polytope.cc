#include "pair_solver_definitions.h"

namespace dgd {

template struct PairSolver<PolytopeSet, PolytopeSet>;

}  // namespace dgd
