#include "bench/make_speed_pair.h"

namespace dgd_bench {

template <>
std::unique_ptr<SpeedPair<2>> MakeSpeedPair<2>(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using enum dgd_test::SetType;
  return MakeOf<2, TypeList<kCircle, kStadium, kRectangle, kEllipse, kPolygon>>(set_1, set_2);
}

}  // namespace dgd_bench
