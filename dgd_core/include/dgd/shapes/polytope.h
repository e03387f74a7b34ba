// A polytope given by its vertices. Makes the hull once, when it is made; immutable after, so threads may share it.
#pragma once

#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "dgd/assert.h"
#include "dgd/contact/supporting_face.h"
#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/point_facet.h"
#include "dgd/shapes/hull_queries.h"
#include "dgd/shapes/vertex_climb.h"
#include "dgd/shapes/vertex_scan.h"

namespace dgd {

/// @tparam kMostScanned  Hulls of more vertices are climbed.
template <class S, VertexId kMostScanned = kMostScannedVertices>
class Polytope {
 public:
  using Scalar = S;

  /// @param points  Metres; at least one, all finite, in any order; inner and duplicate points are dropped. Flat ones
  ///                are allowed and have inradius 0. Throws std::invalid_argument otherwise.
  explicit Polytope(std::span<const Eigen::Vector3d> points) : Polytope(BuildConvexHull(points)) {}
  /// @param hull  May have no facets yet: all vertices are scanned then, and support faces searched for. Float is not
  ///              exact enough for that, and has the facets built.
  explicit Polytope(ConvexHull hull)
      : hull_(kMayLackFacets || HasFacets(hull) ? std::move(hull) : WithFacets(hull)),
        climb_(MustClimb(hull_) ? VertexClimb<S>(hull_) : VertexClimb<S>()),
        scan_(climb_.IsEmpty() ? hull_.vertices : Vertices()),
        center_(hull_.center.template cast<S>()),
        inradius_(InradiusOfRounded<S>(hull_)),
        spread_(SpreadOfVertices(hull_).template cast<S>()),
        faces_(NeedsFaces() ? FacePlanesOf<S>(hull_) : Faces()) {}

  SupportPoint<S> Support(const Vector3<S>& direction) const { return Support(direction, kNoFeature); }
  /// @param hint  A vertex that is likely to be near, for large hulls; any number will do.
  SupportPoint<S> Support(const Vector3<S>& direction, FeatureId hint) const {
    const VertexId vertex = climb_.IsEmpty() ? scan_.Farthest(direction) : climb_.Farthest(direction, hint);
    return {Vertex(vertex), vertex};
  }
  /// See GuessingCore. Small hulls are not guessed: of 8 to 20 vertices, a scan takes no longer.
  SupportPoint<S> GuessSupport(const Vector3<S>& direction) const {
    const VertexId vertex = climb_.IsEmpty() ? scan_.Farthest(direction) : climb_.Start(direction);
    return {Vertex(vertex), vertex};
  }
  bool IsGuessing() const { return !climb_.IsEmpty(); }
  /// See ScannedCore.
  const PointArrays<S>* Scan() const { return climb_.IsEmpty() ? &scan_ : nullptr; }
  /// See LinkedCore. @pre IsLinked().
  EdgeSlope<S> SteepestAscent(VertexId vertex, const Vector3<S>& up, const Vector3<S>& outwards) const {
    return climb_.SteepestAscent(vertex, up, outwards);
  }
  bool IsLinked() const { return !climb_.IsEmpty(); }
  const Vector3<S>& Center() const { return center_; }
  S Inradius() const { return inradius_; }
  /// See SpreadCore.
  const Matrix3<S>& Spread() const { return spread_; }
  /// See SharedCenteredCore. Flat and long hulls move their centre if they have facets, and not too many of them.
  bool MovesCenter() const { return !faces_.empty(); }
  InnerBall<S> BallNear(const Vector3<S>& point) const {
    const InnerBall<S> ball{center_, inradius_};
    return MovesCenter() ? dgd::BallNear<S, 3>(faces_, ball, point) : ball;
  }

  Vector3<S> Vertex(VertexId vertex) const {
    DGD_ASSERT(vertex < hull_.vertices.size());
    return hull_.vertices[vertex].template cast<S>();
  }
  VertexId VertexCount() const { return static_cast<VertexId>(hull_.vertices.size()); }

  /// Facets, normals and adjacency, in double whatever S is.
  const ConvexHull& Hull() const { return hull_; }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector3<S>& direction) const {
    return static_cast<S>(SupportValueOf(hull_, direction.template cast<double>()));
  }

  /// Distance of `point` to the core, metres; 0 inside. Looks at every facet: for certificates.
  S Distance(const Vector3<S>& point) const { return static_cast<S>(DistanceTo(hull_, point.template cast<double>())); }

  /// The facet around the support vertex whose normal is nearest to `direction`; for hulls below dimension 2 the whole
  /// hull.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
    const VertexId vertex = Support(direction).feature;
    if constexpr (kMayLackFacets) {
      if (!HasFacets(hull_)) {
        AddVertices(hull_, FindFacet(hull_.vertices, scan_, vertex, direction).Vertices(), vertex, face);
        return;
      }
    }
    AddSupportFace(hull_, vertex, direction, face);
  }

 private:
  using Vertices = std::vector<Eigen::Vector3d>;
  using Faces = std::vector<FacePlane<S>>;

  /// A search of more facets takes longer than a query.
  static constexpr std::size_t kMostFaces = 128;

  static constexpr bool kMayLackFacets = std::is_same_v<S, double>;

  static bool MustClimb(const ConvexHull& hull) {
    return hull.dimension == 3 && HasFacets(hull) && hull.vertices.size() > kMostScanned;
  }

  bool NeedsFaces() const {
    return inradius_ > 0 && hull_.normals.size() <= kMostFaces && IsElongated(SpreadOfVertices(hull_));
  }

  ConvexHull hull_;
  VertexClimb<S> climb_;  // One of these two is empty.
  PointArrays<S> scan_;
  Vector3<S> center_;
  S inradius_;
  Matrix3<S> spread_;
  Faces faces_;  // Empty if the centre stays.
};

/// A polytope that climbs along its edges from one vertex on, as a Polytope does from kMostScannedVertices on.
template <class S>
using Mesh = Polytope<S, 0>;

}  // namespace dgd
