// The inner approximation: the feature of conv(support points) + ball through which the ray leaves it.
//
// The paper (Sec. III-C2) keeps a basis of three points of C whose triangle the ray crosses, and replaces one of them
// by the new support point with a step of the simplex method. We depart from it where the sets have a radius R:
//
//   Rounded inner approximation. C = K + ball(R), K the difference of the cores. For any points S of K, conv(S) +
//   ball(R) lies in C, so the height at which the ray leaves it is a lower bound on the ray intersection. The ray
//   leaves it on the offset of exactly one feature of conv(S): a vertex (a ball of radius R), an edge (a cylinder) or a
//   triangle (a plane), and the normal there is the next direction to search. Each has a closed form.
//
//   Update. Let h be the old height, reached on a feature F with normal n, and w the support point of K along n. If
//   <n, w> exceeds the value on F, the old exit point is interior to conv(F, w) + ball(R), so the ray now leaves it
//   higher, and through a feature that has w among its vertices: one without w belongs to conv(F) and cannot be higher
//   than h. The new basis is therefore the highest of the features of conv(F, w) that contain w and that the ray
//   crosses (at most three triangles, three edges and w itself). Otherwise F is optimal.
//
//   Termination. Heights rise strictly and K of a polytope pair has finitely many vertices, so rounded polytopes end
//   after finitely many steps, as sharp ones do; with the ball in the support function they only converge in the limit.
//
// Without a radius only triangles can carry the ray, and the update is the paper's simplex step: the plane is divided
// by the rays from the origin through the three projected points, and -w lies in one of the three wedges; the two
// points that span it stay. That is the ratio test (eq. outgoing index) in barycentric coordinates of the projected
// points.
//
// All coordinates are in the ray frame: x, y across the ray, z the height along it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/tolerances.h"
#include "dgd/ray/triangle_crossing.h"

namespace dgd {

template <class S>
class InnerApproximation {
 public:
  /// Starts at the difference of the centres, which belongs to the cores' difference: for rounding > 0.
  static InnerApproximation FromCenter(S rounding) {
    InnerApproximation approximation;
    approximation.rounding_ = rounding;
    approximation.size_ = 1;
    approximation.weights_ = {1, 0, 0};
    approximation.height_ = rounding;
    return approximation;
  }

  /// Starts with a triangle in the ball of `inradius` inside C (paper, eq. inner-approximation-initialization), for
  /// sets without rounding. Set 1 contributes `share_1` of each point.
  static InnerApproximation FromInradius(S inradius, S share_1) {
    // The ray crosses the triangle's middle half way up the ball.
    const S height = inradius / 2;
    const S lateral = std::sqrt(S(0.75)) * inradius;
    InnerApproximation approximation;
    approximation.size_ = 3;
    const S cosines[3] = {1, S(-0.5), S(-0.5)};
    const S sines[3] = {0, std::sqrt(S(0.75)), -std::sqrt(S(0.75))};
    for (std::size_t i = 0; i < 3; ++i) {
      DifferencePoint<S>& corner = approximation.points_[i];
      corner.point = {lateral * cosines[i], lateral * sines[i], height};
      corner.on_1 = share_1 * corner.point;
    }
    approximation.weights_ = {S(1) / 3, S(1) / 3, S(1) / 3};
    approximation.height_ = height;
    return approximation;
  }

  /// Adds a point of the cores' difference and keeps the feature through which the ray now leaves.
  /// @return whether the approximation changed; its height never falls. False also where rounding leaves no feature.
  bool Insert(const DifferencePoint<S>& added) { return rounding_ > 0 ? InsertRounded(added) : InsertSharp(added); }

  /// Takes over a whole basis, one to three points of the cores' difference that were the feature of an earlier query,
  /// if the ray leaves through the same feature, not lower than so far.
  bool AdoptBasis(const std::array<DifferencePoint<S>, 3>& basis, int size) {
    if (size < 1 || (rounding_ == 0 && size < 3)) return false;
    const Vector3<S>& a = basis[0].point;
    Exit exit;
    const bool found = size == 3   ? TriangleExit(a, basis[1].point, basis[2].point, exit)
                       : size == 2 ? EdgeExit(a, basis[1].point, exit)
                                   : VertexExit(a, exit);
    if (!found || !(exit.height >= height_)) return false;
    points_ = basis;
    Adopt(exit);
    return true;
  }

