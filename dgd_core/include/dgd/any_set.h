// A convex set of any shape, in double and in space, for which the library holds the solver compiled.
//
// growth_distance.h, signed_distance.h and time_of_impact.h are templates over the two sets: fast, and long to compile.
// The functions here are the same, compiled once for all shapes, whose types are resolved in the support functions.
// That costs a query 1 to 20 %, of boxes and spheres most: pairs through Bullet's dispatcher take 1 % longer than with
// every pair of types compiled (tests/bench/README.md). A set of another scalar or dimension, or of a user's own core
// with features, is the templates'.
#pragma once

#include <utility>
#include <variant>

#include "dgd/contact/facing_faces.h"
#include "dgd/contact/reference_face.h"
#include "dgd/convex_set.h"
#include "dgd/export.h"
#include "dgd/motion.h"
#include "dgd/query_types.h"
#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/custom_core.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/ellipsoid.h"
#include "dgd/shapes/frustum.h"
#include "dgd/shapes/half_space.h"
#include "dgd/shapes/one_of.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/polytope.h"
#include "dgd/shapes/segment.h"
#include "dgd/shapes/triangle.h"
#include "dgd/signed_distance.h"
#include "dgd/time_of_impact.h"
#include "dgd/types.h"

namespace dgd {

/// Cores of vertices.
using PolytopeCore =
    OneOf<Point<double>, Segment<double>, Triangle<double>, Box<double>, CoreReference<Polytope<double>>>;
/// Cores of smooth pieces.
using CurvedCore = OneOf<Cylinder<double>, Cone<double>, Frustum<double>, Ellipsoid<double>>;

/// core + ball(radius), of any shape. Hulls and custom cores are referred to, all others held by value.
class AnySet {
  using Variant = std::variant<RoundedSet<PolytopeCore>, RoundedSet<CurvedCore>, RoundedSet<CustomCore>>;

  template <class Core>
  static constexpr std::size_t kKind = std::convertible_to<Core, PolytopeCore> ? 0
                                       : std::convertible_to<Core, CurvedCore> ? 1
                                                                               : 2;

 public:
  /// @param set  As `RoundedSet{Box<double>(half_extents), 0.01}`, Sphere(1.0), or Capsule(0.2, 0.5).
  template <class Core>
  requires(std::convertible_to<Core, PolytopeCore> || std::convertible_to<Core, CurvedCore> ||
           std::same_as<Core, CustomCore>) AnySet(const RoundedSet<Core>& set)
      : set_(std::variant_alternative_t<kKind<Core>, Variant>{set.core, set.radius}) {}

  /// Calls visitor(const RoundedSet<Core>&), Core one of PolytopeCore, CurvedCore and CustomCore.
  template <class Visitor>
  decltype(auto) Visit(Visitor&& visitor) const {
    return std::visit(std::forward<Visitor>(visitor), set_);
  }

  /// The core's radius, metres.
  double Radius() const {
    return Visit([](const auto& set) { return double(set.radius); });
  }
  /// What the set is scaled about; own frame, metres.
  Vector3<double> Center() const {
    return Visit([](const auto& set) -> Vector3<double> { return set.core.Center(); });
  }
  /// Of the core, about the centre; metres.
  double CoreInradius() const {
    return Visit([](const auto& set) { return double(set.core.Inradius()); });
  }
  /// The farthest point of the core along a direction of any length; own frame, metres.
  Vector3<double> CoreSupport(const Vector3<double>& direction) const {
    return Visit([&](const auto& set) { return set.core.Support(direction).point; });
  }
  /// See CenteredCore; does nothing where the centre cannot be moved.
  void MoveCenterNear(const Vector3<double>& point) {
    std::visit(
        [&]<class Core>(RoundedSet<Core>& set) {
          if constexpr (CenteredCore<Core>) set.core.MoveCenterNear(point);
        },
        set_);
  }
  /// Relative roundoff of the support function beyond its scalar's: see InexactCore.
  double Accuracy() const {
    const auto* custom = std::get_if<RoundedSet<CustomCore>>(&set_);
    return custom != nullptr ? custom->core.Accuracy() : 0;
  }

  bool IsCustom() const { return std::holds_alternative<RoundedSet<CustomCore>>(set_); }
  /// The set, if its core is one of vertices, or one of smooth pieces; else null.
  const RoundedSet<PolytopeCore>* AsPolytope() const { return std::get_if<RoundedSet<PolytopeCore>>(&set_); }
  const RoundedSet<CurvedCore>* AsCurved() const { return std::get_if<RoundedSet<CurvedCore>>(&set_); }

 private:
  Variant set_;
};

/// As GrowthDistance() of growth_distance.h. Of a custom core, the tolerance is raised to its accuracy.
DGD_EXPORT Result<double> GrowthDistance(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                         const Pose<double>& pose_2, const Settings<double>& settings = {},
                                         WarmStart<double>* warm_start = nullptr);

/// As DetectCollision() of growth_distance.h.
DGD_EXPORT CollisionResult<double> DetectCollision(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                                   const Pose<double>& pose_2, const Settings<double>& settings = {},
                                                   WarmStart<double>* warm_start = nullptr);

/// As SignedDistance() of signed_distance.h.
DGD_EXPORT SignedDistanceResult<double> SignedDistance(const AnySet& set_1, const Pose<double>& pose_1,
                                                       const AnySet& set_2, const Pose<double>& pose_2,
                                                       const Result<double>& growth,
                                                       const WarmStart<double>* warm_start = nullptr,
                                                       const Settings<double>& settings = {},
                                                       WarmStart<double>* follow = nullptr);

/// As UpdateDistance() of signed_distance.h.
DGD_EXPORT SignedDistanceResult<double> UpdateDistance(const AnySet& set_1, const Pose<double>& pose_1,
                                                       const AnySet& set_2, const Pose<double>& pose_2,
                                                       const Settings<double>& settings, WarmStart<double>& state);

/// As UpdateOnReferenceFace() of reference_face.h.
DGD_EXPORT SignedDistanceResult<double> UpdateOnReferenceFace(const AnySet& set_1, const Pose<double>& pose_1,
                                                              const AnySet& set_2, const Pose<double>& pose_2,
                                                              const Settings<double>& settings,
                                                              double angular_tolerance, ReferenceSide holder,
                                                              WarmStart<double>& state, FacingFaces<double>& facing);

/// As FindFacingFaces() of facing_faces.h.
DGD_EXPORT void FindFacingFaces(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                const Pose<double>& pose_2, const Result<double>& result, double angular_tolerance,
                                FacingFaces<double>& facing);

/// As TimeOfImpact() of time_of_impact.h.
DGD_EXPORT TimeOfImpactResult<double> TimeOfImpact(const AnySet& set_1, const Motion<double>& motion_1,
                                                   const AnySet& set_2, const Motion<double>& motion_2,
                                                   const SweepSettings<double>& settings = {});

/// As GrowthDistance() of half_space_distance.h, and FindFacingFaces() of half_space_patch.h.
DGD_EXPORT Result<double> GrowthDistance(const AnySet& set, const Pose<double>& pose,
                                         const HalfSpace<double>& half_space, const Pose<double>& half_space_pose);
DGD_EXPORT FacingFaces<double> FindFacingFaces(const AnySet& set, const Pose<double>& pose,
                                               const HalfSpace<double>& half_space, const Result<double>& result);

}  // namespace dgd
