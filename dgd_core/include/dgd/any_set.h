// A convex set of any shape, in double and in space, for which the library has the solver compiled.
//
// growth_distance.h, signed_distance.h and time_of_impact.h are templates over the two sets: fast, and long to compile.
// The functions here do the same and are compiled once: the types of the shapes are resolved in the support functions.
// Pairs in Bullet's dispatcher take 1 % longer by that than with every pair of types compiled (dispatcher_replay);
// single queries 0 to 5 % for hulls and curved sets, 10 to 20 % for spheres, capsules and boxes. Sets of another scalar
// or dimension, and cores of a user's own that name their features, are for the templates.
#pragma once

#include <utility>
#include <variant>

#include "dgd/contact/facing_faces.h"
#include "dgd/convex_set.h"
#include "dgd/export.h"
#include "dgd/gradient.h"
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

/// Cores that are hulls of vertices.
using PolytopeCore =
    OneOf<Point<double>, Segment<double>, Triangle<double>, Box<double>, CoreReference<Polytope<double>>>;
/// Cores whose boundary is made of smooth pieces.
using CurvedCore = OneOf<Cylinder<double>, Cone<double>, Frustum<double>, Ellipsoid<double>>;

/// core + ball(radius), of any shape. It refers to the objects of hulls and custom cores, which must outlive it, and
/// has its own copy of all others.
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

  /// Radius of the ball that is added to the core, metres.
  double Radius() const {
    return Visit([](const auto& set) { return double(set.radius); });
  }
  /// The point that the set is scaled about; own frame, metres.
  Vector3<double> Center() const {
    return Visit([](const auto& set) -> Vector3<double> { return set.core.Center(); });
  }
  /// Radius of a ball about the centre inside the core; metres, 0 for flat cores.
  double CoreInradius() const {
    return Visit([](const auto& set) { return double(set.core.Inradius()); });
  }
  /// The farthest point of the core along a direction of any length; own frame, metres.
  Vector3<double> CoreSupport(const Vector3<double>& direction) const {
    return Visit([&](const auto& set) { return set.core.Support(direction).point; });
  }
  /// Whether MoveCenterNear() may move the centre.
  bool MovesCenter() const {
    return Visit([]<class Core>(const RoundedSet<Core>& set) {
      if constexpr (CenteredCore<Core>) return set.core.MovesCenter();
      return false;
    });
  }
  /// Moves the centre as near to a point as the core allows (CenteredCore, SharedCenteredCore); not at all for cones,
  /// frustums, ellipsoids, custom cores, and hulls that are neither flat nor long.
  /// @param point  Own frame, metres.
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
  /// The set, if its core is a PolytopeCore, or a CurvedCore; else null.
  const RoundedSet<PolytopeCore>* AsPolytope() const { return std::get_if<RoundedSet<PolytopeCore>>(&set_); }
  const RoundedSet<CurvedCore>* AsCurved() const { return std::get_if<RoundedSet<CurvedCore>>(&set_); }

 private:
  Variant set_;
};

/// GrowthDistance() of growth_distance.h. The tolerance of settings is raised to the accuracy of custom cores, here
/// and below. None of these functions allocates or throws, but for what a custom core's function does.
DGD_EXPORT Result<double> GrowthDistance(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                         const Pose<double>& pose_2, const Settings<double>& settings = {},
                                         WarmStart<double>* warm_start = nullptr);

/// DetectCollision() of growth_distance.h.
DGD_EXPORT CollisionResult<double> DetectCollision(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                                   const Pose<double>& pose_2, const Settings<double>& settings = {},
                                                   WarmStart<double>* warm_start = nullptr);

/// SignedDistance() of signed_distance.h.
DGD_EXPORT SignedDistanceResult<double> SignedDistance(const AnySet& set_1, const Pose<double>& pose_1,
                                                       const AnySet& set_2, const Pose<double>& pose_2,
                                                       const Result<double>& growth,
                                                       const WarmStart<double>* warm_start = nullptr,
                                                       const Settings<double>& settings = {},
                                                       WarmStart<double>* follow = nullptr);

/// SignedDistance() of signed_distance.h without a growth distance.
DGD_EXPORT SignedDistanceResult<double> SignedDistance(const AnySet& set_1, const Pose<double>& pose_1,
                                                       const AnySet& set_2, const Pose<double>& pose_2,
                                                       const Settings<double>& settings = {},
                                                       WarmStart<double>* follow = nullptr);

/// UpdateDistance() of signed_distance.h.
DGD_EXPORT SignedDistanceResult<double> UpdateDistance(const AnySet& set_1, const Pose<double>& pose_1,
                                                       const AnySet& set_2, const Pose<double>& pose_2,
                                                       const Settings<double>& settings, WarmStart<double>& state);

/// GrowthDistanceGradient() and SignedDistanceGradient() of gradient.h.
DGD_EXPORT Gradient<double> GrowthDistanceGradient(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                                   const Pose<double>& pose_2, const Result<double>& result);
DGD_EXPORT Gradient<double> SignedDistanceGradient(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                                   const Pose<double>& pose_2,
                                                   const SignedDistanceResult<double>& result);

/// FindFacingFaces() of facing_faces.h.
DGD_EXPORT void FindFacingFaces(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                const Pose<double>& pose_2, const Result<double>& result, FacingFaces<double>& facing);

/// TimeOfImpact() of time_of_impact.h.
DGD_EXPORT TimeOfImpactResult<double> TimeOfImpact(const AnySet& set_1, const Motion<double>& motion_1,
                                                   const AnySet& set_2, const Motion<double>& motion_2,
                                                   const SweepSettings<double>& settings = {});

/// GrowthDistance() of half_space_distance.h, and FindFacingFaces() of half_space_patch.h.
DGD_EXPORT Result<double> GrowthDistance(const AnySet& set, const Pose<double>& pose,
                                         const HalfSpace<double>& half_space, const Pose<double>& half_space_pose);
DGD_EXPORT FacingFaces<double> FindFacingFaces(const AnySet& set, const Pose<double>& pose,
                                               const HalfSpace<double>& half_space, const Result<double>& result);

}  // namespace dgd
