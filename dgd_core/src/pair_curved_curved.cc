#include "pair_solver.h"

namespace dgd {

DGD_INSTANTIATE_QUERIES(, CurvedSet, CurvedSet)

}  // namespace dgd
