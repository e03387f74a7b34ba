// An inner approximation of a convex set that holds the origin: the hull of some of its points, which grows where its
// border is nearest to the origin.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

#include "dgd/assert.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/types.h"

namespace dgd {

/// A closed surface of triangles. A new point replaces those that it is in front of and that hang together, found by
/// the edges that they share: there are no links between neighbours that roundoff could tear.
template <class S>
class EpaPolytope {
 public:
  using Feature = DifferencePoint<S, 3>;

  struct Face {
    Vector3<S> normal;                    ///< Outward, unit length; zero for a sliver.
    S distance;                           ///< Distance of its plane to the origin, metres; infinite for a sliver.
    S slack;                              ///< Roundoff of heights over it, metres; infinite for a sliver.
    std::array<std::uint8_t, 3> corners;  ///< Counterclockwise seen from outside.

    S Height(const Vector3<S>& point) const { return normal.dot(point) - distance; }
  };

  /// @param corners   Corners of a tetrahedron that holds the origin, but for roundoff.
  /// @param roundoff  Roundoff of the points, metres.
  /// @param reach     Distance of the points from each other, about; metres.
  /// @param error     How far the points may be off the set, metres, at least the roundoff: for Add() alone.
  EpaPolytope(const std::array<Feature, 4>& corners, S roundoff, S reach, S error)
      : roundoff_(roundoff), reach_(reach), error_(error), size_(4) {
    DGD_ASSERT(!(roundoff < 0) && !(reach < 0));
    std::copy(corners.begin(), corners.end(), points_.begin());
    const auto to = [&](std::size_t i) -> Vector3<S> { return points_[i].point - points_[0].point; };
    if (to(1).cross(to(2)).dot(to(3)) > 0) std::swap(points_[0], points_[1]);
    AddFace(0, 1, 2);
    AddFace(0, 3, 1);
    AddFace(1, 3, 2);
    AddFace(2, 3, 0);
    FindNearest();
  }

  /// Whether the face has no plane, being too narrow.
  static bool IsSliver(const Face& face) { return !(face.distance < std::numeric_limits<S>::infinity()); }

  /// Radius of a ball about the origin that the surface is outside of; negative if the origin is, by roundoff.
  S Inradius() const {
    S inradius = Nearest().distance;
    if (!has_slivers_) return inradius;
    std::for_each(faces_.begin(), End(), [&](const Face& face) {
      if (!IsSliver(face)) return;
      const S distance = GjkSimplex<S>(CornersOf(face), 3).Nearest().norm();
      inradius = std::min(inradius, std::max(S(0), distance - kNarrow * roundoff_));  // 0 for NaN.
    });
    return inradius;
  }

  /// A face whose plane is nearest to the origin.
  const Face& Nearest() const {
    DGD_ASSERT(nearest_ < face_count_);
    return faces_[nearest_];
  }

  /// The nearest face among those that look aside from a unit vector, by their normals' cosine to it; null if there is
  /// none.
  const Face* NearestAside(const Vector3<S>& direction, S most_cosine) const {
    const Face* nearest = nullptr;
    S least = std::numeric_limits<S>::infinity();
    std::for_each(faces_.begin(), End(), [&](const Face& face) {
      if (!(face.distance < least) || face.normal.dot(direction) > most_cosine) return;
      least = face.distance;
      nearest = &face;
    });
    return nearest;
  }

  /// The nearest face among those that look along a unit vector; a sliver if there is none.
  Face NearestAlong(const Vector3<S>& direction, S least_cosine) const {
    Face nearest{Vector3<S>::Zero(), std::numeric_limits<S>::infinity(), 0, {}};
    std::for_each(faces_.begin(), End(), [&](const Face& face) {
      if (face.distance < nearest.distance && face.normal.dot(direction) > least_cosine) nearest = face;
    });
    return nearest;
  }

  std::array<Feature, 3> CornersOf(const Face& face) const {
    const auto corner = [&](std::size_t i) { return points_[face.corners[i]].ToFeature(); };
    return {corner(0), corner(1), corner(2)};
  }

  /// Leaves the features of its points for another search: those of the first tetrahedron first, then the last ones
  /// that there is room for.
  void Leave(WarmStart<S>& state) const {
    const std::size_t room = state.features_1.size();
    const std::size_t left_out = size_ > room ? size_ - room : 0;
    state.size = 0;
    for (std::size_t i = 0; i < size_ - left_out; ++i) {
      const Point& point = points_[i < 4 ? i : i + left_out];
      state.Add(point.feature_1, point.feature_2);
    }
  }

