// What dgd_core/include/dgd/convex_set.h asks of a core, checked for one core against the same set as plain numbers.
//
// The checks ask a core as the soak does (pairs/erased_core.h), and are compiled once for each scalar and dimension.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"
#include "support/pairs/erased_core.h"
#include "support/random.h"
#include "support/reference_set.h"

namespace dgd_test {

/// The directions that decide: axes, face diagonals, space diagonals, with both signs of zero, then random ones.
std::vector<Eigen::Vector3d> Directions(Random& random);

/// The set that a core should be, by its support function alone; metres.
template <int L>
struct ExpectedSet {
  /// Largest <direction, x> for a unit direction.
  std::function<double(const dgd::Vector<double, L>&)> height;
  double extent = 0;  ///< Largest distance of two points, at least and at most twice that.
  double reach = 0;   ///< Largest length among the numbers that the core is made of, and the extent.
};

ExpectedSet<3> Expected(const ReferenceSet& reference);

/// The hull of points.
template <int L>
ExpectedSet<L> ExpectedHull(const std::vector<dgd::Vector<double, L>>& points) {
  ExpectedSet<L> expected;
  for (const auto& point : points) {
    expected.extent = std::max(expected.extent, 2 * (point - points[0]).norm());
    expected.reach = std::max({expected.reach, expected.extent, point.norm()});
  }
  expected.height = [points](const dgd::Vector<double, L>& direction) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const auto& point : points) highest = std::max(highest, direction.dot(point));
    return highest;
  };
  return expected;
}

/// A core of any type, and which of the concepts of convex_set.h its type is.
template <class S, int L>
struct CoreUnderTest {
  using Vector = dgd::Vector<S, L>;

  std::shared_ptr<const CoreQuestions<S, L>> core;
  bool has_vertices, has_pieces, has_faces, takes_hints;
  /// The supporting face; of cores in space.
  std::function<void(const Vector& direction, dgd::SupportingFace<S>& face)> support_face;
  /// Of a CenteredCore, else empty: a copy whose centre has been moved near to a point.
  std::function<CoreUnderTest(const Vector& point)> with_center_near;
};

template <dgd::CertifiableCore Core, class S = typename Core::Scalar, int L = dgd::kDimension<Core>>
CoreUnderTest<S, L> UnderTest(const Core& core) {
  using Vector = dgd::Vector<S, L>;
  static_assert(!(dgd::VertexCore<Core> && dgd::SmoothCore<Core>), "features are either");
  CoreUnderTest<S, L> under_test{.core = std::make_shared<CoreAnswers<Core>>(core),
                                 .has_vertices = dgd::VertexCore<Core>,
                                 .has_pieces = dgd::SmoothCore<Core>,
                                 .has_faces = dgd::FacedCore<Core>,
                                 .takes_hints = dgd::HintedCore<Core>,
                                 .support_face = {},
                                 .with_center_near = {}};
  if constexpr (L == 3) {
    under_test.support_face = [core](const Vector& direction, dgd::SupportingFace<S>& face) {
      core.SupportFace(direction, face);
    };
  }
  if constexpr (dgd::CenteredCore<Core>) {
    under_test.with_center_near = [core](const Vector& point) {
      Core moved = core;
      moved.MoveCenterNear(point);
      return UnderTest(moved);
    };
  }
  return under_test;
}

/// Checks all that a core of these concepts promises. S is float or double, L is 2 or 3.
/// @param discretisation  Metres that a supporting face may be lower than the core: the part that a polygon takes off a
///                        disc.
template <class S, int L>
void CheckContract(const CoreUnderTest<S, L>& under_test, const ExpectedSet<L>& expected, double discretisation);

template <class Core>
void CheckExpected(const Core& core, const ExpectedSet<dgd::kDimension<Core>>& expected, double discretisation = 0) {
  CheckContract(UnderTest(core), expected, discretisation);
}

template <class Core>
void CheckShape(const Core& core, const ReferenceSet& reference, double discretisation = 0) {
  CheckExpected(core, Expected(reference), discretisation);
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
