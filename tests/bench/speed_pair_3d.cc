#include "bench/make_speed_pair.h"

namespace dgd_bench {

template <>
std::unique_ptr<SpeedPair<3>> MakeSpeedPair<3>(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using Primitives = CoreList<dgd::Point<double>, dgd::Segment<double>, dgd::Box<double>, dgd::Cylinder<double>,
                              dgd::Cone<double>, dgd::Frustum<double>, dgd::Ellipsoid<double>>;
  // As they meet in scenes.
  using WithPolytope =
      CoreAndPartners<dgd::Polytope<double>, dgd::Polytope<double>, dgd::Point<double>, dgd::Segment<double>,
                      dgd::Box<double>, dgd::Cylinder<double>, dgd::Cone<double>>;
  return MakeOf<3, Primitives, WithPolytope, CoreList<dgd::Mesh<double>>, CoreList<dgd::Dsf<double>>>(set_1, set_2);
}

}  // namespace dgd_bench
