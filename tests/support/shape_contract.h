// What dgd_core/include/dgd/convex_set.h asks of a core, checked for one core against the same set as plain numbers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "dgd/convex_set.h"
#include "dgd/supporting_face.h"
#include "support/any_set.h"
#include "support/random.h"
#include "support/reference_set.h"

namespace dgd_test {

inline constexpr int kDirections = 500;

/// The directions that decide: axes, face diagonals, space diagonals, with both signs of zero, then random ones.
inline std::vector<Eigen::Vector3d> Directions(Random& random) {
  std::vector<Eigen::Vector3d> directions;
  for (const double x : {-1.0, -0.0, 0.0, 1.0}) {
    for (const double y : {-1.0, -0.0, 0.0, 1.0}) {
      for (const double z : {-1.0, -0.0, 0.0, 1.0}) {
        const Eigen::Vector3d direction(x, y, z);
        if (direction.norm() > 0) directions.push_back(direction.normalized());
      }
    }
  }
  for (int i = 0; i < kDirections; ++i) directions.push_back(random.UnitVector());
  return directions;
}

/// Lengths of a core of this extent, and of the numbers it is made of, are right to this; metres.
template <class S>
double Rounding(const ReferenceSet& reference) {
  double reach = reference.Extent();
  for (const Eigen::Vector3d& point : reference.points) reach = std::max(reach, point.norm());
  return 8 * double(dgd::kEpsilon<S>) * reach;
}

/// The support point is a point of the core and none is farther along the direction.
template <class Core>
void CheckSupport(const Core& core, const ReferenceSet& reference, Random& random) {
  using S = typename Core::Scalar;
  const double tolerance = Rounding<S>(reference);
  for (const Eigen::Vector3d& direction : Directions(random)) {
    for (const double length : {1.0, 1e-3, 1e5}) {
      const dgd::Vector3<S> scaled = (length * direction).template cast<S>();
      const dgd::SupportPoint<S> support = core.Support(scaled);
      const Eigen::Vector3d unit = scaled.template cast<double>().normalized();
      ASSERT_TRUE(support.point.allFinite());
      EXPECT_NEAR(unit.dot(support.point.template cast<double>()), reference.Height(unit), tolerance)
          << direction.transpose() << " times " << length;
      EXPECT_LE(double(core.Distance(support.point)), tolerance) << direction.transpose();
      if constexpr (dgd::VertexCore<Core>) {
        ASSERT_LT(support.feature, core.VertexCount());
        EXPECT_EQ(support.point, dgd::Vector3<S>(core.Vertex(support.feature)));
      } else {
        EXPECT_EQ(support.feature, dgd::kNoFeature);
      }
    }
  }
  EXPECT_LE(double(core.Distance(core.Support(dgd::Vector3<S>::Zero()).point)), tolerance);
}

/// The ball about the centre lies inside: no supporting plane is nearer than the inradius.
template <class Core>
void CheckCenter(const Core& core, const ReferenceSet& reference, Random& random) {
  using S = typename Core::Scalar;
  const dgd::Vector3<S> center = core.Center();
  EXPECT_LE(double(core.Distance(center)), Rounding<S>(reference));
  ASSERT_GE(core.Inradius(), S(0));
  for (const Eigen::Vector3d& direction : Directions(random)) {
    const double to_plane = reference.Height(direction) - direction.dot(center.template cast<double>());
    EXPECT_GE(to_plane, double(core.Inradius()) - Rounding<S>(reference)) << direction.transpose();
  }
}

/// Wherever it is moved, the centre keeps the ball about it inside, and comes no farther from the point than it was.
template <dgd::CenteredCore Core>
void CheckMovedCenter(const Core& core, const ReferenceSet& reference, Random& random) {
  using S = typename Core::Scalar;
  for (const double distance : {0.0, 0.3, 1.0, 30.0}) {
    const Eigen::Vector3d offset = distance * reference.Extent() * random.UnitVector();
    const dgd::Vector3<S> point = core.Center() + offset.template cast<S>();
    Core moved = core;
    moved.MoveCenterNear(point);
    CheckCenter(moved, reference, random);
    EXPECT_LE(double((moved.Center() - point).norm()),
              double((core.Center() - point).norm()) + Rounding<S>(reference) * (1 + distance));
  }
}

/// From a support point outwards along its normal, the distance is the length of the way; and inside it is 0.
template <class Core>
void CheckDistance(const Core& core, const ReferenceSet& reference, Random& random) {
  using S = typename Core::Scalar;
  const dgd::Vector3<S> center = core.Center();
  for (const Eigen::Vector3d& direction : Directions(random)) {
    const dgd::Vector3<S> normal = direction.template cast<S>();
    const dgd::Vector3<S> surface = core.Support(normal).point;
    for (const double part : {1e-3, 0.1, 3.0}) {
      const S way = static_cast<S>(part * (reference.Extent() + 0.01));
      const double rounding = 4 * Rounding<S>(reference) + 8 * double(dgd::kEpsilon<S>) * double(way);
      EXPECT_NEAR(double(core.Distance(surface + way * normal)), double(way), rounding) << direction.transpose();
    }
    const S inside = static_cast<S>(random.Uniform(0, 0.999));
    EXPECT_LE(double(core.Distance(center + inside * (surface - center))), Rounding<S>(reference));
  }
}

/// The face's points are the core's and reach the support height, but for `discretisation` metres, the part that a
/// polygon takes off a disc.
template <class Core>
void CheckSupportFace(const Core& core, const ReferenceSet& reference, double discretisation, Random& random) {
  using S = typename Core::Scalar;
  for (const Eigen::Vector3d& direction : Directions(random)) {
    dgd::SupportingFace<S> face;
    core.SupportFace(direction.template cast<S>(), face);
    ASSERT_GE(face.size, 1);
    ASSERT_LE(face.size, dgd::SupportingFace<S>::kMaxPoints);
    double highest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < face.size; ++i) {
      const dgd::Vector3<S>& point = face.points[static_cast<std::size_t>(i)];
      EXPECT_LE(double(core.Distance(point)), Rounding<S>(reference)) << direction.transpose();
      highest = std::max(highest, direction.dot(point.template cast<double>()));
    }
    EXPECT_GE(highest, reference.Height(direction) - discretisation - Rounding<S>(reference))
        << direction.transpose() << "\nface of " << face.size << " points";
  }
}

template <class Core>
void CheckShape(const Core& core, const ReferenceSet& reference, double discretisation = 0) {
  Random random(TestSeed());
  CheckSupport(core, reference, random);
  CheckCenter(core, reference, random);
  if constexpr (dgd::CenteredCore<Core>) CheckMovedCenter(core, reference, random);
  CheckDistance(core, reference, random);
  CheckSupportFace(core, reference, discretisation, random);
}

/// Runs `make` and expects std::invalid_argument with `part` in its message.
template <class Make>
void ExpectRejected(Make make, const std::string& part) {
  try {
    (void)make();
    ADD_FAILURE() << "accepted; expected a message with \"" << part << "\"";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace dgd_test