  /// Lower bound on the height at which the ray leaves C, metres.
  S Height() const { return height_; }
  /// Outward unit normal of the approximation where the ray leaves it; z > 0 but for rounding.
  const Vector3<S>& Normal() const { return normal_; }
  /// Points of the feature, Size() of them, counterclockwise about the ray if three.
  const DifferencePoint<S>& operator[](int i) const { return points_[static_cast<std::size_t>(i)]; }
  int Size() const { return size_; }

  /// The cores' points whose difference is the feature's point under the exit: convex combinations (eq.
  /// primal-optimal).
  Vector3<S> CorePoint1() const {
    return Combine([](const DifferencePoint<S>& point) { return point.on_1; });
  }
  Vector3<S> CorePoint2() const {
    return Combine([](const DifferencePoint<S>& point) -> Vector3<S> { return point.on_1 - point.point; });
  }

 private:
  /// Where the ray leaves the offset of one feature.
  struct Exit {
    S height = -1;  // Below any real one: no exit found.
    Vector3<S> normal = Vector3<S>::UnitZ();
    std::array<S, 3> weights{};          // Of the feature's points, convex.
    std::array<int, 2> kept = {-1, -1};  // Which basis points those are; the added point comes last.
    int size = 0;
  };

  template <class Part>
  Vector3<S> Combine(Part part) const {
    Vector3<S> sum = weights_[0] * part(points_[0]);
    for (std::size_t i = 1; i < static_cast<std::size_t>(size_); ++i) sum += weights_[i] * part(points_[i]);
    return sum;
  }

  /// Turns a triangle's normal upwards and to unit length; false if the ray sees the triangle edge-on.
  static bool PointUpwards(Vector3<S>& normal) {
    const S length = normal.norm();
    if (!(length > 0)) return false;
    normal *= std::copysign(1 / length, normal.z());
    return normal.z() > 0;
  }

  /// Offset triangle: the plane through a, b and c, moved by R along its normal; false if the ray passes it by, or sees
  /// it edge-on. Computed the plain way first, and with care where that is not certain.
  bool TriangleExit(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c, Exit& exit) const {
    exit.normal = (b - a).cross(c - a);
    const S area = std::abs(exit.normal.z());
    if (!PointUpwards(exit.normal)) return SliverExit(a, b, c, exit);
    // The plane moves sideways by the normal's lateral part, and the triangle's border with it.
    const Vector3<S> shift = rounding_ * exit.normal;
    const Vector3<S> shifted_a = a + shift, shifted_b = b + shift, shifted_c = c + shift;
    const S reach = std::max({ray_internal::LateralL1<S>(shifted_a), ray_internal::LateralL1<S>(shifted_b),
                              ray_internal::LateralL1<S>(shifted_c)});
    if (!(area > kSliver<S> * reach * reach)) return SliverExit(a, b, c, exit);
    switch (ray_internal::Weigh(shifted_a, shifted_b, shifted_c, kWeightSlack<S> * reach * (reach + rounding_),
                                exit.weights)) {
      case ray_internal::Crossing::kNo:
        return false;
      case ray_internal::Crossing::kUncertain:
        return SliverExit(a, b, c, exit);
      case ray_internal::Crossing::kYes:
        SetTriangleHeight(shifted_a.z(), shifted_b.z(), shifted_c.z(), exit);
    }
    return true;
  }

  /// As TriangleExit(), for slivers and for rays along a border: the basis changes there by the last digits, and all
  /// triangles on an edge must agree about the side of it on which the ray is.
  [[gnu::cold, gnu::noinline]] bool SliverExit(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c,
                                               Exit& exit) const {
    const ray_internal::SliverNormal<S> normal(a, b, c);
    exit.normal = normal.cross;
    if (!PointUpwards(exit.normal)) return false;
    const Vector3<S> shift = rounding_ * exit.normal;
    const Vector3<S> shifted_a = a + shift, shifted_b = b + shift, shifted_c = c + shift;
    const S area = std::abs(normal.cross.z()), border_error = rounding_ * normal.error;
    if (!ray_internal::WeighSliver(shifted_a, shifted_b, shifted_c, area, border_error, exit.weights)) return false;
    SetTriangleHeight(shifted_a.z(), shifted_b.z(), shifted_c.z(), exit);
    return true;
  }

