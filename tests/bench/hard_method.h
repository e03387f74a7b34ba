// The methods that the hard cases are asked of, all made to answer one question: how far apart, along which normal?
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "support/pairs/set_numbers.h"

namespace dgd_bench {

/// What a method says of a pair.
struct HardAnswer {
  /// Metres, below 0 for overlap; and the unit vector from set 1 to set 2 along which that is. None if the method gave
  /// up: `reason` may say why.
  std::optional<double> distance = {};
  Eigen::Vector3d normal{0, 0, 0};
  std::string reason = {};
};

/// One method, made ready for one pair.
class HardQuery {
 public:
  HardQuery() = default;
  virtual ~HardQuery() = default;
  HardQuery(const HardQuery&) = delete;
  HardQuery& operator=(const HardQuery&) = delete;

  virtual HardAnswer Ask() const = 0;
};

/// Null if the method has no such set.
using MakeHardQuery = std::unique_ptr<HardQuery> (*)(const dgd_test::PairNumbers& pair);

/// The growth distance and from there the signed distance, cold.
std::unique_ptr<HardQuery> MakeSignedDistanceInDouble(const dgd_test::PairNumbers& pair);
std::unique_ptr<HardQuery> MakeSignedDistanceInFloat(const dgd_test::PairNumbers& pair);

/// Bullet's GJK and EPA, in the precision of the process; radii are its margins.
std::unique_ptr<HardQuery> MakeBulletHardQuery(const dgd_test::PairNumbers& pair);
bool IsBulletInDouble();

/// FCL's GJK and EPA, which are libccd's, in double. Radii are taken off the distance of the cores.
std::unique_ptr<HardQuery> MakeFclHardQuery(const dgd_test::PairNumbers& pair);

}  // namespace dgd_bench
