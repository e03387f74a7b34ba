#include "bench/make_speed_pair.h"

namespace dgd_bench {

template <>
std::unique_ptr<SpeedPair<2>> MakeSpeedPair<2>(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  return MakeOf<2, CoreList<dgd::Point<double, 2>, dgd::Segment<double, 2>, dgd::Box<double, 2>,
                            dgd::Ellipsoid<double, 2>, dgd::Polygon<double>>>(set_1, set_2);
}

}  // namespace dgd_bench
