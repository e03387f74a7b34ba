// Cores that break their contract: a support function that gives no numbers, or points of no convex set. A query ends,
// and what it reports is finite unless its status says that there is no answer.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dgd/growth_distance.h"
#include "dgd/shapes/box.h"
#include "dgd/signed_distance.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

enum class Lie { kNaNOnOneSide, kNaNButAlongAxes, kNearest, kHuge };

/// A box but for the lie.
class LyingCore {
 public:
  using Scalar = double;

  explicit LyingCore(Lie lie) : lie_(lie) {}

  dgd::SupportPoint<double> Support(const Vector3d& direction) const {
    const Vector3d truth = box_.Support(direction).point;
    const Vector3d none = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    switch (lie_) {
      case Lie::kNaNOnOneSide:
        return {direction.x() > 0 ? none : truth};
      case Lie::kNaNButAlongAxes:
        return {(direction.array() == 0).count() == 2 ? truth : none};
      case Lie::kNearest:
        return {-truth};
      case Lie::kHuge:
        return {1e300 * truth};
    }
    return {truth};
  }
  Vector3d Center() const { return Vector3d::Zero(); }
  double Inradius() const { return 0.3; }

 private:
  Lie lie_;
  dgd::Box<double> box_{Vector3d(0.5, 0.4, 0.3)};
};

template <class Result>
bool IsFiniteOrInvalid(const Result& result) {
  return result.status == dgd::Status::kInvalidInput ||
         (result.normal.allFinite() && std::isfinite(result.separation) && result.witness_1.allFinite() &&
          result.witness_2.allFinite());
}

// Found by fuzz_solver: a signed distance of minus infinity, stalled; and a growth distance from no plane.
TEST(LyingCore, AnyPose_FiniteOrInvalid) {
  Random random(TestSeed());
  const dgd::RoundedSet honest{dgd::Box<double>({0.3, 0.2, 0.4}), 0.05};
  int invalid = 0;
  for (const Lie lie : {Lie::kNaNOnOneSide, Lie::kNaNButAlongAxes, Lie::kNearest, Lie::kHuge}) {
    for (const double radius : {0.0, 0.1}) {
      const dgd::RoundedSet liar{LyingCore(lie), radius};
      for (int i = 0; i < 500; ++i) {
        const dgd::Pose<double> pose_1{random.Rotation(), Vector3d::Zero()};
        const dgd::Pose<double> pose_2{random.Rotation(), random.Uniform(0, 2) * random.UnitVector()};
        dgd::WarmStart<double> start;
        const dgd::Result<double> growth = dgd::GrowthDistance(liar, pose_1, honest, pose_2, {}, &start);
        EXPECT_TRUE(IsFiniteOrInvalid(growth)) << "lie " << int(lie) << ", pose " << i;
        const auto distance = dgd::SignedDistance(liar, pose_1, honest, pose_2, growth, &start);
        EXPECT_TRUE(IsFiniteOrInvalid(distance)) << "lie " << int(lie) << ", pose " << i;
        invalid += distance.status == dgd::Status::kInvalidInput;
      }
    }
  }
  EXPECT_GT(invalid, 500);
}

}  // namespace
}  // namespace dgd_test
