// What the solver requires of a convex set, and the set it works on: a core with a radius.
//
// A set is core + ball(radius). The core is any type that fulfils ConvexCore; the radius is kept apart from it because
// a rounded polytope then still has finitely many features (see solver/inner_approximation.h), which it has not when
// the ball goes into the support function.
#pragma once

#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "dgd/inlining.h"
#include "dgd/types.h"

namespace dgd {

/// The dimension of the space that a core lives in, 3 or 2. It is constrained, so that what has no centre is no
/// ConvexCore rather than an error, as in `RoundedSet ball = Sphere(1.0)`.
template <class Core>
requires requires(const Core& core) { core.Center(); }
inline constexpr int kDimension =
    std::remove_cvref_t<decltype(std::declval<const Core&>().Center())>::RowsAtCompileTime;

/// A point or direction in a core's frame, and in the world.
template <class Core>
using VectorOf = Vector<typename Core::Scalar, kDimension<Core>>;

/// A compact convex set in its own frame, of two or three dimensions. All members are const, allocate nothing and do
/// not throw.
///  * Support(d): a point of the core that maximises <d, x>; d is finite and need not have unit length. For d = 0 any
///    point of the core.
///  * Center(): a point of the core, in its relative interior: the set is scaled about it. An Eigen vector, by value or
///    by reference, whose size is the dimension.
///  * Inradius(): a lower bound, safe against roundoff, on the radius of the ball about Center() inside the core;
///    0 for flat cores. Metres.
template <class Core>
concept ConvexCore = requires(const Core& core, const VectorOf<Core>& direction) {
  { core.Support(direction) } -> std::same_as<SupportPoint<typename Core::Scalar, kDimension<Core>>>;
  { core.Center() } -> std::convertible_to<VectorOf<Core>>;
  { core.Inradius() } -> std::convertible_to<typename Core::Scalar>;
};

/// A core that a certificate can be made for: by formulas of their own, which do not repeat an error of Support().
///  * SupportValue(d): max <d, x> over the core; d need not have unit length. Metres times the direction's unit.
///  * Distance(x): Euclidean distance of a point to the core, 0 inside; metres.
template <class Core>
concept CertifiableCore = ConvexCore<Core> && requires(const Core& core, const VectorOf<Core>& vector) {
  { core.SupportValue(vector) } -> std::convertible_to<typename Core::Scalar>;
  { core.Distance(vector) } -> std::convertible_to<typename Core::Scalar>;
};

/// A core whose support points are vertices that can be named and found again: what a primal warm start needs.
template <class Core>
concept VertexCore = ConvexCore<Core> && requires(const Core& core, VertexId vertex) {
  { core.Vertex(vertex) } -> std::convertible_to<VectorOf<Core>>;
  { core.VertexCount() } -> std::convertible_to<VertexId>;
};

/// A curved core made of few smooth pieces, each with a support function of its own that is twice differentiable: what
/// second-order steps need. Support(d) names the piece that its point is on.
///  * PieceSupport(piece, d): the point of that piece that maximises <d, x>, a point of the core whether or not another
///    piece reaches farther; and its derivative by d, which need not have unit length.
///  * PieceCount(): pieces are numbered from 0. A core of one piece needs PieceSupport() only.
template <class Core>
concept SmoothCore = ConvexCore<Core> && requires(const Core& core, FeatureId piece, const VectorOf<Core>& direction) {
  { core.PieceSupport(piece, direction) } -> std::same_as<CurvedPoint<typename Core::Scalar, kDimension<Core>>>;
  { core.PieceCount() } -> std::convertible_to<FeatureId>;
};

/// A smooth core some of whose pieces bound a flat disc, as the rim of a cylinder bounds its cap. Along the disc's
/// normal the piece's support function has a kink like a cone's tip, where no derivative helps.
///  * Face(piece): the disc, without a normal if the piece bounds none.
template <class Core>
concept FacedCore = SmoothCore<Core> && requires(const Core& core, FeatureId piece) {
  { core.Face(piece) } -> std::same_as<FlatDisc<typename Core::Scalar>>;
};

/// A core that finds its support point faster from a feature that was one for a similar direction; any number will do
/// as a hint. The solver keeps the hint, so that the core stays immutable.
template <class Core>
concept HintedCore = ConvexCore<Core> && requires(const Core& core, const VectorOf<Core>& direction, FeatureId hint) {
  { core.Support(direction, hint) } -> std::same_as<SupportPoint<typename Core::Scalar, kDimension<Core>>>;
};

/// The support point, found from the hint if the core makes use of one.
template <ConvexCore Core>
SupportPoint<typename Core::Scalar, kDimension<Core>> SupportNear(const Core& core, const VectorOf<Core>& direction,
                                                                  [[maybe_unused]] FeatureId hint) {
  if constexpr (HintedCore<Core>) {
    return core.Support(direction, hint);
  } else {
    return core.Support(direction);
  }
}

/// A core of many vertices that looks up which of them is about the farthest.
///  * GuessSupport(d): a vertex that may be Support(d), or near it.
///  * IsGuessing(): whether that is faster than Support(d).
template <class Core>
concept GuessingCore = ConvexCore<Core> && requires(const Core& core, const VectorOf<Core>& direction) {
  { core.GuessSupport(direction) } -> std::same_as<SupportPoint<typename Core::Scalar, kDimension<Core>>>;
  { core.IsGuessing() } -> std::convertible_to<bool>;
};

template <ConvexCore Core>
bool IsGuessing([[maybe_unused]] const Core& core) {
  if constexpr (GuessingCore<Core>) {
    return core.IsGuessing();
  } else {
    return false;
  }
}

/// The guess where there is one, else the support point.
template <ConvexCore Core>
SupportPoint<typename Core::Scalar, kDimension<Core>> GuessSupport(const Core& core, const VectorOf<Core>& direction) {
  if constexpr (GuessingCore<Core>) {
    return core.GuessSupport(direction);
  } else {
    return core.Support(direction);
  }
}

/// A core of many vertices with links from each to those next to it. A plane that lies on the core along an edge and
/// turns about that (gift wrapping) meets next what the steepest way leads to.
///  * SteepestAscent(v, up, outwards): of the vertices next to v that are farther along `outwards`, the one to which
///    the way rises most along `up` for each step outwards. The two are the core's frame's, finite, of any length.
///  * IsLinked(): whether there are links.
template <class Core>
concept LinkedCore = VertexCore<Core> && requires(const Core& core, VertexId vertex, const VectorOf<Core>& direction) {
  { core.SteepestAscent(vertex, direction, direction) } -> std::same_as<EdgeSlope<typename Core::Scalar>>;
  { core.IsLinked() } -> std::convertible_to<bool>;
};

template <class S>
class PointArrays;

/// A core of few vertices, whose support function scans all of them.
///  * Scan(): the vertices in their order (shapes/vertex_scan.h), core's frame, metres; null if they are too many for
///    that.
template <class Core>
concept ScannedCore = VertexCore<Core> && requires(const Core& core) {
  { core.Scan() } -> std::same_as<const PointArrays<typename Core::Scalar>*>;
};

/// A core with an ellipsoid that reaches about as far in each direction: a cold query of a curved set begins with a
/// normal that is guessed from it.
///  * Spread(): a symmetric, positive semidefinite matrix M, full or diagonal; core's frame, metres squared. About
///    Center(), the core reaches about as far as the ellipsoid does whose support value along d is sqrt(<d, M d>). Any
///    will do; a good one saves a direction.
template <class Core>
concept SpreadCore = ConvexCore<Core> && requires(const Core& core, const VectorOf<Core>& vector) {
  { core.Spread() * vector } -> std::convertible_to<VectorOf<Core>>;
};

/// The core's spread, or that of the ball inside it.
template <ConvexCore Core>
auto SpreadOf(const Core& core) {
  if constexpr (SpreadCore<Core>) {
    return core.Spread();
  } else {
    using Diagonal = Eigen::DiagonalMatrix<typename Core::Scalar, kDimension<Core>>;
    return Diagonal(VectorOf<Core>::Constant(core.Inradius() * core.Inradius()));
  }
}

/// The spread of a core with these extents along its axes to either side; metres.
template <class S, int L>
Eigen::DiagonalMatrix<S, L> SpreadOfExtents(const Vector<S, L>& half_extents) {
  return Eigen::DiagonalMatrix<S, L>(half_extents.cwiseProduct(half_extents));
}

/// A core whose support points are less exact than its scalar's roundoff: evaluated in a smaller type, or iterated.
///  * Accuracy(): their error, relative to the core's size.
template <class Core>
concept InexactCore = ConvexCore<Core> && requires(const Core& core) {
  { core.Accuracy() } -> std::convertible_to<typename Core::Scalar>;
};

/// A core whose centre may move within it. MoveCenterNear(p) puts it as near to the point p (in the core's frame) as
/// the inradius about it allows: a wide flat body, scaled about a far centre, would draw its border in by its width
/// times the overlap's part, past a partner that stands on it; about a near one, it acts as if only that part were
/// there.
template <class Core>
concept CenteredCore = ConvexCore<Core> && requires(Core& core, const VectorOf<Core>& point) {
  core.MoveCenterNear(point);
};

/// A core that many bodies share and whose centre may yet move for each query, if MovesCenter(): whoever holds it for
/// the query, as OneOf does, keeps what BallNear(p) returns, the centre near to p and a lower bound on the inradius
/// there.
template <class Core>
concept SharedCenteredCore = ConvexCore<Core> && requires(const Core& core, const VectorOf<Core>& point) {
  { core.BallNear(point).center } -> std::convertible_to<VectorOf<Core>>;
  { core.BallNear(point).radius } -> std::convertible_to<typename Core::Scalar>;
  { core.MovesCenter() } -> std::convertible_to<bool>;
};

/// core + ball(radius). The core is held by value where it is small; use CoreReference for one that is not.
template <ConvexCore CoreType>
struct RoundedSet {
  using Core = CoreType;
  using Scalar = typename Core::Scalar;