  bool IsFull() const { return size_ == kMaxPoints; }

  /// The point of the surface that is nearest to a point on or outside of it.
  Feature NearestTo(const Vector3<S>& target) const {
    Feature nearest = TriangleNearestTo(target).Combination();
    nearest.point += target;
    return nearest;
  }

  /// The part of the surface that is nearest to a point outside of it, or on it within the points' error, about that.
  GjkSimplex<S> TriangleNearestTo(const Vector3<S>& target) const {
    GjkSimplex<S> nearest;
    S least = std::numeric_limits<S>::infinity();
    const auto take_if_nearer = [&](const Face& face) {
      std::array<Feature, 3> corners = CornersOf(face);
      for (Feature& corner : corners) corner.point -= target;
      const GjkSimplex<S> triangle(corners, 3);
      const S distance_sq = triangle.Nearest().squaredNorm();
      if (!(distance_sq < least)) return;
      least = distance_sq;
      nearest = triangle;
    };
    take_if_nearer(Nearest());  // Should points be off by more than they say, and the target below all faces.
    std::for_each(faces_.begin(), End(), [&](const Face& face) {
      if (!(face.Height(target) < -face.slack - error_)) take_if_nearer(face);
    });
    DGD_ASSERT(nearest.Size() > 0 || std::isnan(target.sum()));
    return nearest;
  }

  /// Takes in a point of the set.
  /// @return false, and nothing changes, if the point is not in front of any face by more than the points' error, or
  ///         there is no room for it.
  bool Add(const Feature& added) {
    if (size_ == kMaxPoints) return false;
    Visible visible;
    if (!(FindVisible(added.point, visible) > error_)) return false;
    Hole hole;
    const std::size_t replaced = CollectReplaced(visible, hole);
    if (replaced == face_count_) return false;
    // A surface without holes has room for as many faces as its points can make; one that roundoff has torn may not.
    if (face_count_ - replaced + hole.rim_size > kMaxFaces) return false;
    // The order descends, so that the last face, which takes a replaced one's place, stays.
    std::sort(visible.faces.begin(), visible.faces.begin() + replaced, std::greater<>());
    for (std::size_t i = 0; i < replaced; ++i) faces_[visible.faces[i]] = faces_[--face_count_];
    points_[size_] = added;
    const auto apex = static_cast<std::uint8_t>(size_);
    hole.ForEachRimEdge([&](std::uint8_t from, std::uint8_t to) { AddFace(from, to, apex); });
    ++size_;
    FindNearest();
    return true;
  }

 private:
  /// A Feature without initial values, which would take longer for all points than a short search does.
  struct Point {
    Point() = default;
    Point(const Feature& of) : point(of.point), on_1(of.on_1), feature_1(of.feature_1), feature_2(of.feature_2) {}
    Feature ToFeature() const { return {point, on_1, feature_1, feature_2}; }

    Vector3<S> point, on_1;
    FeatureId feature_1, feature_2;
  };

  static constexpr S kNarrow = 4;                           // Width of a sliver, in units of the points' roundoff.
  static constexpr std::size_t kMaxPoints = 64;             // There are as many as an edge has bits.
  static constexpr std::size_t kMaxFaces = 2 * kMaxPoints;  // A closed surface has 2 n - 4.

  auto End() const { return faces_.begin() + static_cast<std::ptrdiff_t>(face_count_); }
  auto End() { return faces_.begin() + static_cast<std::ptrdiff_t>(face_count_); }

  /// The faces that a point is in front of, or in the plane of.
  struct Visible {
    std::array<std::uint8_t, kMaxFaces> faces;  ///< Their indices; that of the highest one first.
    std::size_t size = 0;
  };

