// Polytopes' queries without a frame: from a triangle that the ray passes through to the facet that it leaves by.
//
// It is the paper's simplex method (Alg. 2) with nothing kept but the three corners of the inner approximation, in the
// world's coordinates. A step takes the corners' plane, a support point beyond it, and the one of three triangles with
// that point that the ray passes through: 0.6 of the time of a step of RayIntersection, which bounds, weighs and
// remembers as it goes, and takes fewer steps for that. Where the refinement ends is weighed once.
// What is thin or steep there is RayIntersection's, which weighs with care.
//
// With a radius the triangles are those of the cores, moved by it along their normal. Where the ray passes outside the
// last one, it leaves by the cylinder about an edge, or beyond that.
//
// Two ways to begin:
//  * Warm, where the last query ended. From frame to frame most pairs keep their facet, or leave by one nearby; where
//    the ray passes outside it, a point beyond the side that it crosses takes a corner's place: that of the facet
//    beyond, where both cores know their edges (LinkedCore).
//  * Cold (portal_discovery.h).
//
// Kin: Minkowski portal refinement (Snethen 2008, "XenoCollide: Complex Collision Made Simple"), whose ray runs from
// the centre to the origin as ours does, and which stops where a portal's plane is near enough to the surface. Here the
// facet that the ray leaves by is found, its height is bounded from both sides, and the portal is kept for the next
// frame.
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
class PortalRefinement : private solver_internal::PortalDiscovery<Set1, Set2> {
  using Discovery = solver_internal::PortalDiscovery<Set1, Set2>;

 public:
  using Discovery::Discovery;
  using Discovery::HasFastColdStart;
  using Discovery::Iterations;
  using Discovery::StartFrom;
  using typename Discovery::Point;
  using typename Discovery::S;

  /// Most evaluations of the support functions, and steps to neighbouring facets. Warm, by measurement:
  /// with half as many, warm queries of hulls of 241 to 4516 vertices take 1.1 times as long on average, in the slowest
  /// hundredth twice as long; with twice as many, as long. Cold, they take 27 in one of a hundred queries if no points
  /// are looked up.
  static constexpr int kMaxWarmSteps = 8;
  static constexpr int kMaxColdSteps = 32;

  /// @param state  In and out: three points of a last query. If this fails, it names three to start from all the same.
  /// @return whether the result is optimal, or that the sets are separated by more than the limit; if not, it is of no
  ///         use.
  bool SolveWarm(const Settings<S>& settings, WarmStart<S>& state, Result<S>& result) {
    return RunWarm(settings, IsLimited(settings) ? EarlyOut::kApart : EarlyOut::kNever, state, result);
  }
  /// @param state  Out, if there is one.
  bool SolveCold(const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    return Report(IsLimited(settings) ? RunCold<EarlyOut::kApart>(settings) : RunCold<EarlyOut::kNever>(settings),
                  settings, state, result);
  }

  /// Whether the sets have a point in common.
  /// @return whether the result says so; if not, it is of no use.
  bool SolveWarm(const Settings<S>& settings, WarmStart<S>& state, CollisionResult<S>& result) {
    return RunWarm(settings, EarlyOut::kDecided, state, result);
  }
  bool SolveCold(const Settings<S>& settings, WarmStart<S>* state, CollisionResult<S>& result) {
    wants_corners_ = state != nullptr;
    return Report(RunCold<EarlyOut::kDecided>(settings), settings, state, result);
  }

  /// Whether the last facet, or the one that the ray leaves by now, is one that RayIntersection has to weigh.
  bool EndedAtThinFacet() const { return ended_at_thin_facet_; }

 private:
  using Discovery::along_;
  using Discovery::common_;
  using Discovery::CornerAlong;
  using Discovery::corners_;
  using Discovery::CrossEdge;
  using Discovery::EndsBelow;
  using Discovery::exit_height_;
  using Discovery::FindExitEdge;
  using Discovery::FindPlane;
  using Discovery::FirstCorner;
  using Discovery::HasInterior;
  using Discovery::HasVertices;
  using Discovery::height_;
  using Discovery::InitialPortal;
  using Discovery::is_weighed_;
  using Discovery::IsWellConditioned;
  using Discovery::iterations_;
  using Discovery::kFlat;
  using Discovery::LeavesByFacet;
  using Discovery::length_;
  using Discovery::length_sq_;
  using Discovery::normal_;
  using Discovery::NormalOfCorners;
  using Discovery::OnSet1;
  using Discovery::OnSet2;
  using Discovery::PlaceVertices;
  using Discovery::pose_1_;
  using Discovery::pose_2_;
  using Discovery::radius_;
  using Discovery::ray_;
  using Discovery::RememberCorners;
  using Discovery::Replace;
  using Discovery::set_1_;
  using Discovery::set_2_;
  using Discovery::TakeCorners;
  using Discovery::wants_corners_;
  using Discovery::weights_;
  using typename Discovery::Corner;

