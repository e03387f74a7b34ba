#include "bench/make_speed_pair.h"
#include "bench/speed_pair_3d.h"

namespace dgd_bench {

std::unique_ptr<SpeedPair<3>> MakePrimitivePair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using enum dgd_test::SetType;
  return MakeOf<3, TypeList<kPoint, kSegment, kBox, kCylinder, kCone, kFrustum, kEllipsoid>>(set_1, set_2);
}

}  // namespace dgd_bench