  static void SetTriangleHeight(S a, S b, S c, Exit& exit) {
    exit.height = exit.weights[0] * a + exit.weights[1] * b + exit.weights[2] * c;
    exit.size = 3;
  }

  /// Offset edge: the cylinder about the segment from a to b.
  bool EdgeExit(const Vector3<S>& a, const Vector3<S>& b, Exit& exit) const {
    const Vector3<S> d = b - a;
    const S lateral_sq = d.x() * d.x() + d.y() * d.y();
    if (!(lateral_sq > 0)) return false;  // Along the ray: its upper end is higher.
    // Nearest approach of the edge's line to the ray, at parameter t0, and the offset's half width there.
    const S cross = ray_internal::Cross<S>(a, d);
    const S half_width_sq = rounding_ * rounding_ - cross * cross / lateral_sq;
    if (!(half_width_sq > 0)) return false;
    const S t0 = -(a.x() * d.x() + a.y() * d.y()) / lateral_sq;
    const S length = std::sqrt(lateral_sq + d.z() * d.z());
    const S lateral = std::sqrt(lateral_sq);
    const S half_width = std::sqrt(half_width_sq);
    S t = t0 + half_width * d.z() / (lateral * length);
    if (!(t >= -kWeightSlack<S> && t <= 1 + kWeightSlack<S>)) return false;
    t = t < 0 ? S(0) : t > 1 ? S(1) : t;
    exit.height = a.z() + t0 * d.z() + half_width * length / lateral;
    // Of a part across the edge and the ray, and a part in their plane: orthogonal to the edge to the last digit also
    // where the radius is small, which -(a + t * d) / R is not.
    const S across = cross / (rounding_ * lateral_sq);
    const S along = -half_width * d.z() / (rounding_ * lateral * length);
    exit.normal = {along * d.x() - across * d.y(), along * d.y() + across * d.x(),
                   half_width * lateral / (rounding_ * length)};
    exit.weights = {1 - t, t, 0};
    exit.size = 2;
    return true;
  }

  /// Offset vertex: the ball about a.
  bool VertexExit(const Vector3<S>& a, Exit& exit) const {
    const S half_width_sq = rounding_ * rounding_ - a.x() * a.x() - a.y() * a.y();
    if (!(half_width_sq > 0)) return false;
    const S half_width = std::sqrt(half_width_sq);
    exit.height = a.z() + half_width;
    exit.normal = Vector3<S>(-a.x(), -a.y(), half_width) / rounding_;
    exit.weights = {1, 0, 0};
    exit.size = 1;
    return true;
  }

  /// The basis point that the added one most likely replaces: the one whose wedge does not hold -added. `shift` moves
  /// all points across the ray.
  int OutgoingIndex(const Vector3<S>& added, const Vector3<S>& shift) const {
    const Vector3<S> w = added + shift;
    const S turn_0 = ray_internal::Cross<S>(w, points_[0].point + shift);
    const S turn_1 = ray_internal::Cross<S>(w, points_[1].point + shift);
    const S turn_2 = ray_internal::Cross<S>(w, points_[2].point + shift);
    if (turn_0 >= 0 && turn_1 <= 0) return 2;
    if (turn_1 >= 0 && turn_2 <= 0) return 0;
    return 1;
  }

  const Vector3<S>& PointOf(int i) const { return points_[static_cast<std::size_t>(i)].point; }

  bool InsertRounded(const DifferencePoint<S>& added) {
    const Vector3<S>& w = added.point;
    Exit best, exit;
    const auto keep_higher = [&](int i, int j) {
      if (!(exit.height > best.height)) return;
      best = exit;
      best.kept = {i, j};
    };
    if (size_ == 3) {
      // Most steps end here: the likely triangle carries the ray and the dropped point lies below it.
      const int outgoing = OutgoingIndex(w, rounding_ * normal_);
      for (int turn = 0; turn < 3; ++turn) {
        const int dropped = (outgoing + turn) % 3, i = (outgoing + turn + 1) % 3, j = (outgoing + turn + 2) % 3;
        if (!TriangleExit(PointOf(i), PointOf(j), w, exit)) continue;
        keep_higher(i, j);
        const bool is_done = exit.height >= height_ && exit.normal.dot(PointOf(dropped) - w) <= 0;
        if (turn == 0 && is_done) return Replace(best, added);
      }
    } else if (size_ == 2 && TriangleExit(PointOf(0), PointOf(1), w, exit)) {
      keep_higher(0, 1);
      if (exit.height >= height_) return Replace(best, added);
    }
    for (int i = 0; i < size_; ++i) {
      if (EdgeExit(PointOf(i), w, exit)) keep_higher(i, -1);
    }
    if (VertexExit(w, exit)) keep_higher(-1, -1);
    return Replace(best, added);
  }

