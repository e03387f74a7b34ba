#include "support/shape_contract.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dgd/solver/tolerances.h"

namespace dgd_test {
namespace {

/// Random ones.
int DirectionCount() { return TestCount(500, 60); }

/// As Directions(), in the plane.
std::vector<Eigen::Vector2d> PlaneDirections(Random& random) {
  std::vector<Eigen::Vector2d> directions;
  for (const double x : {-1.0, -0.0, 0.0, 1.0}) {
    for (const double y : {-1.0, -0.0, 0.0, 1.0}) {
      const Eigen::Vector2d direction(x, y);
      if (direction.norm() > 0) directions.push_back(direction.normalized());
    }
  }
  for (int i = 0; i < DirectionCount(); ++i) {
    const double angle = random.Uniform(0, 2 * std::numbers::pi);
    directions.emplace_back(std::cos(angle), std::sin(angle));
  }
  return directions;
}

template <int L>
std::vector<dgd::Vector<double, L>> DirectionsOf(Random& random) {
  if constexpr (L == 2) {
    return PlaneDirections(random);
  } else {
    return Directions(random);
  }
}

/// Lengths of a core of this extent, and of the numbers it is made of, are right to this; metres.
template <class S, int L>
double Rounding(const ExpectedSet<L>& expected) {
  return 8 * double(dgd::kEpsilon<S>) * expected.reach;
}

/// The point of the named piece is the support point; and see CheckPieces().
template <class S, int L>
void CheckPieceOf(const CoreQuestions<S, L>& core, const dgd::Vector<S, L>& direction,
                  const dgd::SupportPoint<S, L>& support, double tolerance) {
  ASSERT_LT(support.feature, core.FeatureCount());
  const auto piece = core.FeatureSupport(support.feature, direction);
  EXPECT_LE(double((piece.point - support.point).norm()), tolerance) << direction.transpose();
}

/// The support point is a point of the core and none is farther along the direction.
template <class S, int L>
void CheckSupport(const CoreUnderTest<S, L>& under_test, const ExpectedSet<L>& expected, Random& random) {
  const CoreQuestions<S, L>& core = *under_test.core;
  using VectorS = dgd::Vector<S, L>;
  const double tolerance = Rounding<S>(expected);
  for (const auto& direction : DirectionsOf<L>(random)) {
    for (const double length : {1.0, 1e-3, 1e5}) {
      const VectorS scaled = (length * direction).template cast<S>();
      const dgd::SupportPoint<S, L> support = core.Support(scaled);
      const dgd::Vector<double, L> unit = scaled.template cast<double>().normalized();
      ASSERT_TRUE(support.point.allFinite());
      EXPECT_NEAR(unit.dot(support.point.template cast<double>()), expected.height(unit), tolerance)
          << direction.transpose() << " times " << length;
      EXPECT_NEAR(double(core.SupportValue(scaled)) / scaled.template cast<double>().norm(), expected.height(unit),
                  tolerance)
          << direction.transpose() << " times " << length;
      EXPECT_LE(double(core.Distance(support.point)), tolerance) << direction.transpose();
      if (under_test.has_vertices) {
        ASSERT_LT(support.feature, core.FeatureCount());
        EXPECT_EQ(support.point, core.FeatureSupport(support.feature, scaled).point);
      } else if (under_test.has_pieces) {
        CheckPieceOf(core, scaled, support, tolerance);
      } else {
        EXPECT_EQ(support.feature, dgd::kNoFeature);
      }
    }
  }
  const dgd::SupportPoint<S, L> any = core.Support(VectorS::Zero());
  EXPECT_LE(double(core.Distance(any.point)), tolerance);
  EXPECT_EQ(core.SupportValue(VectorS::Zero()), S(0));
  if (under_test.has_pieces) CheckPieceOf(core, VectorS(VectorS::Zero()), any, tolerance);
}

/// Central difference of a piece's support point, column by column.
template <class S, int L>
dgd::SquareMatrix<double, L> CentralDifference(const CoreQuestions<S, L>& core, dgd::FeatureId piece,
                                               const dgd::Vector<double, L>& direction, double step) {
  dgd::SquareMatrix<double, L> difference;
  for (int axis = 0; axis < L; ++axis) {
    dgd::Vector<double, L> ahead = direction, behind = direction;
    ahead[axis] += step;
    behind[axis] -= step;
    const dgd::Vector<S, L> moved = core.FeatureSupport(piece, ahead.template cast<S>()).point -
                                    core.FeatureSupport(piece, behind.template cast<S>()).point;
    difference.col(axis) = moved.template cast<double>() / (2 * step);
  }
  return difference;
}

/// Every piece's point is the core's, for every direction; and the derivative, where there is one, is symmetric,
/// positive semidefinite, 0 along the direction, inversely proportional to its length, and how the point moves.
template <class S, int L>
void CheckPieces(const CoreQuestions<S, L>& core, const ExpectedSet<L>& expected, Random& random) {
  const double epsilon = double(dgd::kEpsilon<S>);
  int compared = 0;
  for (const auto& direction : DirectionsOf<L>(random)) {
    const dgd::Vector<S, L> d = direction.template cast<S>();
    for (dgd::FeatureId piece = 0; piece < core.FeatureCount(); ++piece) {
      const dgd::CurvedPoint<S, L> curved = core.FeatureSupport(piece, d);
      ASSERT_TRUE(curved.point.allFinite());
      EXPECT_LE(double(core.Distance(curved.point)), Rounding<S>(expected)) << direction.transpose();
      if (!curved.derivative.allFinite()) continue;
      const dgd::SquareMatrix<double, L> derivative = curved.derivative.template cast<double>();
      const double size = derivative.norm(), rounding = 64 * epsilon * (size + expected.reach);
      EXPECT_LE((derivative - derivative.transpose()).norm(), rounding);
      EXPECT_LE((derivative * direction).norm(), rounding) << direction.transpose();
      const Eigen::SelfAdjointEigenSolver<dgd::SquareMatrix<double, L>> eigen(derivative);
      EXPECT_GE(eigen.eigenvalues().minCoeff(), -rounding) << direction.transpose();
      const auto doubled = core.FeatureSupport(piece, 2 * d).derivative;
      EXPECT_LE(double((2 * doubled - curved.derivative).norm()), rounding) << direction.transpose();
      // Two steps: where they differ, the derivative itself changes over the step, and about so much is unknown; where
      // by much, the difference tells nothing.
      const double step = std::cbrt(epsilon);
      const auto fine = CentralDifference(core, piece, direction, step);
      const auto coarse = CentralDifference(core, piece, direction, 2 * step);
      const double unknown = (coarse - fine).norm();
      if (unknown > 0.1 * fine.norm()) continue;
      ++compared;
      EXPECT_LE((fine - derivative).norm(), 2e-3 * size + 3 * unknown + Rounding<S>(expected) / step)
          << direction.transpose() << " piece " << piece << "\n"
          << derivative << "\n"
          << fine;
    }
  }
  EXPECT_GT(compared, DirectionCount() / 2);
}

/// Where a piece bounds a disc, the disc's plane is the core's supporting one, and its rim and centre are the core's.
template <class S>
void CheckFaces(const CoreQuestions<S, 3>& core, const ExpectedSet<3>& expected) {
  const double tilt = std::sqrt(double(dgd::kEpsilon<S>));
  const double rounding = Rounding<S>(expected), rounding_around = rounding + 16 * tilt * expected.reach;
  for (dgd::FeatureId piece = 0; piece < core.FeatureCount(); ++piece) {
    const dgd::FlatDisc<S> face = core.Face(piece);
    const Eigen::Vector3d normal = face.normal.template cast<double>(), center = face.center.template cast<double>();
    if (normal.isZero(0)) continue;
    EXPECT_NEAR(normal.norm(), 1, 4 * double(dgd::kEpsilon<S>)) << "piece " << piece;
    EXPECT_NEAR(normal.dot(center), expected.height(normal), rounding) << "piece " << piece;
    constexpr int kTurns = 12;
    for (int turn = 0; turn < kTurns; ++turn) {
      const double angle = 0.1 + 2 * std::numbers::pi * turn / kTurns;
      const Eigen::Vector3d first = normal.unitOrthogonal();
      const Eigen::Vector3d way = std::cos(angle) * first + std::sin(angle) * normal.cross(first);
      const Eigen::Vector3d rim = center + double(face.radius) * way;
      EXPECT_LE(double(core.Distance(rim.template cast<S>())), rounding) << "piece " << piece;
      const Eigen::Vector3d direction = normal + tilt * way;
      const Eigen::Vector3d point =
          core.FeatureSupport(piece, direction.template cast<S>()).point.template cast<double>();
      EXPECT_LE((point - rim).norm(), rounding_around) << "piece " << piece;
    }
  }
}

/// Any hint gives a point as high as none.
template <class S, int L>
void CheckHints(const CoreQuestions<S, L>& core, const ExpectedSet<L>& expected, Random& random) {
  for (const auto& direction : DirectionsOf<L>(random)) {
    const dgd::FeatureId any = static_cast<dgd::FeatureId>(random.Below(1000));
    for (const dgd::FeatureId hint : {dgd::FeatureId(0), dgd::kNoFeature, any}) {
      const auto point = core.Support(direction.template cast<S>(), hint).point;
      EXPECT_NEAR(direction.dot(point.template cast<double>()), expected.height(direction), Rounding<S>(expected))
          << direction.transpose() << " from " << hint;
    }
  }
}

/// The ball about the centre lies inside: no supporting plane is nearer than the inradius.
template <class S, int L>
void CheckCenter(const CoreQuestions<S, L>& core, const ExpectedSet<L>& expected, Random& random) {
  const dgd::Vector<S, L> center = core.Center();
  EXPECT_LE(double(core.Distance(center)), Rounding<S>(expected));
  ASSERT_GE(core.Inradius(), S(0));
  for (const auto& direction : DirectionsOf<L>(random)) {
    const double to_plane = expected.height(direction) - direction.dot(center.template cast<double>());
    EXPECT_GE(to_plane, double(core.Inradius()) - Rounding<S>(expected)) << direction.transpose();
  }
}

/// Wherever it is moved, the centre keeps the ball about it inside, and comes no farther from the point than it was.
template <class S, int L>
void CheckMovedCenter(const CoreUnderTest<S, L>& under_test, const ExpectedSet<L>& expected, Random& random) {
  const dgd::Vector<S, L> center = under_test.core->Center();
  for (const double distance : {0.0, 0.3, 1.0, 30.0}) {
    const dgd::Vector<double, L> offset = distance * expected.extent * random.UnitVector().template head<L>();
    const dgd::Vector<S, L> point = center + offset.template cast<S>();
    const CoreUnderTest<S, L> moved = under_test.with_center_near(point);
    CheckCenter(*moved.core, expected, random);
    EXPECT_LE(double((moved.core->Center() - point).norm()),
              double((center - point).norm()) + Rounding<S>(expected) * (1 + distance));
  }
}

/// From a support point outwards along its normal, the distance is the length of the way; and inside it is 0.
template <class S, int L>
void CheckDistance(const CoreQuestions<S, L>& core, const ExpectedSet<L>& expected, Random& random) {
  const dgd::Vector<S, L> center = core.Center();
  for (const auto& direction : DirectionsOf<L>(random)) {
    const dgd::Vector<S, L> normal = direction.template cast<S>();
    const dgd::Vector<S, L> surface = core.Support(normal).point;
    for (const double part : {1e-3, 0.1, 3.0}) {
      const S way = static_cast<S>(part * (expected.extent + 0.01));
      const double rounding = 4 * Rounding<S>(expected) + 8 * double(dgd::kEpsilon<S>) * double(way);
      EXPECT_NEAR(double(core.Distance(surface + way * normal)), double(way), rounding) << direction.transpose();
    }
    const S inside = static_cast<S>(random.Uniform(0, 0.999));
    EXPECT_LE(double(core.Distance(center + inside * (surface - center))), Rounding<S>(expected));
  }
}

/// The face's points are the core's and reach the support height, but for `discretisation` metres, the part that a
/// polygon takes off a disc.
template <class S>
void CheckSupportFace(const CoreUnderTest<S, 3>& under_test, const ExpectedSet<3>& expected, double discretisation,
                      Random& random) {
  for (const Eigen::Vector3d& direction : Directions(random)) {
    dgd::SupportingFace<S> face;
    under_test.support_face(direction.template cast<S>(), face);
    ASSERT_GE(face.size, 1);
    ASSERT_LE(face.size, dgd::SupportingFace<S>::kMaxPoints);
    double highest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < face.size; ++i) {
      const dgd::Vector3<S>& point = face.points[static_cast<std::size_t>(i)];
      EXPECT_LE(double(under_test.core->Distance(point)), Rounding<S>(expected)) << direction.transpose();
      highest = std::max(highest, direction.dot(point.template cast<double>()));
    }
    EXPECT_GE(highest, expected.height(direction) - discretisation - Rounding<S>(expected))
        << direction.transpose() << "\nface of " << face.size << " points";
  }
}

}  // namespace

