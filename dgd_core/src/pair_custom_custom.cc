#include "pair_solver.h"

namespace dgd {

DGD_INSTANTIATE_QUERIES(, CustomSet, CustomSet)

}  // namespace dgd