  bool InsertSharp(const DifferencePoint<S>& added) {
    // The ratio test names the triangle, but for ties and rounding where the ray meets an edge or a corner of the
    // basis, or the added point is opposite to one. Several triangles carry the ray then, at one height but for
    // rounding: it is one with the dropped point below it, and of those the flattest, which magnifies the rounding
    // least.
    const int outgoing = OutgoingIndex(added.point, Vector3<S>::Zero());
    Exit best, exit;
    bool best_is_outside = false;
    for (int turn = 0; turn < 3; ++turn) {
      const int dropped = (outgoing + turn) % 3;
      exit.kept = {(dropped + 1) % 3, (dropped + 2) % 3};
      if (!TriangleExit(PointOf(exit.kept[0]), PointOf(exit.kept[1]), added.point, exit)) continue;
      const bool is_outside = exit.normal.dot(PointOf(dropped) - added.point) <= 0;
      if (is_outside && exit.normal.z() > kSteep<S>) return Replace(exit, added);
      const bool better = is_outside != best_is_outside ? is_outside
                          : is_outside                  ? exit.normal.z() > best.normal.z()
                                                        : exit.height > best.height;
      if (best.size == 0 || better) {
        best = exit;
        best_is_outside = is_outside;
      }
    }
    return best.size > 0 && Replace(best, added);
  }

  /// Makes the kept points and the added one the basis, unless that is lower by more than rounding; the bound itself is
  /// monotone. Equal heights are taken: where the ray meets an edge of the basis, a simplex step turns the plane
  /// without raising it, and may lower it by rounding many times on the way to the right plane.
  bool Replace(const Exit& exit, const DifferencePoint<S>& added) {
    if (!(exit.height >= height_) && !(exit.height >= height_ - HeightRounding(exit, added.point))) return false;
    // The kept points go to the front; i < j cyclically, so they may have to move in either order.
    std::array<DifferencePoint<S>, 2> kept;
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(exit.size); ++i) {
      kept[i] = points_[static_cast<std::size_t>(exit.kept[i])];
    }
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(exit.size); ++i) points_[i] = kept[i];
    points_[static_cast<std::size_t>(exit.size - 1)] = added;
    Adopt(exit);
    return true;
  }

  /// Takes over the exit of the points that are now the basis.
  void Adopt(const Exit& exit) {
    weights_ = exit.weights;
    size_ = exit.size;
    height_ = std::max(height_, exit.height);
    normal_ = exit.normal;
    // Counterclockwise about the ray, which OutgoingIndex relies on.
    if (size_ == 3 && ray_internal::Cross<S>(PointOf(1) - PointOf(0), PointOf(2) - PointOf(0)) < 0) {
      std::swap(points_[0], points_[1]);
      std::swap(weights_[0], weights_[1]);
    }
  }

  /// How much lower than now an exit may be by rounding: the error of the points' coordinates across the ray, up the
  /// slope of the steeper plane.
  S HeightRounding(const Exit& exit, const Vector3<S>& added) const {
    S reach = added.cwiseAbs().maxCoeff();
    for (const DifferencePoint<S>& point : points_) reach = std::max(reach, point.point.cwiseAbs().maxCoeff());
    return kWeightSlack<S> * reach / std::min(exit.normal.z(), normal_.z());
  }

  std::array<DifferencePoint<S>, 3> points_;
  std::array<S, 3> weights_{};
  Vector3<S> normal_ = Vector3<S>::UnitZ();
  S rounding_ = 0;
  S height_ = 0;
  int size_ = 0;
};

}  // namespace dgd