  /// What ends a refinement before the ray leaves the difference.
  enum class EarlyOut {
    kNever,
    kApart,   ///< Where a plane separates the sets by more than the limit.
    kDecided  ///< Of a check: where one separates them, or the ray ends below the corners.
  };
  /// How it ended.
  enum class Termination {
    kExit,    ///< The ray leaves by these corners.
    kApart,   ///< By `apart_` along the last normal.
    kCommon,  ///< The ray ends below the corners, or at the common point.
    kNone     ///< Not solved: the rest is left to RayIntersection.
  };

  static bool IsLimited(const Settings<S>& settings) {
    return settings.separation_limit < std::numeric_limits<S>::infinity();
  }

  static bool IsInRange(S length, S inradius) {
    return inradius > 0 && length > kCoincidence<S> * inradius && dgd::IsInRange(length, inradius);
  }

  template <class AnyResult>
  bool RunWarm(const Settings<S>& settings, EarlyOut early, WarmStart<S>& state, AnyResult& result) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius() + radius_;
    if (!IsInRange(ray_.norm(), inradius) || !TakeCorners(state)) return false;
    const Termination end = early == EarlyOut::kNever   ? RunFromPortal<EarlyOut::kNever>(settings)
                            : early == EarlyOut::kApart ? RunFromPortal<EarlyOut::kApart>(settings)
                                                        : RunFromPortal<EarlyOut::kDecided>(settings);
    if (Report(end, settings, &state, result)) return true;
    RememberCorners(state);
    return false;
  }

  template <EarlyOut kEarlyOut>
  Termination RunCold(const Settings<S>& settings) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius(), length = ray_.norm();
    if (!(radius_ >= 0) || !IsInRange(length, inradius)) return Termination::kNone;
    const Point axis = ray_ / length;
    const bool is_quick = HasFastColdStart();
    // Most sets that are separated by more than the limit are known to be after one direction.
    if (kEarlyOut == EarlyOut::kNever) PlaceVertices();
    const Corner first = FirstCorner(axis, is_quick && kEarlyOut != EarlyOut::kApart);
    if (kEarlyOut == EarlyOut::kApart) {
      const S apart = length - axis.dot(first.point) - radius_;
      normal_ = axis;
      if (apart > settings.separation_limit) return TerminateApart(first, apart);
    }
    if (kEarlyOut != EarlyOut::kNever) PlaceVertices();
    InitialPortal(inradius, axis);
    constexpr bool kIsCheck = kEarlyOut == EarlyOut::kDecided;
    const bool has_begun = is_quick ? this->template StartByGuesses<kIsCheck>(axis, first)
                                    : this->template DiscoverPortal<false, kIsCheck>(axis, first);
    if (kIsCheck && common_) return Termination::kCommon;
    if (!has_begun) return Termination::kNone;
    normal_ = NormalOfCorners();
    return RefineToSurface<kEarlyOut>(settings, kMaxColdSteps);
  }

  /// From corners that the ray may pass outside of.
  template <EarlyOut kEarlyOut>
  Termination RunFromPortal(const Settings<S>& settings) {
    FindPlane();
    ended_at_thin_facet_ = !IsWellConditioned();
    if (ended_at_thin_facet_) return Termination::kNone;
    const int exit_edge = FindExitEdge();
    is_weighed_ = exit_edge < 0;
    if (!is_weighed_ && radius_ > 0) {
      // Mostly by the edge itself.
      if (const std::optional<Termination> end = LeaveByEdge<kEarlyOut>(settings)) return *end;
      normal_ = NormalOfCorners();
    } else if (!is_weighed_ && !WalkToRay(exit_edge)) {
      return Termination::kNone;
    }
    return RefineToSurface<kEarlyOut>(settings, kMaxWarmSteps);
  }

  /// From a triangle that the ray passes outside of to one that it passes through.
  /// @param exit_edge  FindExitEdge().
  bool WalkToRay(int exit_edge) {
    for (;;) {
      if (iterations_ >= kMaxWarmSteps || !CrossEdge(static_cast<std::size_t>(exit_edge))) return false;
      FindPlane();
      // Between here and there facets may be thin.
      if (!(height_ > 0 && along_ > 0)) return false;
      exit_edge = FindExitEdge();
      if (exit_edge >= 0) continue;
      is_weighed_ = IsWellConditioned();
      return true;
    }
  }

  template <EarlyOut kEarlyOut>
  Termination RefineToSurface(const Settings<S>& settings, int most_iterations) {
    return radius_ > 0 ? RefineWithRadius<kEarlyOut>(settings, most_iterations)
                       : Refine<kEarlyOut, false>(settings, most_iterations);
  }

  /// Not inlined: with its registers, a refinement without a radius takes a tenth longer.
  template <EarlyOut kEarlyOut>
  DGD_FLATTEN DGD_NOINLINE Termination RefineWithRadius(const Settings<S>& settings, int most_iterations) {
    return Refine<kEarlyOut, true>(settings, most_iterations);
  }

  /// From corners that the ray passes between, and their normal.
  template <EarlyOut kEarlyOut, bool kHasRadius>
  Termination Refine(const Settings<S>& settings, int most_iterations) {
    for (;;) {
      const S height = this->template Height<kHasRadius>();
      if (!(height > 0)) return Termination::kNone;  // The same corner twice: there is no normal.
      [[maybe_unused]] S along = 0;
      if constexpr (kEarlyOut != EarlyOut::kNever) {
        along = normal_.dot(ray_);
        if (kEarlyOut == EarlyOut::kDecided && EndsBelow(along, height)) return Termination::kCommon;
      }
      const Corner farthest = CornerAlong(normal_);
      rise_ = normal_.dot(farthest.point - corners_[0].point);
      if (kEarlyOut != EarlyOut::kNever && IsApart<kEarlyOut>(along - height - rise_, settings)) {
        return TerminateApart(farthest, along - height - rise_);
      }
      if (rise_ <= settings.relative_tolerance * height) {
        if (!kHasRadius || LeavesByFacet()) return Termination::kExit;
        if (iterations_ >= most_iterations) return Termination::kNone;
        if (const std::optional<Termination> end = LeaveByEdge<kEarlyOut>(settings)) return *end;
      } else if (iterations_ >= most_iterations || !this->template RefinePortal<kHasRadius>(farthest)) {
        return Termination::kNone;
      }
      normal_ = NormalOfCorners();
    }
  }

  /// @param apart  Of the supporting planes along the normal, times its length.
  template <EarlyOut kEarlyOut>
  bool IsApart(S apart, const Settings<S>& settings) const {
    return apart > 0 && (kEarlyOut == EarlyOut::kDecided || apart > settings.separation_limit * normal_.norm());
  }
  Termination TerminateApart(const Corner& farthest, S apart) {
    DGD_ASSERT(apart > 0);
    length_ = normal_.norm();
    apart_ = apart;
    corners_[0] = farthest;
    return Termination::kApart;
  }

  /// After LeavesByFacet(), with a radius: by the cylinder about the edge that the ray passes beyond. Rarer, and long.
  /// @return nothing if there is a corner beyond the edge, which takes part now.
  template <EarlyOut kEarlyOut>
  DGD_FLATTEN DGD_NOINLINE std::optional<Termination> LeaveByEdge(const Settings<S>& settings) {
    if (!HasVertices() || !IsWellConditioned()) return Termination::kNone;
    const auto beyond = static_cast<std::size_t>(std::ranges::min_element(weights_) - weights_.begin());
    DGD_ASSERT(beyond < 3);
    const std::size_t a = (beyond + 1) % 3, b = (beyond + 2) % 3;
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius();
    const Matrix3<S> frame = FrameAlong<S>(ray_.normalized());
    solver_internal::FeatureExit<S, 3> exit;
    const bool is_left = radius_ > kMinConvexRadius<S> * inradius &&
                         solver_internal::EdgeExit<S>(frame.transpose() * corners_[a].point,
                                                      frame.transpose() * corners_[b].point, radius_, exit);
    if (!is_left || !(exit.normal.z() > kFlat)) return Termination::kNone;
    const Point normal = frame * exit.normal;
    const S height = exit.height * exit.normal.z();
    const Corner farthest = CornerAlong(normal);
    const S rise = normal.dot(farthest.point - corners_[a].point);
    if (rise > settings.relative_tolerance * height) {
      Replace(beyond, farthest);
      return std::nullopt;
    }
    normal_ = normal;
    length_sq_ = length_ = 1;
    exit_height_ = height_ = height;
    along_ = normal.dot(ray_);
    rise_ = rise;
    if (kEarlyOut != EarlyOut::kNever && IsApart<kEarlyOut>(along_ - height - rise, settings)) {
      return TerminateApart(farthest, along_ - height - rise);
    }
    weights_[beyond] = 0;
    weights_[a] = exit.weights[0];
    weights_[b] = exit.weights[1];
    is_weighed_ = true;
    return Termination::kExit;
  }

  /// Whether the corners at which a refinement ended are those of a certain facet.
  bool IsCertain(Termination end) {
    if (end == Termination::kNone) return false;
    ended_at_thin_facet_ = !LeavesByFacet();
    return !ended_at_thin_facet_ && HasInterior(corners_[0]);
  }
  /// Not inlined: with its registers, a refinement takes a tenth longer.
  /// @param state  Out, if there is one.
  DGD_NOINLINE bool Report(Termination end, const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    result.iterations = iterations_;
    if (end == Termination::kApart) {
      const S along = normal_.dot(ray_);
      result.status = Status::kSeparated;
      result.normal = normal_ / length_;
      result.separation = apart_ / length_;
      result.lower_bound = along / (along - apart_);
      // Of the balls about the centres.
      const S length = ray_.norm();
      const S inradius_1 = set_1_.core.Inradius() + set_1_.radius, inradius_2 = set_2_.core.Inradius() + set_2_.radius;
      result.upper_bound = std::max(result.lower_bound, length / (inradius_1 + inradius_2));
      result.witness_1 = pose_1_ * set_1_.core.Center() + inradius_1 / length * ray_;
      result.witness_2 = pose_2_ * set_2_.core.Center() - inradius_2 / length * ray_;
    } else {
      if (!IsCertain(end)) return false;
      const S support = height_ + rise_;
      DGD_ASSERT(height_ > 0 && exit_height_ > 0 && length_ > 0);
      result.normal = normal_ / length_;
      result.separation = (along_ - support) / length_;
      result.upper_bound = along_ / exit_height_;
      result.lower_bound = along_ / std::max(support, exit_height_);
      result.witness_1 = pose_1_.translation + OnSet1(result.normal);
      result.witness_2 = pose_2_.translation + OnSet2(result.normal);
      result.status = result.separation > settings.separation_limit ? Status::kSeparated : Status::kOptimal;
    }
    if (!IsFinite(result)) return false;
    if (state != nullptr) Remember(result.status, result.normal, *state);
    return true;
  }
  DGD_NOINLINE bool Report(Termination end, const Settings<S>&, WarmStart<S>* state, CollisionResult<S>& result) {
    result.iterations = iterations_;
    if (end == Termination::kApart) {
      result.status = Status::kSeparated;
      result.normal = normal_ / length_;
      result.separation = apart_ / length_;
      result.point =
          pose_1_ * set_1_.core.Vertex(corners_[0].feature_1) + (set_1_.radius + result.separation / 2) * result.normal;
    } else if (common_) {
      result.status = Status::kColliding;
      result.point = pose_1_.translation + *common_;
      return IsFinite(result);
    } else {
      if (!IsCertain(end)) return false;
      result.status = along_ <= exit_height_ ? Status::kColliding : Status::kTouching;
      result.normal = normal_ / length_;
      const Point center_1 = pose_1_.rotation * set_1_.core.Center();
      result.point = pose_1_.translation + center_1 + along_ / exit_height_ * (OnSet1(result.normal) - center_1);
    }
    if (!IsFinite(result)) return false;
    if (state != nullptr) Remember(result.status, result.normal, *state);
    return true;
  }

  /// A pair that is apart remembers its normal only: the next query tries that first, and needs no basis then.
  void Remember(Status status, const Point& normal, WarmStart<S>& state) const {
    RememberCorners(state);
    DGD_ASSERT(IsUnitOrNan(normal) && (status == Status::kSeparated || HasVertices()));
    state.normal_1 = (pose_1_.rotation.transpose() * normal).normalized();
    state.size = status == Status::kSeparated ? 0 : 3;
  }

  S rise_;   // Of the sets' support value over the plane of the corners, times the normal's length.
  S apart_;  // Of the sets' supporting planes along the normal, times its length.
  bool ended_at_thin_facet_ = false;
};

}  // namespace dgd