std::vector<Eigen::Vector3d> Directions(Random& random) {
  std::vector<Eigen::Vector3d> directions;
  for (const double x : {-1.0, -0.0, 0.0, 1.0}) {
    for (const double y : {-1.0, -0.0, 0.0, 1.0}) {
      for (const double z : {-1.0, -0.0, 0.0, 1.0}) {
        const Eigen::Vector3d direction(x, y, z);
        if (direction.norm() > 0) directions.push_back(direction.normalized());
      }
    }
  }
  for (int i = 0; i < DirectionCount(); ++i) directions.push_back(random.UnitVector());
  return directions;
}

ExpectedSet<3> Expected(const ReferenceSet& reference) {
  double reach = reference.Extent();
  for (const Eigen::Vector3d& point : reference.points) reach = std::max(reach, point.norm());
  return {[reference](const Eigen::Vector3d& direction) { return reference.Height(direction); }, reference.Extent(),
          reach};
}

template <class S, int L>
void CheckContract(const CoreUnderTest<S, L>& under_test, const ExpectedSet<L>& expected, double discretisation) {
  const CoreQuestions<S, L>& core = *under_test.core;
  Random random(TestSeed());
  CheckSupport(under_test, expected, random);
  CheckCenter(core, expected, random);
  if (under_test.has_pieces) CheckPieces(core, expected, random);
  if constexpr (L == 3) {
    if (under_test.has_faces) CheckFaces(core, expected);
  }
  if (under_test.takes_hints) CheckHints(core, expected, random);
  if (under_test.with_center_near) CheckMovedCenter(under_test, expected, random);
  CheckDistance(core, expected, random);
  if constexpr (L == 3) CheckSupportFace(under_test, expected, discretisation, random);
}

template void CheckContract(const CoreUnderTest<float, 2>&, const ExpectedSet<2>&, double);
template void CheckContract(const CoreUnderTest<double, 2>&, const ExpectedSet<2>&, double);
template void CheckContract(const CoreUnderTest<float, 3>&, const ExpectedSet<3>&, double);
template void CheckContract(const CoreUnderTest<double, 3>&, const ExpectedSet<3>&, double);

}  // namespace dgd_test
