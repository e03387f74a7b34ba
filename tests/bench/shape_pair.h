// One pair of random shapes of a kind, at a signed distance of a class.
#pragma once

#include <array>

#include "bench/distance_class.h"
#include "scene/random.h"
#include "support/pairs/set_numbers.h"

namespace dgd_bench {

/// The types of both sets of a pair.
struct ShapeKind {
  const char* key;  ///< On the command line, in tables and in files.
  dgd_test::SetType type_1, type_2;
  bool takes_margin;  ///< The others are drawn without: capsules have radii of their own.
};

/// The one list of kinds.
inline constexpr std::array kShapeKinds = {
    ShapeKind{"hulls", dgd_test::SetType::kPolytope, dgd_test::SetType::kPolytope, true},
    ShapeKind{"boxes", dgd_test::SetType::kBox, dgd_test::SetType::kBox, true},
    ShapeKind{"capsule-hull", dgd_test::SetType::kSegment, dgd_test::SetType::kPolytope, false},
    ShapeKind{"capsules", dgd_test::SetType::kSegment, dgd_test::SetType::kSegment, false},
    ShapeKind{"cylinders", dgd_test::SetType::kCylinder, dgd_test::SetType::kCylinder, true},
    ShapeKind{"cones", dgd_test::SetType::kCone, dgd_test::SetType::kCone, false},
    ShapeKind{"ellipsoids", dgd_test::SetType::kEllipsoid, dgd_test::SetType::kEllipsoid, false},
    ShapeKind{"cylinder-hull", dgd_test::SetType::kCylinder, dgd_test::SetType::kPolytope, true},
};

/// Of all shapes, about; of hulls, the greatest distance of two vertices. Metres.
inline constexpr double kShapeSize = 1.0;

struct ShapePair {
  dgd_test::PairNumbers sets;
  dgd_test::PoseNumbers last_pose_2;  ///< 1 % of the size and 0.01 rad away: where a warm start comes from.
};

/// Two shapes in random orientations, the second one moved along a random direction until their signed distance is one
/// drawn from the class, to 1e-9 m.
/// @param margin  Of each set, m, added to its core; unused if the kind takes none.
ShapePair DrawShapePair(dgd_demos::Random& random, const ShapeKind& kind, const DistanceClass& distance_class,
                        double margin);

}  // namespace dgd_bench