  Core core;
  Scalar radius = 0;  ///< Metres, >= 0, finite.
};

template <class Core>
RoundedSet(Core) -> RoundedSet<Core>;
template <class Core, class Scalar>
RoundedSet(Core, Scalar) -> RoundedSet<Core>;

/// The pose of a set in the world.
template <class Set>
using PoseOf = Pose<typename Set::Scalar, kDimension<typename Set::Core>>;

/// A core that lives elsewhere (a polytope with a thousand vertices, shared by many bodies) and outlives this.
template <ConvexCore CoreType>
class CoreReference {
 public:
  using Scalar = typename CoreType::Scalar;

  CoreReference(const CoreType& core) : core_(&core) {}

  auto Support(const VectorOf<CoreType>& direction) const { return core_->Support(direction); }
  auto Support(const VectorOf<CoreType>& direction, FeatureId hint) const requires HintedCore<CoreType> {
    return core_->Support(direction, hint);
  }
  decltype(auto) Center() const { return core_->Center(); }
  Scalar Inradius() const { return core_->Inradius(); }
  decltype(auto) Vertex(VertexId vertex) const requires VertexCore<CoreType> { return core_->Vertex(vertex); }
  VertexId VertexCount() const requires VertexCore<CoreType> { return core_->VertexCount(); }
  auto PieceSupport(FeatureId piece, const VectorOf<CoreType>& direction) const requires SmoothCore<CoreType> {
    return core_->PieceSupport(piece, direction);
  }
  FeatureId PieceCount() const requires SmoothCore<CoreType> { return core_->PieceCount(); }
  auto Face(FeatureId piece) const requires FacedCore<CoreType> { return core_->Face(piece); }
  auto GuessSupport(const VectorOf<CoreType>& direction) const requires GuessingCore<CoreType> {
    return core_->GuessSupport(direction);
  }
  bool IsGuessing() const requires GuessingCore<CoreType> { return core_->IsGuessing(); }
  auto SteepestAscent(VertexId vertex, const VectorOf<CoreType>& up,
                      const VectorOf<CoreType>& outwards) const requires LinkedCore<CoreType> {
    return core_->SteepestAscent(vertex, up, outwards);
  }
  bool IsLinked() const requires LinkedCore<CoreType> { return core_->IsLinked(); }
  auto Scan() const requires ScannedCore<CoreType> { return core_->Scan(); }
  decltype(auto) Spread() const requires SpreadCore<CoreType> { return core_->Spread(); }
  bool MovesCenter() const requires SharedCenteredCore<CoreType> { return core_->MovesCenter(); }
  auto BallNear(const VectorOf<CoreType>& point) const requires SharedCenteredCore<CoreType> {
    return core_->BallNear(point);
  }
  Scalar SupportValue(const VectorOf<CoreType>& direction) const { return core_->SupportValue(direction); }
  Scalar Distance(const VectorOf<CoreType>& point) const { return core_->Distance(point); }
  template <class Face>
  void SupportFace(const VectorOf<CoreType>& direction, Face& face) const {
    core_->SupportFace(direction, face);
  }

