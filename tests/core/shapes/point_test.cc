#include "dgd/shapes/point.h"

#include "support/shape_contract.h"

namespace dgd_test {
namespace {

TEST(Point, Contract_HoldsInDoubleAndFloat) {
  const ReferenceSet reference{.type = CoreType::kPoint};
  CheckShape(dgd::Point<double>(), reference);
  CheckShape(dgd::Point<float>(), reference);
}

}  // namespace
}  // namespace dgd_test
