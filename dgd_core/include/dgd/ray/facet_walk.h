// Polytopes' queries without a frame: from a triangle that the ray passes through to the facet that it leaves by.
//
// It is the paper's simplex method (Alg. 2) with nothing kept but the three corners of the inner approximation, in the
// world's coordinates. A step takes the corners' plane, a support point beyond it, and the one of three triangles with
// that point that the ray passes through: 0.6 of the time of a step of RayIntersection, which bounds, weighs and
// remembers as it goes, and takes fewer steps for that. Where the walk ends is weighed once.
// What is thin or steep there is RayIntersection's, which weighs with care.
//
// With a radius the triangles are those of the cores, moved by it along their normal. Where the ray passes beside the
// last one, it leaves by the cylinder about an edge, or beyond that.
//
// Two ways to begin:
//  * Where the last query ended. From frame to frame most pairs keep their facet, or leave by one nearby; where the ray
//    passes beside it, a point beyond the side that it crosses takes a corner's place: that of the facet beyond, where
//    both cores know their edges (LinkedCore).
//  * Anew, in the ball about the centre that is inside the cores' difference (Alg. 1), and from three directions about
//    the ray. Of two of them, and of the ball, a check may be told enough. Of large hulls, no support function is asked
//    while points that are looked up (GuessingCore) are above the triangle; of small ones, all vertices are rotated
//    first (placed_vertices.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "dgd/assert.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/ray/ball_hull.h"
#include "dgd/ray/feature_exit.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/placed_vertices.h"
#include "dgd/ray/ray_triangle.h"
#include "dgd/ray/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class FacetWalk : private ray_internal::RayTriangle<typename MinkowskiDifference<Set1, Set2>::S> {
 public:
  using Difference = MinkowskiDifference<Set1, Set2>;
  using S = typename Difference::S;
  using Point = Vector3<S>;
  static_assert(Difference::kIsPolytope && Difference::L == 3);

  /// Evaluations of the support functions at most, and steps to facets beside. From the last facet, by measurement:
  /// with half as many, warm queries of hulls of 241 to 4516 vertices take 1.1 times as long on average, in the slowest
  /// hundredth twice as long; with twice as many, as long. Anew, they take 27 in one of a hundred queries if no points
  /// are looked up.
  static constexpr int kMostFromLast = 8;
  static constexpr int kMostAnew = 32;

  FacetWalk(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2)
      // Far from the world's origin, the centres have lost digits that this has.
      : Triangle((pose_2.translation - pose_1.translation) +
                     (pose_2.rotation * set_2.core.Center() - pose_1.rotation * set_1.core.Center()),
                 set_1.radius + set_2.radius),
        set_1_(set_1),
        pose_1_(pose_1),
        set_2_(set_2),
        pose_2_(pose_2) {}

  /// Spares a walk anew the first direction, which is the ray's.
  /// @param support_1, support_2  Of the cores along it.
  void StartFrom(const SupportPoint<S>& support_1, const SupportPoint<S>& support_2) {
    first_ = CornerOf(support_1, support_2);
  }

  /// @param state  In and out: three points of a last query. If this fails, it names three to start from all the same.
  /// @return whether the result is optimal, or says that the sets are apart by more than asked for; if not, it is of no
  ///         use.
  bool AnswerFromLast(const Settings<S>& settings, WarmStart<S>& state, Result<S>& result) {
    return WalkFromLast(settings, IsLimited(settings) ? Early::kApart : Early::kNever, state, result);
  }
  /// @param state  Out, if there is one.
  bool AnswerAnew(const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    return Report(IsLimited(settings) ? WalkAnew<Early::kApart>(settings) : WalkAnew<Early::kNever>(settings), settings,
                  state, result);
  }

  /// Whether the sets have a point in common.
  /// @return whether the result says so; if not, it is of no use.
  bool AnswerFromLast(const Settings<S>& settings, WarmStart<S>& state, CollisionResult<S>& result) {
    return WalkFromLast(settings, Early::kDecided, state, result);
  }
  bool AnswerAnew(const Settings<S>& settings, WarmStart<S>* state, CollisionResult<S>& result) {
    wants_corners_ = state != nullptr;
    return Report(WalkAnew<Early::kDecided>(settings), settings, state, result);
  }

  /// Whether points are looked up: then a walk anew takes less than what RayIntersection goes on to do.
  bool IsQuickAnew() const { return IsGuessing(set_1_.core) || IsGuessing(set_2_.core); }

  /// Whether the last facet, or the one that the ray leaves by now, is one that RayIntersection has to weigh.
  bool EndedAtThinFacet() const { return ended_at_thin_facet_; }

  int Iterations() const { return iterations_; }

 private:
  using Triangle = ray_internal::RayTriangle<S>;
  using Corner = typename Triangle::Corner;
  using Triangle::along_;
  using Triangle::CornerAcross;
  using Triangle::corners_;
  using Triangle::exit_height_;
  using Triangle::FindPlane;
  using Triangle::HasVertices;
  using Triangle::height_;
  using Triangle::is_weighed_;
  using Triangle::IsSound;
  using Triangle::kFlat;
  using Triangle::LeavesByFacet;
  using Triangle::length_;
  using Triangle::length_sq_;
  using Triangle::normal_;
  using Triangle::NormalOfCorners;
  using Triangle::PutCornersInBall;
  using Triangle::radius_;
  using Triangle::ray_;
  using Triangle::Replace;
  using Triangle::weights_;

  static constexpr bool kIsScanned = ScannedCore<typename Set1::Core> && ScannedCore<typename Set2::Core>;

  /// Where a walk may end before the ray leaves the difference.
  enum class Early {
    kNever,
    kApart,   ///< Where a plane separates the sets by more than the limit.
    kDecided  ///< Of a check: where one separates them, or the ray ends below the corners.
  };
  /// Where it ended.
  enum class End {
    kExit,    ///< The ray leaves here.
    kApart,   ///< By `apart_` along the last normal.
    kCommon,  ///< The ray ends below the corners, or at the common point.
    kNone     ///< RayIntersection's.
  };

  static bool IsLimited(const Settings<S>& settings) {
    return settings.separation_limit < std::numeric_limits<S>::infinity();
  }

  static bool IsInRange(S length, S inradius) {
    return inradius > 0 && length > kCoincidence<S> * inradius && dgd::IsInRange(length, inradius);
  }

  template <class AnyResult>
  bool WalkFromLast(const Settings<S>& settings, Early early, WarmStart<S>& state, AnyResult& result) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius() + radius_;
    if (!IsInRange(ray_.norm(), inradius) || !TakeCorners(state)) return false;
    const End end = early == Early::kNever   ? WalkFromCorners<Early::kNever>(settings)
                    : early == Early::kApart ? WalkFromCorners<Early::kApart>(settings)
                                             : WalkFromCorners<Early::kDecided>(settings);
    if (Report(end, settings, &state, result)) return true;
    RememberCorners(state);
    return false;
  }

  template <Early kEarly>
  End WalkAnew(const Settings<S>& settings) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius(), length = ray_.norm();
    if (!(radius_ >= 0) || !IsInRange(length, inradius)) return End::kNone;
    const Point axis = ray_ / length;
    const bool is_quick = IsQuickAnew();
    // Most sets that may be apart by more than is asked for are known to be after one direction.
    if (kEarly == Early::kNever) PlaceVertices();
    const Corner first = FirstCorner(axis, is_quick && kEarly != Early::kApart);
    if (kEarly == Early::kApart) {
      const S apart = length - axis.dot(first.point) - radius_;
      normal_ = axis;
      if (apart > settings.separation_limit) return EndApart(first, apart);
    }
    if (kEarly != Early::kNever) PlaceVertices();
    PutCornersInBall(inradius, axis);
    constexpr bool kIsCheck = kEarly == Early::kDecided;
    const bool has_begun =
        is_quick ? StartByGuesses<kIsCheck>(axis, first) : SurroundRay<&FacetWalk::CornerAlong, kIsCheck>(axis, first);
    if (kIsCheck && common_) return End::kCommon;
    if (!has_begun) return End::kNone;
    normal_ = NormalOfCorners();
    return WalkOn<kEarly>(settings, kMostAnew);
  }

  void PlaceVertices() {
    if constexpr (kIsScanned) {
      placed_.Place(set_1_.core.Scan(), set_1_.core.Center(), pose_1_.rotation, set_2_.core.Scan(),
                    set_2_.core.Center(), pose_2_.rotation);
    }
  }

  Point FromCenter1(FeatureId feature) const {
    return pose_1_.rotation * (set_1_.core.Vertex(feature) - set_1_.core.Center());
  }
  Point FromCenter2(FeatureId feature) const {
    return pose_2_.rotation * (set_2_.core.Vertex(feature) - set_2_.core.Center());
  }

  bool TakeCorners(const WarmStart<S>& state) {
    for (std::size_t i = 0; i < 3; ++i) {
      const FeatureId feature_1 = state.features_1[i], feature_2 = state.features_2[i];
      if (feature_1 >= set_1_.core.VertexCount() || feature_2 >= set_2_.core.VertexCount()) return false;
      corners_[i] = {FromCenter1(feature_1) - FromCenter2(feature_2), feature_1, feature_2};
    }
    hint_1_ = corners_[0].feature_1;
    hint_2_ = corners_[0].feature_2;
    return true;
  }

  Corner CornerOf(const SupportPoint<S>& support_1, const SupportPoint<S>& support_2) const {
    Corner corner;
    corner.point.noalias() = pose_1_.rotation * (support_1.point - set_1_.core.Center());
    corner.point.noalias() -= pose_2_.rotation * (support_2.point - set_2_.core.Center());
    corner.feature_1 = support_1.feature;
    corner.feature_2 = support_2.feature;
    return corner;
  }

  Corner CornerAlong(const Point& direction) {
    ++iterations_;
    if constexpr (kIsScanned) {
      if (placed_.AreThere()) return placed_.template Farthest<Corner>(direction);
      return CornerOfSupportsOutOfLine(direction);
    } else {
      return CornerOfSupports(direction);
    }
  }
  /// Not inlined: with its registers, a walk among placed vertices takes 1.07 times as long.
  DGD_FLATTEN DGD_NOINLINE Corner CornerOfSupportsOutOfLine(const Point& direction) const {
    return CornerOfSupports(direction);
  }
  Corner CornerOfSupports(const Point& direction) const {
    return CornerOf(SupportNear(set_1_.core, Point(pose_1_.rotation.transpose() * direction), hint_1_),
                    SupportNear(set_2_.core, Point(pose_2_.rotation.transpose() * -direction), hint_2_));
  }

  Corner FirstCorner(const Point& axis, bool may_guess) {
    if (!first_) return may_guess ? GuessAlong(axis) : CornerAlong(axis);
    ++iterations_;
    return *first_;
  }

  /// About the farthest one.
  Corner GuessAlong(const Point& direction) {
    return CornerOf(GuessSupport(set_1_.core, Point(pose_1_.rotation.transpose() * direction)),
                    GuessSupport(set_2_.core, Point(pose_2_.rotation.transpose() * -direction)));
  }

  /// From corners that the ray may pass beside.
  template <Early kEarly>
  End WalkFromCorners(const Settings<S>& settings) {
    FindPlane();
    ended_at_thin_facet_ = !IsSound();
    if (ended_at_thin_facet_) return End::kNone;
    const int beside = CornerAcross();
    is_weighed_ = beside < 0;
    if (!is_weighed_ && radius_ > 0) {
      // Mostly by the edge itself.
      if (const std::optional<End> end = LeaveByEdge<kEarly>(settings)) return *end;
      normal_ = NormalOfCorners();
    } else if (!is_weighed_ && !StepOntoRay(beside)) {
      return End::kNone;
    }
    return WalkOn<kEarly>(settings, kMostFromLast);
  }

  /// From a triangle that the ray passes beside to one that it passes through.
  bool StepOntoRay(int beside) {
    for (;;) {
      if (iterations_ >= kMostFromLast || !StepOver(static_cast<std::size_t>(beside))) return false;
      FindPlane();
      // Between here and there facets may be thin.
      if (!(height_ > 0 && along_ > 0)) return false;
      beside = CornerAcross();
      if (beside >= 0) continue;
      is_weighed_ = IsSound();
      return true;
    }
  }

  /// Of large hulls: whole walks without a support function, as far as looked-up points go. Of 241 to 4516 vertices,
  /// queries take 0.6 of the time that they take with support points from the first direction on.
  /// @tparam kIsCheck  Whether a triangle beyond the ray's end is enough.
  template <bool kIsCheck>
  DGD_FLATTEN DGD_NOINLINE bool StartByGuesses(const Point& axis, const Corner& first) {
    // Guesses that raise the triangle by less are left to the support functions. By measurement, without a limit
    // queries take as long, and with 1e-2 those of 2000 vertices a sixth longer.
    constexpr S kWorthwhile = S(1e-3);
    // Rounding, and radii, must not make them go round in circles.
    constexpr int kMost = 16;
    if (!SurroundRay<&FacetWalk::GuessAlong, kIsCheck>(axis, first)) return false;
    if (kIsCheck && common_) return true;
    for (int i = 0; i < kMost; ++i) {
      normal_ = NormalOfCorners();
      const S height = radius_ > 0 ? this->template Height<true>() : this->template Height<false>();
      if (!(height > 0)) return false;
      if (kIsCheck && EndsBelow(normal_.dot(ray_), height)) return true;
      const Corner guess = GuessAlong(normal_);
      hint_1_ = guess.feature_1;
      hint_2_ = guess.feature_2;
      if (!(normal_.dot(guess.point - corners_[0].point) > kWorthwhile * height)) return true;
      if (!(radius_ > 0 ? this->template Exchange<true>(guess) : this->template Exchange<false>(guess))) return false;
    }
    return true;
  }

  /// Along the ray, and then twice tilted to the far side of the ray from what was found: by more where that was far
  /// away. With three corners near the ray, hulls of 14, 32, 241 and 2000 vertices take 3, 9, 19 and 20 % fewer
  /// directions than with normals from the ball on; with a spread of 1.2 or 2 up to 6 % more than with this one.
  /// @tparam kAlong    CornerAlong() or GuessAlong().
  /// @tparam kIsCheck  Whether a common point is enough.
  /// @param first      Along the ray.
  /// @return false where rounding leaves no triangle about the ray.
  template <auto kAlong, bool kIsCheck>
  bool SurroundRay(const Point& axis, const Corner& first) {
    constexpr S kSpread = S(1.5);
    // With twice and four times as much, hulls of 241 vertices, ten times as long as thick, take 1 and 3 % more.
    constexpr S kNearSq = S(0.5);
    // A hull's point that is farther out by less than so much is not looked at. By measurement, checks of hulls that
    // touch take 4 % less by that, and of hulls 1 m across that are 5 to 15 cm deep as long.
    constexpr S kWellInside = S(1.2);
    const S height = axis.dot(first.point);
    const Point beside = first.point - height * axis;
    // Of skewed sets, what is farthest along the ray is far from it, and so is what is found like that.
    if (beside.squaredNorm() > kNearSq * height * height) return this->template Exchange<false>(first);
    const Corner second = (this->*kAlong)(height * axis - kSpread * beside);
    if (kIsCheck && !wants_corners_ && height * height > kWellInside * kWellInside * ray_.squaredNorm() &&
        FindCommonPoint(axis, first, second)) {
      return true;
    }
    const Point across = axis.cross(second.point - first.point);
    const S width_sq = across.squaredNorm(), side = across.dot(first.point);
    if (!this->template Exchange<false>(first) || !this->template Exchange<false>(second)) return false;
    if (!(width_sq > kEpsilon<S> * height * height)) return true;
    // Half the line's length at least, where that nearly meets the ray.
    const S tilt = kSpread * std::max(std::abs(side) / width_sq, S(0.5));
    return this->template Exchange<false>((this->*kAlong)(height * axis - std::copysign(tilt, side) * across));
  }

  /// In the hull of the ball about the centre and of the point between two corners that is nearest to the ray.
  bool FindCommonPoint(const Point& axis, const Corner& a, const Corner& b) {
    const S height = axis.dot(a.point);
    const Point between = b.point - a.point;
    const Point beside = a.point - height * axis, step = between - axis.dot(between) * axis;
    const S step_sq = step.squaredNorm();
    const S part = step_sq > 0 ? std::clamp(-beside.dot(step) / step_sq, S(0), S(1)) : S(0);
    const S inradius_1 = set_1_.core.Inradius() + set_1_.radius, inradius_2 = set_2_.core.Inradius() + set_2_.radius;
    const S inradius = inradius_1 + inradius_2;
    const auto end = ray_internal::FindInBallHull<S, 3>(ray_, a.point + part * between, inradius);
    if (!end || !HasInterior(a)) return false;
    const Point of_corners = (1 - part) * FromCenter1(a.feature_1) + part * FromCenter1(b.feature_1);
    common_ = pose_1_.rotation * set_1_.core.Center() + end->share * of_corners + inradius_1 / inradius * end->inside;
    return true;
  }

  template <Early kEarly>
  End WalkOn(const Settings<S>& settings, int most_iterations) {
    return radius_ > 0 ? WalkRounded<kEarly>(settings, most_iterations)
                       : Walk<kEarly, false>(settings, most_iterations);
  }

  /// Not inlined: with its registers, a walk without a radius takes a tenth longer.
  template <Early kEarly>
  DGD_FLATTEN DGD_NOINLINE End WalkRounded(const Settings<S>& settings, int most_iterations) {
    return Walk<kEarly, true>(settings, most_iterations);
  }

  /// From corners that the ray passes between, and their normal.
  template <Early kEarly, bool kRounded>
  End Walk(const Settings<S>& settings, int most_iterations) {
    for (;;) {
      const S height = this->template Height<kRounded>();
      if (!(height > 0)) return End::kNone;  // The same corner twice: there is no normal.
      [[maybe_unused]] S along = 0;
      if constexpr (kEarly != Early::kNever) {
        along = normal_.dot(ray_);
        if (kEarly == Early::kDecided && EndsBelow(along, height)) return End::kCommon;
      }
      const Corner farthest = CornerAlong(normal_);
      rise_ = normal_.dot(farthest.point - corners_[0].point);
      if (kEarly != Early::kNever && IsApart<kEarly>(along - height - rise_, settings)) {
        return EndApart(farthest, along - height - rise_);
      }
      if (rise_ <= settings.relative_tolerance * height) {
        if (!kRounded || LeavesByFacet()) return End::kExit;
        if (iterations_ >= most_iterations) return End::kNone;
        if (const std::optional<End> end = LeaveByEdge<kEarly>(settings)) return *end;
      } else if (iterations_ >= most_iterations || !this->template Exchange<kRounded>(farthest)) {
        return End::kNone;
      }
      normal_ = NormalOfCorners();
    }
  }

  /// Whether the ray ends below the corners, moved by the radius, and between them. With a radius they may be turned
  /// away from the ray, and their plane, moved, is no bound then.
  bool EndsBelow(S along, S height) { return along > 0 && along <= height && LeavesByFacet(); }

  /// @param apart  Of the supporting planes along the normal, times its length.
  template <Early kEarly>
  bool IsApart(S apart, const Settings<S>& settings) const {
    return apart > 0 && (kEarly == Early::kDecided || apart > settings.separation_limit * normal_.norm());
  }
  End EndApart(const Corner& farthest, S apart) {
    DGD_ASSERT(apart > 0);
    length_ = normal_.norm();
    apart_ = apart;
    corners_[0] = farthest;
    return End::kApart;
  }

  /// To a triangle beyond the side across from a corner: of the side, and another corner.
  /// @return false if none is found.
  bool StepOver(std::size_t corner) {
    DGD_ASSERT(corner < 3);
    if constexpr (LinkedCore<typename Set1::Core> && LinkedCore<typename Set2::Core>) {
      if (set_1_.core.IsLinked() && set_2_.core.IsLinked()) return Pivot(corner);
    }
    return Tilt(corner);
  }

  /// The other corner is what the plane, turned about the side, meets next: on one of the two cores. By measurement,
  /// warm queries of hulls of 241 to 4516 vertices take a third less time than with Tilt().
  bool Pivot(std::size_t corner) {
    ++iterations_;
    const Corner& from = corners_[(corner + 1) % 3];
    const Point outwards = (corners_[(corner + 2) % 3].point - from.point).cross(normal_);
    const Ascent<S> way_1 = set_1_.core.SteepestAscent(from.feature_1, pose_1_.rotation.transpose() * normal_,
                                                       pose_1_.rotation.transpose() * outwards);
    const Ascent<S> way_2 = set_2_.core.SteepestAscent(from.feature_2, pose_2_.rotation.transpose() * -normal_,
                                                       pose_2_.rotation.transpose() * -outwards);
    const bool is_1 = way_1.slope > way_2.slope;
    if (!((is_1 ? way_1 : way_2).slope > -std::numeric_limits<S>::infinity())) return false;
    const FeatureId feature_1 = is_1 ? way_1.vertex : from.feature_1, feature_2 = is_1 ? from.feature_2 : way_2.vertex;
    corners_[corner] = {FromCenter1(feature_1) - FromCenter2(feature_2), feature_1, feature_2};
    return true;
  }

  /// The other corner is farthest along the normal tilted towards there.
  bool Tilt(std::size_t corner) {
    const Point &a = corners_[(corner + 1) % 3].point, &b = corners_[(corner + 2) % 3].point;
    const Point outwards = b.cross(a);
    const Point side = b - a;
    const S width = length_ / side.norm();
    const S tilt = kTilt * width / std::sqrt(std::min(a.squaredNorm(), b.squaredNorm()));
    const Corner added = CornerAlong(normal_ / length_ + tilt / outwards.norm() * outwards);
    if (!(outwards.dot(added.point) > 0)) return false;
    corners_[corner] = added;
    return true;
  }

  /// After LeavesByFacet(), with a radius: by the cylinder about the edge that the ray passes beyond. Rarer, and long.
  /// @return nothing if there is a corner beyond the edge, which takes part now.
  template <Early kEarly>
  DGD_FLATTEN DGD_NOINLINE std::optional<End> LeaveByEdge(const Settings<S>& settings) {
    if (!HasVertices() || !IsSound()) return End::kNone;
    const auto beyond = static_cast<std::size_t>(std::ranges::min_element(weights_) - weights_.begin());
    DGD_ASSERT(beyond < 3);
    const std::size_t a = (beyond + 1) % 3, b = (beyond + 2) % 3;
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius();
    const Matrix3<S> frame = FrameAlong<S>(ray_.normalized());
    ray_internal::FeatureExit<S, 3> exit;
    const bool is_left = radius_ > kMinRounding<S> * inradius &&
                         ray_internal::EdgeExit<S>(frame.transpose() * corners_[a].point,
                                                   frame.transpose() * corners_[b].point, radius_, exit);
    if (!is_left || !(exit.normal.z() > kFlat)) return End::kNone;
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
    if (kEarly != Early::kNever && IsApart<kEarly>(along_ - height - rise, settings)) {
      return EndApart(farthest, along_ - height - rise);
    }
    weights_[beyond] = 0;
    weights_[a] = exit.weights[0];
    weights_[b] = exit.weights[1];
    is_weighed_ = true;
    return End::kExit;
  }

  /// Of a walk that ended at corners.
  bool IsCertain(End end) {
    if (end == End::kNone) return false;
    ended_at_thin_facet_ = !LeavesByFacet();
    return !ended_at_thin_facet_ && HasInterior(corners_[0]);
  }
  bool HasInterior(const Corner& corner) const {
    return HasCertainInterior(set_1_, set_2_, set_1_.core.Vertex(corner.feature_1),
                              set_2_.core.Vertex(corner.feature_2));
  }

  /// The corners' point by their weights, of set 1 or 2; world, from the set's origin.
  Point OnSet1(const Point& normal) const {
    return pose_1_.rotation * Middle(set_1_.core, &Corner::feature_1) + set_1_.radius * normal;
  }
  Point OnSet2(const Point& normal) const {
    return pose_2_.rotation * Middle(set_2_.core, &Corner::feature_2) - set_2_.radius * normal;
  }
  template <class Core>
  Point Middle(const Core& core, FeatureId Corner::*feature) const {
    DGD_ASSERT(HasVertices() && is_weighed_);
    Point sum = weights_[0] * core.Vertex(corners_[0].*feature);
    for (std::size_t i = 1; i < 3; ++i) sum += weights_[i] * core.Vertex(corners_[i].*feature);
    return sum;
  }

  /// Not inlined: with its registers, a walk takes a tenth longer.
  /// @param state  Out, if there is one.
  DGD_NOINLINE bool Report(End end, const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    result.iterations = iterations_;
    if (end == End::kApart) {
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
  DGD_NOINLINE bool Report(End end, const Settings<S>&, WarmStart<S>* state, CollisionResult<S>& result) {
    result.iterations = iterations_;
    if (end == End::kApart) {
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
    DGD_ASSERT(IsUnitOrNan(normal) && HasVertices());
    state.normal_1 = (pose_1_.rotation.transpose() * normal).normalized();
    state.size = status == Status::kSeparated ? 0 : 3;
  }

  void RememberCorners(WarmStart<S>& state) const {
    for (std::size_t i = 0; i < 3; ++i) {
      state.features_1[i] = corners_[i].feature_1;
      state.features_2[i] = corners_[i].feature_2;
    }
  }

  /// Of the angle under which the facet's width is seen from the centre. By measurement, with Tilt() for all hulls:
  /// with 1, 2, 3 and 4 times as much, warm queries of hulls of 2000 vertices take 444, 370, 361 and 426 ns on average,
  /// of 241 240, 227, 234, 246.
  static constexpr S kTilt = S(2);

  const Set1& set_1_;
  const Pose<S>& pose_1_;
  const Set2& set_2_;
  const Pose<S>& pose_2_;
  std::conditional_t<kIsScanned, ray_internal::PlacedVertices<S>, std::nullptr_t> placed_;  // In a walk anew.
  std::optional<Corner> first_;  // If known, the farthest along the ray.
  std::optional<Point> common_;  // Of the two sets, from set 1's origin; world.
  bool wants_corners_ = true;    // For a next query to begin from: a common point would leave none.
  FeatureId hint_1_ = kNoFeature, hint_2_ = kNoFeature;
  S rise_;   // Of the sets' support value over the plane of the corners, times the normal's length.
  S apart_;  // Of the sets' supporting planes along the normal, times its length.
  bool ended_at_thin_facet_ = false;
  int iterations_ = 0;
};

}  // namespace dgd
