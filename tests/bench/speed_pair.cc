#include "bench/speed_pair.h"

#include <stdexcept>
#include <string>

#include "bench/speed_pair_3d.h"

namespace dgd_bench {

template <>
std::unique_ptr<SpeedPair<3>> MakeSpeedPair<3>(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  auto pair = MakePrimitivePair(set_1, set_2);
  if (pair == nullptr) pair = MakeHullPair(set_1, set_2);
  if (pair == nullptr) {
    throw std::invalid_argument(std::string("no benchmark of ") + dgd_test::InfoOf(set_1.type).name + " and " +
                                dgd_test::InfoOf(set_2.type).name);
  }
  return pair;
}

}  // namespace dgd_bench
