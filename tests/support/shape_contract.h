// What dgd_core/include/dgd/convex_set.h asks of a core, checked for one core against the same set as plain numbers.
//
// The checks see a core by its functions alone, and are compiled once for each scalar and dimension.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dgd/convex_set.h"
#include "dgd/supporting_face.h"
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

/// A core of either dimension by its functions: what the concepts of convex_set.h ask for. Those that a core has not
/// are empty.
template <class S, int L>
struct CoreFunctions {
  using Vector = dgd::Vector<S, L>;
  using Support = dgd::SupportPoint<S, L>;

  std::function<Support(const Vector&)> support;
  std::function<Vector()> center;
  std::function<S()> inradius;
  std::function<S(const Vector&)> support_value, distance;
  // VertexCore.
  std::function<Vector(dgd::VertexId)> vertex;
  std::function<dgd::VertexId()> vertex_count;
  // SmoothCore.
  std::function<dgd::CurvedPoint<S, L>(dgd::FeatureId, const Vector&)> piece_support;
  std::function<dgd::FeatureId()> piece_count;
  // FacedCore.
  std::function<dgd::FlatDisc<S>(dgd::FeatureId)> face;
  // HintedCore.
  std::function<Support(const Vector&, dgd::FeatureId)> support_near;
  // CenteredCore: a copy whose centre has been moved near to a point.
  std::function<CoreFunctions(const Vector&)> with_center_near;
  // Of all cores in space.
  std::function<void(const Vector&, dgd::SupportingFace<S>&)> support_face;
};

template <dgd::CertifiableCore Core, class S = typename Core::Scalar, int L = dgd::kDimension<Core>>
CoreFunctions<S, L> FunctionsOf(const Core& a_core) {
  using Vector = dgd::Vector<S, L>;
  const auto core = std::make_shared<const Core>(a_core);
  CoreFunctions<S, L> functions;
  functions.support = [core](const Vector& direction) { return core->Support(direction); };
  functions.center = [core] { return Vector(core->Center()); };
  functions.inradius = [core] { return core->Inradius(); };
  functions.support_value = [core](const Vector& direction) { return core->SupportValue(direction); };
  functions.distance = [core](const Vector& point) { return core->Distance(point); };
  if constexpr (dgd::VertexCore<Core>) {
    functions.vertex = [core](dgd::VertexId vertex) { return Vector(core->Vertex(vertex)); };
    functions.vertex_count = [core] { return core->VertexCount(); };
  }
  if constexpr (dgd::SmoothCore<Core>) {
    functions.piece_support = [core](dgd::FeatureId piece, const Vector& d) { return core->PieceSupport(piece, d); };
    functions.piece_count = [core] { return core->PieceCount(); };
  }
  if constexpr (dgd::FacedCore<Core>) functions.face = [core](dgd::FeatureId piece) { return core->Face(piece); };
  if constexpr (dgd::HintedCore<Core>) {
    functions.support_near = [core](const Vector& direction, dgd::FeatureId hint) {
      return core->Support(direction, hint);
    };
  }
  if constexpr (dgd::CenteredCore<Core>) {
    functions.with_center_near = [core](const Vector& point) {
      Core moved = *core;
      moved.MoveCenterNear(point);
      return FunctionsOf(moved);
    };
  }
  if constexpr (L == 3) {
    functions.support_face = [core](const Vector& direction, dgd::SupportingFace<S>& face) {
      core->SupportFace(direction, face);
    };
  }
  return functions;
}

/// Checks all that a core with these functions promises. S is float or double, L is 2 or 3.
/// @param discretisation  Metres that a supporting face may be lower than the core: the part that a polygon takes off a
///                        disc.
template <class S, int L>
void CheckContract(const CoreFunctions<S, L>& core, const ExpectedSet<L>& expected, double discretisation);

template <class Core>
void CheckExpected(const Core& core, const ExpectedSet<dgd::kDimension<Core>>& expected, double discretisation = 0) {
  CheckContract(FunctionsOf(core), expected, discretisation);
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
