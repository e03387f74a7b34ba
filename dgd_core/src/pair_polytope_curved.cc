#include "pair_solver.h"

namespace dgd {

DGD_INSTANTIATE_QUERIES(, PolytopeSet, CurvedSet)

}  // namespace dgd
