// Polytopes' queries without a frame: from a triangle that the ray passes through to the facet that it leaves by.
//
// It is the paper's simplex method (Alg. 2) with nothing kept but the three corners of the inner approximation, in the
// world's coordinates. A step takes the corners' plane, a support point beyond it, and the one of three triangles with
// that point that the ray passes through: 0.6 of the time of a step of RayIntersection, which bounds, weighs and
// remembers as it goes, and takes fewer steps for that (tests/bench/iterations). Where the walk ends is weighed once.
// What is thin or steep there is RayIntersection's, which weighs with care.
//
// With a radius the triangles are those of the cores, moved by it along their normal. Where the ray passes beside the
// last one, it leaves by the cylinder about an edge, or beyond that.
//
// Two ways to begin:
//  * Where the last query ended. From frame to frame most pairs keep their facet, or leave by one nearby; where the ray
//    passes beside it, a point beyond the side that it crosses takes a corner's place.
//  * Anew, in the ball about the centre that is inside the cores' difference (Alg. 1), and from three directions about
//    the ray. Of large hulls, no support function is asked while points that are looked up (GuessingCore) are above the
//    triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "dgd/query_types.h"
#include "dgd/ray/feature_exit.h"
#include "dgd/ray/inner_approximation.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class FacetWalk {
 public:
  using Difference = MinkowskiDifference<Set1, Set2>;
  using S = typename Difference::S;
  using Point = Vector3<S>;
  static_assert(Difference::kIsPolytope && Difference::L == 3);

  /// Evaluations of the support functions at most. From the last facet, by measurement: with half as many, warm queries
  /// of hulls of 2000 vertices take 1.4 times as long on average. Anew, meshes of up to 4516 vertices take 27 in one of
  /// a hundred queries if no points are looked up.
  static constexpr int kMostFromLast = 8;
  static constexpr int kMostAnew = 32;

  FacetWalk(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2)
      : set_1_(set_1),
        pose_1_(pose_1),
        set_2_(set_2),
        pose_2_(pose_2),
        // Far from the world's origin, the centres have lost digits that this has.
        ray_((pose_2.translation - pose_1.translation) +
             (pose_2.rotation * set_2.core.Center() - pose_1.rotation * set_1.core.Center())),
        radius_(set_1.radius + set_2.radius) {}

  /// @param state  In and out: three points of a last query. If this fails, it names three to start from all the same.
  /// @return whether the result is optimal; if not, it is of no use.
  bool AnswerFromLast(const Settings<S>& settings, WarmStart<S>& state, Result<S>& result) {
    if (!BeginFromLast(state)) return false;
    const bool is_solved = WalkFromLast<false>(settings) == End::kExit && Report(settings, result);
    RememberCorners(state);
    if (is_solved) state.normal_1 = Normal1(result.normal);
    return is_solved;
  }

  /// For a distance: sets that may be apart by more than is asked for are most often known to be after one direction,
  /// which RayIntersection bounds from both sides.
  /// @param state  Out, if there is one.
  /// @return as above.
  bool AnswerAnew(const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    const bool may_end_apart = settings.separation_limit < std::numeric_limits<S>::infinity();
    if (may_end_apart || !BeginAnew(false) || WalkOn<false>(settings, kMostAnew) != End::kExit ||
        !Report(settings, result)) {
      return false;
    }
    if (state != nullptr) RememberBasis(result.normal, *state);
    return true;
  }

  /// Whether the sets have a point in common.
  /// @return whether the result says so; if not, it is of no use.
  bool AnswerFromLast(const Settings<S>& settings, WarmStart<S>& state, CollisionResult<S>& result) {
    if (!BeginFromLast(state)) return false;
    const End end = WalkFromLast<true>(settings);
    RememberCorners(state);
    return Report(end, &state, result);
  }
  bool AnswerAnew(const Settings<S>& settings, WarmStart<S>* state, CollisionResult<S>& result) {
    return BeginAnew(true) && Report(WalkOn<true>(settings, kMostAnew), state, result);
  }

  /// Whether points are looked up: then a walk anew takes less than what RayIntersection goes on to do.
  bool IsQuickAnew() const { return IsGuessing(set_1_.core) || IsGuessing(set_2_.core); }

  int Iterations() const { return iterations_; }

 private:
  struct Corner {
    Point point;  ///< Of the cores' difference about its centre; world, metres.
    FeatureId feature_1, feature_2;
  };

  /// Of a walk.
  enum class End {
    kExit,    ///< The ray leaves here.
    kApart,   ///< Of a check: the last normal's plane is between the sets.
    kCommon,  ///< Of a check: the ray ends below the corners.
    kNone     ///< RayIntersection's.
  };

  static bool IsInRange(S length, S inradius) {
    return inradius > 0 && length > kCoincidence<S> * inradius && dgd::IsInRange(length, inradius);
  }

  bool BeginFromLast(const WarmStart<S>& state) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius() + radius_;
    return IsInRange(ray_.norm(), inradius) && TakeCorners(state);
  }

  bool BeginAnew(bool is_check) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius(), length = ray_.norm();
    if (!(radius_ >= 0) || !IsInRange(length, inradius)) return false;
    const Point axis = ray_ / length;
    PutCornersInBall(inradius, axis);
    const bool has_begun = IsQuickAnew() ? StartByGuesses(axis, is_check) : SurroundRay<&FacetWalk::CornerAlong>(axis);
    normal_ = NormalOfCorners();
    return has_begun;
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

  void PutCornersInBall(S inradius, const Point& axis) {
    constexpr S kShare1 = 1;  // Of no account: corners that are no vertices are not reported.
    const auto facet = InnerApproximation<S, 3>::FromInradius(inradius, kShare1);
    const Matrix3<S> frame = FrameAlong<S>(axis);
    for (int i = 0; i < 3; ++i) {
      corners_[static_cast<std::size_t>(i)] = {frame * facet[i].point, kNoFeature, kNoFeature};
    }
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
    return CornerOf(SupportNear(set_1_.core, Point(pose_1_.rotation.transpose() * direction), hint_1_),
                    SupportNear(set_2_.core, Point(pose_2_.rotation.transpose() * -direction), hint_2_));
  }

  /// About the farthest one.
  Corner GuessAlong(const Point& direction) {
    return CornerOf(GuessSupport(set_1_.core, Point(pose_1_.rotation.transpose() * direction)),
                    GuessSupport(set_2_.core, Point(pose_2_.rotation.transpose() * -direction)));
  }

  Point NormalOfCorners() const {
    return (corners_[1].point - corners_[0].point).cross(corners_[2].point - corners_[0].point);
  }

  template <bool kIsCheck>
  End WalkFromLast(const Settings<S>& settings) {
    FindPlane();
    if (!IsSound()) return End::kNone;
    const int beside = CornerAcross();
    is_weighed_ = beside < 0;
    if (!is_weighed_ && radius_ > 0) {
      // Mostly by the edge itself.
      if (const std::optional<End> end = LeaveByEdge<kIsCheck>(settings)) return *end;
      normal_ = NormalOfCorners();
    } else if (!is_weighed_ && !StepOntoRay(beside)) {
      return End::kNone;
    }
    return WalkOn<kIsCheck>(settings, kMostFromLast);
  }

  /// From a triangle that the ray passes beside to one that it passes through.
  bool StepOntoRay(int beside) {
    for (;;) {
      if (iterations_ >= kMostFromLast || !StepOver(static_cast<std::size_t>(beside))) return false;
      FindPlane();
      if (!IsSound()) return false;
      beside = CornerAcross();
      if (beside < 0) return is_weighed_ = true;
    }
  }

  /// Of large hulls: whole walks without a support function, as far as looked-up points go. Of 241 to 4516 vertices,
  /// queries take 0.6 of the time that they take with support points from the first direction on.
  /// @param is_check  Whether a triangle beyond the ray's end is enough.
  [[gnu::noinline, gnu::flatten]] bool StartByGuesses(const Point& axis, bool is_check) {
    // Guesses that raise the triangle by less are left to the support functions; by measurement, with none and 1e-2
    // queries take as long.
    constexpr S kWorthwhile = S(1e-3);
    constexpr int kMost = 16;
    if (!SurroundRay<&FacetWalk::GuessAlong>(axis)) return false;
    for (int i = 0; i < kMost; ++i) {
      normal_ = NormalOfCorners();
      const S height = radius_ > 0 ? Height<true>() : Height<false>();
      if (!(height > 0)) return false;
      if (is_check && normal_.dot(ray_) <= height && LeavesByFacet()) return true;
      const Corner guess = GuessAlong(normal_);
      hint_1_ = guess.feature_1;
      hint_2_ = guess.feature_2;
      if (!(normal_.dot(guess.point - corners_[0].point) > kWorthwhile * height)) return true;
      if (!(radius_ > 0 ? Exchange<true>(guess) : Exchange<false>(guess))) return false;
    }
    return true;
  }

  /// Along the ray, and then twice tilted to the far side of the ray from what was found: by more where that was far
  /// away. With three corners near the ray, hulls of 14, 32, 241 and 2000 vertices take 3, 9, 19 and 20 % fewer
  /// directions than with normals from the ball on; with a spread of 1.2 or 2 up to 6 % more than with this one.
  /// @tparam kAlong  CornerAlong() or GuessAlong().
  /// @return false where rounding leaves no triangle about the ray.
  template <auto kAlong>
  bool SurroundRay(const Point& axis) {
    constexpr S kSpread = S(1.5);
    // With twice and four times as much, hulls of 241 vertices, ten times as long as thick, take 1 and 3 % more.
    constexpr S kNearSq = S(0.5);
    const Corner first = (this->*kAlong)(axis);
    const S height = axis.dot(first.point);
    const Point beside = first.point - height * axis;
    // Of skewed sets, what is farthest along the ray is far from it, and so is what is found like that.
    if (beside.squaredNorm() > kNearSq * height * height) return Exchange<false>(first);
    const Corner second = (this->*kAlong)(height * axis - kSpread * beside);
    const Point across = axis.cross(second.point - first.point);
    const S width_sq = across.squaredNorm(), side = across.dot(first.point);
    if (!Exchange<false>(first) || !Exchange<false>(second)) return false;
    if (!(width_sq > kEpsilon<S> * height * height)) return true;
    // Half the line's length at least, where that nearly meets the ray.
    const S tilt = kSpread * std::max(std::abs(side) / width_sq, S(0.5));
    return Exchange<false>((this->*kAlong)(height * axis - std::copysign(tilt, side) * across));
  }

  template <bool kIsCheck>
  End WalkOn(const Settings<S>& settings, int most_iterations) {
    return radius_ > 0 ? WalkRounded<kIsCheck>(settings, most_iterations)
                       : Walk<kIsCheck, false>(settings, most_iterations);
  }

  /// Not inlined: with its registers, a walk without a radius takes a tenth longer.
  template <bool kIsCheck>
  [[gnu::noinline, gnu::flatten]] End WalkRounded(const Settings<S>& settings, int most_iterations) {
    return Walk<kIsCheck, true>(settings, most_iterations);
  }

  /// From corners that the ray passes between, and their normal.
  template <bool kIsCheck, bool kRounded>
  End Walk(const Settings<S>& settings, int most_iterations) {
    for (;;) {
      const S height = Height<kRounded>();
      if (!(height > 0)) return End::kNone;  // The same corner twice: there is no normal.
      [[maybe_unused]] S along = 0;
      if constexpr (kIsCheck) {
        along = normal_.dot(ray_);
        if (along <= height && LeavesByFacet()) return End::kCommon;
      }
      const Corner farthest = CornerAlong(normal_);
      rise_ = normal_.dot(farthest.point - corners_[0].point);
      if (kIsCheck && along > height + rise_) return EndApart(farthest, along - height - rise_);
      if (rise_ <= settings.relative_tolerance * height) {
        if (!kRounded || LeavesByFacet()) return End::kExit;
        if (iterations_ >= most_iterations) return End::kNone;
        if (const std::optional<End> end = LeaveByEdge<kIsCheck>(settings)) return *end;
      } else if (iterations_ >= most_iterations || !Exchange<kRounded>(farthest)) {
        return End::kNone;
      }
      normal_ = NormalOfCorners();
    }
  }

  /// @param apart  Of the supporting planes, times the normal's length.
  End EndApart(const Corner& farthest, S apart) {
    length_ = normal_.norm();
    along_ = apart;
    corners_[0] = farthest;
    return End::kApart;
  }

  /// Of the corners' plane, times the normal's length; with a radius, of the plane moved by it.
  template <bool kRounded>
  S Height() {
    S height = normal_.dot(corners_[0].point);
    if constexpr (kRounded) {
      const S length = normal_.norm();
      height += radius_ * length;
      shift_ = radius_ / length * normal_;
    }
    return height;
  }

  /// Of the triangles that the new corner makes with two of the old ones, takes the one that the ray passes through.
  /// With a radius they are moved by that along the last normal, which is not quite their own: where the ray passes
  /// beside the old one, the new corner takes the place of the one across from there.
  /// @return false, and the corners as they were, where rounding leaves none.
  template <bool kRounded>
  bool Exchange(const Corner& added) {
    if constexpr (kRounded) {
      const Point across = ray_.cross(added.point + shift_);
      const auto turn = [&](std::size_t i) { return across.dot(corners_[i].point + shift_); };
      if (Exchange(added, turn(0), turn(1), turn(2))) return true;
      FindPlane();
      const int beside = CornerAcross();
      if (beside < 0) return false;
      Replace(static_cast<std::size_t>(beside), added);
      return true;
    } else {
      const Point across = ray_.cross(added.point);
      const S turn_0 = across.dot(corners_[0].point), turn_1 = across.dot(corners_[1].point),
              turn_2 = across.dot(corners_[2].point);
      return Exchange(added, turn_0, turn_1, turn_2);
    }
  }

  /// In any place, after which the normal may have to be turned towards the ray.
  void Replace(std::size_t corner, const Corner& added) {
    corners_[corner] = added;
    is_weighed_ = false;
    if (NormalOfCorners().dot(ray_) < 0) std::swap(corners_[0], corners_[1]);
  }

  bool Exchange(const Corner& added, S turn_0, S turn_1, S turn_2) {
    if (turn_0 >= 0 && turn_1 <= 0) {
      corners_[2] = added;
    } else if (turn_1 >= 0 && turn_2 <= 0) {
      corners_[0] = added;
    } else if (turn_2 >= 0 && turn_0 <= 0) {
      corners_[1] = added;
    } else {
      return false;
    }
    is_weighed_ = false;
    return true;
  }

  /// Of the corners, towards the ray.
  void FindPlane() {
    side_1_ = corners_[1].point - corners_[0].point;
    side_2_ = corners_[2].point - corners_[0].point;
    normal_ = side_1_.cross(side_2_);
    along_ = normal_.dot(ray_);
    if (along_ < 0) {
      std::swap(corners_[1], corners_[2]);
      std::swap(side_1_, side_2_);
      normal_ = -normal_;
      along_ = -along_;
    }
    length_sq_ = normal_.squaredNorm();
    length_ = std::sqrt(length_sq_);
    height_ = normal_.dot(corners_[0].point) + radius_ * length_;
  }

  /// Whether plain products keep the digits of the plane, and of weights on it. False for NaN.
  bool IsSound() const {
    const S longest_sq = std::max({side_1_.squaredNorm(), side_2_.squaredNorm(), (side_2_ - side_1_).squaredNorm()});
    const bool is_fat = length_sq_ > kFat * kFat * longest_sq * longest_sq;
    const bool is_flat = along_ * along_ > kFlat * kFlat * length_sq_ * ray_.squaredNorm();
    return is_fat && is_flat && height_ > 0;
  }

  /// Finds where the ray meets the plane, by the corners' weights.
  /// @return -1 if it leaves between them, else the corner across the side that it passes beyond.
  int CornerAcross() {
    const Point from_first = height_ / along_ * ray_ - radius_ / length_ * normal_ - corners_[0].point;
    weights_[1] = normal_.dot(from_first.cross(side_2_)) / length_sq_;
    weights_[2] = normal_.dot(side_1_.cross(from_first)) / length_sq_;
    weights_[0] = 1 - weights_[1] - weights_[2];
    const auto least = std::ranges::min_element(weights_);
    return *least >= 0 ? -1 : static_cast<int>(least - weights_.begin());
  }

  /// To a triangle beyond the side across from a corner: of the side, and a point that is farthest along the normal
  /// tilted towards there.
  bool StepOver(std::size_t corner) {
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

  /// Whether the ray is certain to leave between the corners, which are vertices.
  bool LeavesByFacet() {
    if (is_weighed_) return true;
    for (const Corner& corner : corners_) {
      if (corner.feature_1 == kNoFeature) return false;
    }
    FindPlane();
    return IsSound() && CornerAcross() < 0;
  }

  /// After LeavesByFacet(), with a radius: by the cylinder about the edge that the ray passes beyond. Rarer, and long.
  /// @return nothing if there is a corner beyond the edge, which takes part now.
  template <bool kIsCheck>
  [[gnu::noinline, gnu::flatten]] std::optional<End> LeaveByEdge(const Settings<S>& settings) {
    for (const Corner& corner : corners_) {
      if (corner.feature_1 == kNoFeature) return End::kNone;
    }
    if (!IsSound()) return End::kNone;
    const auto beyond = static_cast<std::size_t>(std::ranges::min_element(weights_) - weights_.begin());
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
    height_ = height;
    along_ = normal.dot(ray_);
    rise_ = rise;
    if (kIsCheck && along_ > height + rise) return EndApart(farthest, along_ - height - rise);
    weights_[beyond] = 0;
    weights_[a] = exit.weights[0];
    weights_[b] = exit.weights[1];
    is_weighed_ = true;
    return End::kExit;
  }

  bool HasInterior() const {
    return HasCertainInterior(set_1_, set_2_, set_1_.core.Vertex(corners_[0].feature_1),
                              set_2_.core.Vertex(corners_[0].feature_2));
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
    Point sum = weights_[0] * core.Vertex(corners_[0].*feature);
    for (std::size_t i = 1; i < 3; ++i) sum += weights_[i] * core.Vertex(corners_[i].*feature);
    return sum;
  }

  /// Not inlined: with its registers, a walk takes a tenth longer.
  [[gnu::noinline]] bool Report(const Settings<S>& settings, Result<S>& result) {
    if (!LeavesByFacet() || !HasInterior()) return false;
    const S support = height_ + rise_;
    if (along_ - support > settings.separation_limit * length_) return false;
    const Point normal = normal_ / length_;
    result.normal = normal;
    result.separation = (along_ - support) / length_;
    result.upper_bound = along_ / height_;
    result.lower_bound = along_ / std::max(support, height_);
    result.witness_1 = pose_1_.translation + OnSet1(normal);
    result.witness_2 = pose_2_.translation + OnSet2(normal);
    result.iterations = iterations_;
    result.status = Status::kOptimal;
    return IsFinite(result);
  }

  /// @param state  Out, if there is one.
  [[gnu::noinline]] bool Report(End end, WarmStart<S>* state, CollisionResult<S>& result) {
    result.iterations = iterations_;
    if (end == End::kApart) {
      const Corner& farthest = corners_[0];
      result.status = Status::kSeparated;
      result.normal = normal_ / length_;
      result.separation = along_ / length_;
      result.point =
          pose_1_ * set_1_.core.Vertex(farthest.feature_1) + (set_1_.radius + result.separation / 2) * result.normal;
    } else {
      if (end == End::kNone || !LeavesByFacet() || !HasInterior()) return false;
      result.status = along_ <= height_ ? Status::kColliding : Status::kTouching;
      result.normal = normal_ / length_;
      const Point center_1 = pose_1_.rotation * set_1_.core.Center();
      result.point = pose_1_.translation + center_1 + along_ / height_ * (OnSet1(result.normal) - center_1);
    }
    if (!IsFinite(result)) return false;
    if (state == nullptr) return true;
    RememberBasis(result.normal, *state);
    if (end == End::kApart) state->size = 0;
    return true;
  }

  void RememberBasis(const Point& normal, WarmStart<S>& state) const {
    RememberCorners(state);
    state.normal_1 = Normal1(normal);
    state.size = 3;
    state.known_size = 0;
  }

  void RememberCorners(WarmStart<S>& state) const {
    for (std::size_t i = 0; i < 3; ++i) {
      state.features_1[i] = corners_[i].feature_1;
      state.features_2[i] = corners_[i].feature_2;
    }
  }

  Point Normal1(const Point& normal) const { return (pose_1_.rotation.transpose() * normal).normalized(); }

  /// Twice the area over the longest side's square, and the normal's cosine to the ray. By their inverses, rounding is
  /// magnified.
  static constexpr S kFat = S(0.05), kFlat = S(0.05);
  /// Of the angle under which the facet's width is seen from the centre. By measurement: with 1, 2, 3 and 4 times as
  /// much, warm queries of hulls of 2000 vertices take 444, 370, 361 and 426 ns on average, of 241 240, 227, 234, 246.
  static constexpr S kTilt = S(2);

  const Set1& set_1_;
  const Pose<S>& pose_1_;
  const Set2& set_2_;
  const Pose<S>& pose_2_;
  const Point ray_;  // From centre 1 to centre 2, world.
  const S radius_;
  std::array<Corner, 3> corners_;
  FeatureId hint_1_ = kNoFeature, hint_2_ = kNoFeature;
  Point normal_;             // Of the corners, as long as twice the triangle's area.
  Point shift_;              // By the radius, along the normal.
  bool is_weighed_ = false;  // The ray leaves between the corners, with these weights. What follows is of them, too:
  std::array<S, 3> weights_;
  Point side_1_, side_2_;
  S along_, height_;  // Products of the normal with the ray, and with a point of the plane; with the radius.
  S length_sq_, length_;
  S rise_;  // Of the sets' support value over the plane of the corners, times the normal's length.
  int iterations_ = 0;
};

}  // namespace dgd
