#include "bench/make_speed_pair.h"
#include "bench/speed_pair_3d.h"

namespace dgd_bench {

std::unique_ptr<SpeedPair<3>> MakePrimitivePair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using Primitives = CoreList<dgd::Point<double>, dgd::Segment<double>, dgd::Box<double>, dgd::Cylinder<double>,
                              dgd::Cone<double>, dgd::Frustum<double>, dgd::Ellipsoid<double>>;
  return MakeOf<3, Primitives>(set_1, set_2);
}

}  // namespace dgd_bench