 private:
  const CoreType* core_;
};

/// The message of a refused length, out of the way of the check.
template <class Scalar>
[[noreturn]] DGD_COLD void RefuseLength(Scalar value, bool may_be_zero, const char* what) {
  throw std::invalid_argument(std::string(what) +
                              (may_be_zero ? " must be finite and >= 0" : " must be finite and > 0") +
                              ", in metres; got " + std::to_string(value));
}

/// Throws std::invalid_argument naming `what` and the value unless it is finite and at least (or above) zero.
template <class Scalar>
Scalar RequireLength(Scalar value, bool may_be_zero, const char* what) {
  const bool valid = std::isfinite(value) && (may_be_zero ? value >= 0 : value > 0);
  if (!valid) RefuseLength(value, may_be_zero, what);
  return value;
}

/// Throws std::invalid_argument naming `what` unless all coordinates are finite.
template <class S, int L>
const Vector<S, L>& RequireFinite(const Vector<S, L>& point, const char* what) {
  if (!point.allFinite()) {
    std::string coordinates;
    for (const S coordinate : point) coordinates += (coordinates.empty() ? "" : ", ") + std::to_string(coordinate);
    throw std::invalid_argument(std::string(what) + " must be finite, in metres; got (" + coordinates + ")");
  }
  return point;
}

}  // namespace dgd
