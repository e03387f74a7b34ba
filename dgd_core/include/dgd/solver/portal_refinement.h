// Polytopes' queries without a frame: from a triangle that the ray passes through to the facet that it leaves by.
//
// It is the paper's simplex method (Alg. 2) on the three corners alone, in the world's coordinates. A step takes the
// corners' plane, a support point beyond it, and the one of three triangles with that point that the ray passes
// through: 0.6 of the time of a step of RayIntersection, which weighs and remembers as it goes. The last triangle alone
// is weighed; a thin or steep one is left to RayIntersection.
//
// With a radius the triangles are those of the cores, moved by it along their normal. Where the ray passes outside the
// last one, it leaves by the cylinder about an edge, or beyond that.
//
// A warm start begins where the last query ended. From frame to frame most pairs keep their facet, or leave by one
// nearby: where the ray passes outside, a point beyond the side that it crosses takes a corner's place. A cold start is
// portal_discovery.h's.
//
// Minkowski portal refinement (Snethen 2008, "XenoCollide: Complex Collision Made Simple") stops where a portal's plane
// is near enough to the surface. Here the facet that the ray leaves by is found, its height is bounded from both sides,
// and the portal is kept for the next frame.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/feature_exit.h"
#include "dgd/solver/portal_discovery.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class PortalRefinement {
 public:
  using Support = solver_internal::PortalSupport<Set1, Set2>;
  using Corner = typename Support::Corner;
  using Point = typename Support::Point;
  using S = typename Support::S;

  PortalRefinement(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2)
      : support_(set_1, pose_1, set_2, pose_2) {}
  PortalRefinement(const PortalRefinement&) = delete;
  PortalRefinement& operator=(const PortalRefinement&) = delete;

  /// Gives a cold start its first corner.
  /// @param support_1, support_2  Of the cores along the ray; their frames.
  void StartFrom(const SupportPoint<S>& support_1, const SupportPoint<S>& support_2) {
    discovery_.StartFrom(support_.CornerOf(support_1, support_2));
  }
  bool HasFastColdStart() const { return support_.HasFastColdStart(); }
  int Iterations() const { return support_.iterations; }

  /// Most evaluations of the support functions, and steps to neighbouring facets. With half as many, warm queries of
  /// hulls of 241 to 4516 vertices take 1.1 times as long; with twice as many, as long. Cold ones take 27 in one of a
  /// hundred queries if no points are looked up.
  static constexpr int kMaxWarmSteps = 8;
  static constexpr int kMaxColdSteps = 32;

  /// @param state  In and out: three points of a last query. If this fails, it names three to start from all the same.
  /// @return whether the result is optimal, or that the sets are separated by more than the limit; if not, it is of no
  ///         use.
  bool SolveWarm(const Settings<S>& settings, WarmStart<S>& state, Result<S>& result) {
    return RunWarm(settings, IsLimited(settings) ? EarlyOut::kApart : EarlyOut::kNever, state, result);
  }
  /// @param state  Out, or null.
  bool SolveCold(const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    return Report(IsLimited(settings) ? RunCold<EarlyOut::kApart>(settings) : RunCold<EarlyOut::kNever>(settings),
                  settings, state, result);
  }

  /// Whether the sets have a point in common.
  /// @return whether that is decided; if not, the result is of no use.
  bool SolveWarm(const Settings<S>& settings, WarmStart<S>& state, CollisionResult<S>& result) {
    return RunWarm(settings, EarlyOut::kDecided, state, result);
  }
  bool SolveCold(const Settings<S>& settings, WarmStart<S>* state, CollisionResult<S>& result) {
    if (state == nullptr) discovery_.NeedNoCorners();
    return Report(RunCold<EarlyOut::kDecided>(settings), settings, state, result);
  }

  /// Whether the last facet, or the one that the ray leaves by now, is one that RayIntersection has to weigh.
  bool EndedAtThinFacet() const { return ended_at_thin_facet_; }

 private:
  using Portal = solver_internal::Portal<S>;

  /// What ends a refinement before the ray leaves the difference.
  enum class EarlyOut {
    kNever,
    kApart,   ///< A plane separates the sets by more than the limit.
    kDecided  ///< A check is decided: a plane separates them, or the ray ends below the corners.
  };
  /// How it ended.
  enum class Termination {
    kExit,    ///< The ray leaves by these corners.
    kApart,   ///< The sets are apart by `apart_` along the last normal.
    kCommon,  ///< The ray ends below the corners, or at the common point.
    kNone     ///< It is not solved: the rest is left to RayIntersection.
  };

  static bool IsLimited(const Settings<S>& settings) {
    return settings.separation_limit < std::numeric_limits<S>::infinity();
  }

  static bool IsInRange(S length, S inradius) {
    return inradius > 0 && length > kCoincidence<S> * inradius && dgd::IsInRange(length, inradius);
  }

  template <class AnyResult>
  bool RunWarm(const Settings<S>& settings, EarlyOut early, WarmStart<S>& state, AnyResult& result) {
    const S inradius = support_.CoreInradius() + portal_.radius;
    if (!IsInRange(portal_.ray.norm(), inradius) || !support_.TakeCorners(state, portal_)) return false;
    const Termination end = early == EarlyOut::kNever   ? RunFromPortal<EarlyOut::kNever>(settings)
                            : early == EarlyOut::kApart ? RunFromPortal<EarlyOut::kApart>(settings)
                                                        : RunFromPortal<EarlyOut::kDecided>(settings);
    if (Report(end, settings, &state, result)) return true;
    portal_.Leave(state);
    return false;
  }

  template <EarlyOut kEarlyOut>
  Termination RunCold(const Settings<S>& settings) {
    const S inradius = support_.CoreInradius(), length = portal_.ray.norm();
    if (!(portal_.radius >= 0) || !IsInRange(length, inradius)) return Termination::kNone;
    const Point axis = portal_.ray / length;
    // Most sets that are separated by more than the limit are known to be after one direction.
    if (kEarlyOut == EarlyOut::kNever) support_.PlaceVertices();
    const Corner first = discovery_.FirstCorner(axis, support_.HasFastColdStart() && kEarlyOut != EarlyOut::kApart);
    if (kEarlyOut == EarlyOut::kApart) {
      const S apart = length - axis.dot(first.point) - portal_.radius;
      portal_.normal = axis;
      if (apart > settings.separation_limit) return TerminateApart(first, apart);
    }
    if (kEarlyOut != EarlyOut::kNever) support_.PlaceVertices();
    portal_.InitialPortal(inradius, axis);
    constexpr bool kIsCheck = kEarlyOut == EarlyOut::kDecided;
    const bool has_begun = discovery_.template Discover<kIsCheck>(axis, first);
    if (kIsCheck && discovery_.CommonPoint()) return Termination::kCommon;
    if (!has_begun) return Termination::kNone;
    portal_.normal = portal_.NormalOfCorners();
    return RefineToSurface<kEarlyOut>(settings, kMaxColdSteps);
  }

  /// Refines from corners that the ray may pass outside of.
  template <EarlyOut kEarlyOut>
  Termination RunFromPortal(const Settings<S>& settings) {
    portal_.FindPlane();
    ended_at_thin_facet_ = !portal_.IsWellConditioned();
    if (ended_at_thin_facet_) return Termination::kNone;
    const int exit_edge = portal_.FindExitEdge();
    portal_.is_weighed = exit_edge < 0;
    if (!portal_.is_weighed && portal_.radius > 0) {
      // Mostly by the edge itself.
      if (const std::optional<Termination> end = LeaveByEdge<kEarlyOut>(settings)) return *end;
      portal_.normal = portal_.NormalOfCorners();
    } else if (!portal_.is_weighed && !WalkToRay(exit_edge)) {
      return Termination::kNone;
    }
    return RefineToSurface<kEarlyOut>(settings, kMaxWarmSteps);
  }

  /// Goes from a triangle that the ray passes outside of to one that it passes through.
  /// @param exit_edge  Result of FindExitEdge().
  bool WalkToRay(int exit_edge) {
    for (;;) {
      if (support_.iterations >= kMaxWarmSteps || !support_.CrossEdge(portal_, static_cast<std::size_t>(exit_edge)))
        return false;
      portal_.FindPlane();
      // Facets on the way may be thin.
      if (!(portal_.height > 0 && portal_.along > 0)) return false;
      exit_edge = portal_.FindExitEdge();
      if (exit_edge >= 0) continue;
      portal_.is_weighed = portal_.IsWellConditioned();
      return true;
    }
  }

  template <EarlyOut kEarlyOut>
  Termination RefineToSurface(const Settings<S>& settings, int most_iterations) {
    return portal_.radius > 0 ? RefineWithRadius<kEarlyOut>(settings, most_iterations)
                              : Refine<kEarlyOut, false>(settings, most_iterations);
  }

  /// It is not inlined: with its registers, a refinement without a radius takes a tenth longer.
  template <EarlyOut kEarlyOut>
  DGD_FLATTEN DGD_NOINLINE Termination RefineWithRadius(const Settings<S>& settings, int most_iterations) {
    return Refine<kEarlyOut, true>(settings, most_iterations);
  }

  /// Refines from corners that the ray passes between, and their normal.
  template <EarlyOut kEarlyOut, bool kHasRadius>
  Termination Refine(const Settings<S>& settings, int most_iterations) {
    for (;;) {
      const S height = portal_.template Height<kHasRadius>();
      if (!(height > 0)) return Termination::kNone;  // The same corner twice: there is no normal.
      [[maybe_unused]] S along = 0;
      if constexpr (kEarlyOut != EarlyOut::kNever) {
        along = portal_.normal.dot(portal_.ray);
        if (kEarlyOut == EarlyOut::kDecided && portal_.EndsBelow(along, height)) return Termination::kCommon;
      }
      const Corner farthest = support_.CornerAlong(portal_.normal);
      rise_ = portal_.normal.dot(farthest.point - portal_.corners[0].point);
      if (kEarlyOut != EarlyOut::kNever && IsApart<kEarlyOut>(along - height - rise_, settings)) {
        return TerminateApart(farthest, along - height - rise_);
      }
      if (rise_ <= settings.relative_tolerance * height) {
        if (!kHasRadius || portal_.LeavesByFacet()) return Termination::kExit;
        if (support_.iterations >= most_iterations) return Termination::kNone;
        if (const std::optional<Termination> end = LeaveByEdge<kEarlyOut>(settings)) return *end;
      } else if (support_.iterations >= most_iterations || !portal_.template RefinePortal<kHasRadius>(farthest)) {
        return Termination::kNone;
      }
      portal_.normal = portal_.NormalOfCorners();
    }
  }

  /// @param apart  Of the supporting planes along the normal, times its length.
  template <EarlyOut kEarlyOut>
  bool IsApart(S apart, const Settings<S>& settings) const {
    return apart > 0 && (kEarlyOut == EarlyOut::kDecided || apart > settings.separation_limit * portal_.normal.norm());
  }
  Termination TerminateApart(const Corner& farthest, S apart) {
    DGD_ASSERT(apart > 0);
    portal_.length = portal_.normal.norm();
    apart_ = apart;
    portal_.corners[0] = farthest;
    return Termination::kApart;
  }

  /// Leaves by the cylinder about the edge that the ray passes beyond, with a radius, where the facet is not the exit.
  /// Not inlined: the rarer way, and long.
  /// @return nothing if there is a corner beyond the edge, which takes part now.
  template <EarlyOut kEarlyOut>
  DGD_FLATTEN DGD_NOINLINE std::optional<Termination> LeaveByEdge(const Settings<S>& settings) {
    if (!portal_.HasVertices() || !portal_.IsWellConditioned()) return Termination::kNone;
    const auto beyond = static_cast<std::size_t>(std::ranges::min_element(portal_.weights) - portal_.weights.begin());
    DGD_ASSERT(beyond < 3);
    const std::size_t a = (beyond + 1) % 3, b = (beyond + 2) % 3;
    const S inradius = support_.CoreInradius();
    const Matrix3<S> frame = FrameAlong<S>(portal_.ray.normalized());
    solver_internal::FeatureExit<S, 3> exit;
    const bool is_left =
        portal_.radius > kMinConvexRadius<S> * inradius &&
        solver_internal::EdgeExit<S>(frame.transpose() * portal_.corners[a].point,
                                     frame.transpose() * portal_.corners[b].point, portal_.radius, exit);
    if (!is_left || !(exit.normal.z() > Portal::kFlat)) return Termination::kNone;
    const Point normal = frame * exit.normal;
    const S height = exit.height * exit.normal.z();
    const Corner farthest = support_.CornerAlong(normal);
    const S rise = normal.dot(farthest.point - portal_.corners[a].point);
    if (rise > settings.relative_tolerance * height) {
      portal_.Replace(beyond, farthest);
      return std::nullopt;
    }
    portal_.normal = normal;
    portal_.length_sq = portal_.length = 1;
    portal_.exit_height = portal_.height = height;
    portal_.along = normal.dot(portal_.ray);
    rise_ = rise;
    if (kEarlyOut != EarlyOut::kNever && IsApart<kEarlyOut>(portal_.along - height - rise, settings)) {
      return TerminateApart(farthest, portal_.along - height - rise);
    }
    portal_.weights[beyond] = 0;
    portal_.weights[a] = exit.weights[0];
    portal_.weights[b] = exit.weights[1];
    portal_.is_weighed = true;
    return Termination::kExit;
  }

  /// Whether the corners at which a refinement ended are those of a certain facet.
  bool IsCertain(Termination end) {
    if (end == Termination::kNone) return false;
    ended_at_thin_facet_ = !portal_.LeavesByFacet();
    return !ended_at_thin_facet_ && support_.HasInterior(portal_.corners[0]);
  }
  /// Writes the result. It is not inlined: with its registers, a refinement takes a tenth longer.
  /// @param state  Out, or null.
  DGD_NOINLINE bool Report(Termination end, const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    result.iterations = support_.iterations;
    if (end == Termination::kApart) {
      const S along = portal_.normal.dot(portal_.ray);
      result.status = Status::kSeparated;
      result.normal = portal_.normal / portal_.length;
      result.separation = apart_ / portal_.length;
      result.lower_bound = along / (along - apart_);
      // The balls about the centres bound it.
      const S length = portal_.ray.norm();
      const S inradius_1 = support_.Inradius1(), inradius_2 = support_.Inradius2();
      result.upper_bound = std::max(result.lower_bound, length / (inradius_1 + inradius_2));
      result.witness_1 = support_.pose_1 * support_.set_1.core.Center() + inradius_1 / length * portal_.ray;
      result.witness_2 = support_.pose_2 * support_.set_2.core.Center() - inradius_2 / length * portal_.ray;
    } else {
      if (!IsCertain(end)) return false;
      const S support = portal_.height + rise_;
      DGD_ASSERT(portal_.height > 0 && portal_.exit_height > 0 && portal_.length > 0);
      result.normal = portal_.normal / portal_.length;
      result.separation = (portal_.along - support) / portal_.length;
      result.upper_bound = portal_.along / portal_.exit_height;
      result.lower_bound = portal_.along / std::max(support, portal_.exit_height);
      result.witness_1 = support_.pose_1.translation + support_.OnSet1(portal_, result.normal);
      result.witness_2 = support_.pose_2.translation + support_.OnSet2(portal_, result.normal);
      result.status = result.separation > settings.separation_limit ? Status::kSeparated : Status::kOptimal;
    }
    if (!IsFinite(result)) return false;
    if (state != nullptr) Remember(result.status, result.normal, *state);
    return true;
  }
  DGD_NOINLINE bool Report(Termination end, const Settings<S>&, WarmStart<S>* state, CollisionResult<S>& result) {
    result.iterations = support_.iterations;
    if (end == Termination::kApart) {
      result.status = Status::kSeparated;
      result.normal = portal_.normal / portal_.length;
      result.separation = apart_ / portal_.length;
      result.point = support_.pose_1 * support_.set_1.core.Vertex(portal_.corners[0].feature_1) +
                     (support_.set_1.radius + result.separation / 2) * result.normal;
    } else if (discovery_.CommonPoint()) {
      result.status = Status::kColliding;
      result.point = support_.pose_1.translation + *discovery_.CommonPoint();
      return IsFinite(result);
    } else {
      if (!IsCertain(end)) return false;
      result.status = portal_.along <= portal_.exit_height ? Status::kColliding : Status::kTouching;
      result.normal = portal_.normal / portal_.length;
      const Point center_1 = support_.pose_1.rotation * support_.set_1.core.Center();
      result.point = support_.pose_1.translation + center_1 +
                     portal_.along / portal_.exit_height * (support_.OnSet1(portal_, result.normal) - center_1);
    }
    if (!IsFinite(result)) return false;
    if (state != nullptr) Remember(result.status, result.normal, *state);
    return true;
  }

  /// Leaves a state. That of a pair that is apart has the normal only: the next query tries that first, and needs no
  /// basis then.
  void Remember(Status status, const Point& normal, WarmStart<S>& state) const {
    portal_.Leave(state);
    DGD_ASSERT(IsUnitOrNan(normal) && (status == Status::kSeparated || portal_.HasVertices()));
    state.normal_1 = (support_.pose_1.rotation.transpose() * normal).normalized();
    state.size = status == Status::kSeparated ? 0 : 3;
  }

  Support support_;
  Portal portal_{support_.Ray(), support_.Radius()};
  solver_internal::PortalDiscovery<Set1, Set2> discovery_{portal_, support_};
  S rise_;   // The sets' support value over the corners' plane, times the normal's length.
  S apart_;  // Distance of the sets' supporting planes along the normal, times its length.
  bool ended_at_thin_facet_ = false;
};

}  // namespace dgd
