#include "bench/make_speed_pair.h"
#include "bench/speed_pair_3d.h"

namespace dgd_bench {

std::unique_ptr<SpeedPair<3>> MakeHullPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  // As they meet in scenes.
  using WithPolytope =
      CoreAndPartners<dgd::Polytope<double>, dgd::Polytope<double>, dgd::Point<double>, dgd::Segment<double>,
                      dgd::Box<double>, dgd::Cylinder<double>, dgd::Cone<double>>;
  return MakeOf<3, WithPolytope, CoreList<dgd::Mesh<double>>, CoreList<dgd::Dsf<double>>>(set_1, set_2);
}

}  // namespace dgd_bench