  /// The edges of the faces that a point replaces.
  struct Hole {
    void AddEdges(const Face& face) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint8_t from = face.corners[i], to = face.corners[(i + 1) % 3];
        if ((corners & Bit(from)) == 0) edges[from] = 0;
        corners |= Bit(from);
        // A surface that roundoff has torn may have an edge twice.
        if ((edges[from] & Bit(to)) != 0) continue;
        edges[from] |= Bit(to);
        if (HasEdge(to, from)) {
          --rim_size;
        } else {
          ++rim_size;
        }
      }
    }
    bool HasEdge(std::uint8_t from, std::uint8_t to) const {
      return (corners & Bit(from)) != 0 && (edges[from] & Bit(to)) != 0;
    }
    /// Whether a face has an edge in common with those whose edges were added.
    bool IsNeighbour(const Face& face) const {
      const auto [a, b, c] = face.corners;
      return HasEdge(b, a) || HasEdge(c, b) || HasEdge(a, c);
    }
    /// Visits the edges between a replaced face and one that stays.
    template <class Visit>
    void ForEachRimEdge(const Visit& visit) const {
      for (std::uint64_t left = corners; left != 0; left &= left - 1) {
        const auto from = static_cast<std::uint8_t>(std::countr_zero(left));
        for (std::uint64_t rest = edges[from]; rest != 0; rest &= rest - 1) {
          const auto to = static_cast<std::uint8_t>(std::countr_zero(rest));
          if (!HasEdge(to, from)) visit(from, to);
        }
      }
    }

    std::array<std::uint64_t, kMaxPoints> edges;  ///< Bit b of [a], for corners a: a face has the edge from a to b.
    std::uint64_t corners = 0;                    ///< Bit a: an edge begins at point a.
    std::size_t rim_size = 0;                     ///< Edges without the opposite one: what ForEachRimEdge() visits.
  };

  /// @return the height of a point over the plane that it is farthest in front of, metres.
  S FindVisible(const Vector3<S>& point, Visible& visible) const {
    S highest = -std::numeric_limits<S>::infinity();
    for (std::size_t i = 0; i < face_count_; ++i) {
      const S height = faces_[i].Height(point);
      // Faces whose plane the point is in are replaced, too: next to one that stays, it may be in line with its edge.
      // So are slivers, of -infinite height.
      if (height < -faces_[i].slack) continue;
      visible.faces[visible.size++] = static_cast<std::uint8_t>(i);
      if (!(height > highest)) continue;
      highest = height;
      std::swap(visible.faces[0], visible.faces[visible.size - 1]);
    }
    return highest;
  }

  /// Moves the visible faces that hang together with the first one to the beginning, and adds their edges.
  /// @return how many there are.
  std::size_t CollectReplaced(Visible& visible, Hole& hole) const {
    hole.AddEdges(faces_[visible.faces[0]]);
    std::size_t count = 1;
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t i = count; i < visible.size; ++i) {
        const Face& face = faces_[visible.faces[i]];
        if (!hole.IsNeighbour(face)) continue;
        hole.AddEdges(face);
        std::swap(visible.faces[i], visible.faces[count++]);
        has_grown = true;
      }
    }
    return count;
  }

  void FindNearest() {
    nearest_ = 0;
    for (std::size_t i = 1; i < face_count_; ++i) {
      if (faces_[i].distance < faces_[nearest_].distance) nearest_ = i;
    }
  }

  static std::uint64_t Bit(std::uint8_t point) { return std::uint64_t(1) << point; }

  void AddFace(std::uint8_t a, std::uint8_t b, std::uint8_t c) {
    DGD_ASSERT(a <= size_ && b <= size_ && c <= size_ && size_ <= kMaxPoints);
    DGD_ASSERT(face_count_ < kMaxFaces);
    Face& face = faces_[face_count_++];
    face.corners = {a, b, c};
    const Vector3<S>& origin = points_[a].point;
    const Vector3<S> to_b = points_[b].point - origin, to_c = points_[c].point - origin;
    Vector3<S> cross = to_b.cross(to_c);
    const S longest = std::sqrt(std::max({to_b.squaredNorm(), to_c.squaredNorm(), (to_c - to_b).squaredNorm()}));
    S area = cross.norm();  // Twice.
    constexpr S kThin = S(0.1);
    if (area < kThin * longest * longest) {
      Straighten(cross, to_b, to_c);
      area = cross.norm();
    }
    // Narrower than that, a face's corners may as well be in line.
    if (area > kNarrow * roundoff_ * longest) {
      const S inverse = 1 / area;
      face.normal = inverse * cross;
      face.distance = face.normal.dot(origin);
      face.slack = roundoff_ * (1 + reach_ * longest * inverse);
    } else {
      face.normal.setZero();
      face.distance = std::numeric_limits<S>::infinity();
      face.slack = std::numeric_limits<S>::infinity();
      has_slivers_ = true;
    }
  }

  S roundoff_, reach_, error_;
  bool has_slivers_ = false;  // Or had.
  std::size_t size_, face_count_ = 0, nearest_ = 0;
  std::array<Point, kMaxPoints> points_;
  std::array<Face, kMaxFaces> faces_;
};

}  // namespace dgd
