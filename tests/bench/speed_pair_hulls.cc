#include "bench/make_speed_pair.h"
#include "bench/speed_pair_3d.h"

namespace dgd_bench {

std::unique_ptr<SpeedPair<3>> MakeHullPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using enum dgd_test::SetType;
  // As they meet in scenes.
  using WithPolytope = TypeAndPartners<kPolytope, kPolytope, kPoint, kSegment, kBox, kCylinder, kCone>;
  return MakeOf<3, WithPolytope, TypeList<kMesh>, TypeList<kDsf>>(set_1, set_2);
}

}  // namespace dgd_bench
