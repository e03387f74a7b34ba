// The image of a core under an affine map: sheared, stretched or mirrored.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"
#include "support/sets/stretch.h"
#include "support/sets/support_distance.h"

namespace dgd_test {

/// A x + b for all x of the core. Its support point along d is A S(A^T d) + b, with the core's support point S (eq.
/// affine-transformation-support-function of the paper). Rotations and translations need not go into A and b, but may:
/// a set has a pose. Flat faces are not handed on: the image of a disc is an ellipse, so queries about such faces take
/// cutting planes.
template <dgd::ConvexCore CoreType>
class Transformed {
 public:
  using Core = CoreType;
  using Scalar = typename CoreType::Scalar;

 private:
  static constexpr int L = dgd::kDimension<CoreType>;
  using S = Scalar;
  using VectorS = dgd::Vector<S, L>;
  using MatrixS = dgd::SquareMatrix<S, L>;

 public:
  /// Largest ratio of A's singular values: beyond it, the core's digits are lost. 4e12 in double, 8e3 in float.
  static constexpr S kMaxCondition = 1 / (1024 * std::numeric_limits<S>::epsilon());

  /// @param linear  A, dimensionless: finite, singular values positive and within kMaxCondition of each other.
  /// @param offset  b, metres; finite.
  /// Throws std::invalid_argument otherwise.
  Transformed(CoreType core, const MatrixS& linear, const VectorS& offset)
      : core_(std::move(core)), linear_(linear), offset_(dgd::RequireFinite(offset, "the offset of an affine map")) {
    if (!linear.allFinite()) throw std::invalid_argument("the matrix of an affine map must be finite");
    const dgd::SquareMatrix<double, L> linear_in_double = linear.template cast<double>();
    const auto [most, least] = StretchOf(linear_in_double);
    if (!(least > 0 && most <= double(kMaxCondition) * least)) {
      throw std::invalid_argument(
          "the matrix of an affine map must be invertible, its largest singular value at most " +
          std::to_string(kMaxCondition) + " times its smallest; got " + std::to_string(most) + " and " +
          std::to_string(least));
    }
    inverse_ = linear_in_double.inverse();
    condition_ = most / least;
    least_stretch_ = std::max(0.0, least - 16 * std::numeric_limits<double>::epsilon() * most);
    // The ball goes into an ellipsoid; the points of its border are rounded.
    constexpr double kRounding = 16 * std::numeric_limits<S>::epsilon();
    const double center_size = (Center().cwiseAbs() + offset_.cwiseAbs()).maxCoeff();
    inradius_ = static_cast<S>(
        std::max(0.0, (1 - kRounding) * least_stretch_ * double(core_.Inradius()) - kRounding * center_size));
  }

  dgd::SupportPoint<S, L> Support(const VectorS& direction) const {
    return Image(core_.Support(DirectionInCore(direction)));
  }
  dgd::SupportPoint<S, L> Support(const VectorS& direction,
                                  dgd::FeatureId hint) const requires dgd::HintedCore<CoreType> {
    return Image(core_.Support(DirectionInCore(direction), hint));
  }
  dgd::SupportPoint<S, L> GuessSupport(const VectorS& direction) const requires dgd::GuessingCore<CoreType> {
    return Image(core_.GuessSupport(DirectionInCore(direction)));
  }
  bool IsGuessing() const requires dgd::GuessingCore<CoreType> { return core_.IsGuessing(); }
  /// See LinkedCore: what rises and leads outwards here does so there.
  dgd::EdgeSlope<S> SteepestAscent(dgd::VertexId vertex, const VectorS& up,
                                   const VectorS& outwards) const requires dgd::LinkedCore<CoreType> {
    return core_.SteepestAscent(vertex, DirectionInCore(up), DirectionInCore(outwards));
  }
  bool IsLinked() const requires dgd::LinkedCore<CoreType> { return core_.IsLinked(); }
  VectorS Center() const { return Image(VectorS(core_.Center())); }
  S Inradius() const { return inradius_; }
  /// See SpreadCore.
  MatrixS Spread() const requires dgd::SpreadCore<CoreType> { return linear_ * core_.Spread() * linear_.transpose(); }

  VectorS Vertex(dgd::VertexId vertex) const requires dgd::VertexCore<CoreType> {
    return Image(VectorS(core_.Vertex(vertex)));
  }
  dgd::VertexId VertexCount() const requires dgd::VertexCore<CoreType> { return core_.VertexCount(); }

  dgd::CurvedPoint<S, L> PieceSupport(dgd::FeatureId piece,
                                      const VectorS& direction) const requires dgd::SmoothCore<CoreType> {
    const dgd::CurvedPoint<S, L> curved = core_.PieceSupport(piece, DirectionInCore(direction));
    return {Image(curved.point), linear_ * curved.derivative * linear_.transpose()};
  }
  dgd::FeatureId PieceCount() const requires dgd::SmoothCore<CoreType> { return core_.PieceCount(); }

  /// Largest <direction, x> over the core.
  S SupportValue(const VectorS& direction) const {
    return core_.SupportValue(DirectionInCore(direction)) + direction.dot(offset_);
  }

  /// Distance of `point` to the core, metres; 0 inside. By iteration over support points, see SupportDistance; but
  /// where that may be too small, close to the border, never less than what the inner core's own distance makes
  /// certain.
  S Distance(const VectorS& point) const {
    const dgd::Vector<double, L> x = point.template cast<double>();
    const dgd::Vector<double, L> from_offset = x - offset_.template cast<double>();
    const dgd::Vector<double, L> in_core = inverse_ * from_offset;
    const double roundoff = 16 * double(std::numeric_limits<S>::epsilon()) * condition_ * from_offset.norm();
    const double at_least = least_stretch_ * double(core_.Distance(in_core.template cast<S>())) - roundoff;
    return static_cast<S>(std::max(SupportDistance<L, Transformed>(*this, x).Find(), at_least));
  }

  /// The image of the inner core's face for the same plane.
  void SupportFace(const VectorS& direction, dgd::SupportingFace<S>& face) const requires(L == 3) {
    const int first = face.size;
    core_.SupportFace(DirectionInCore(direction), face);
    for (int i = first; i < face.size; ++i) {
      VectorS& corner = face.points[static_cast<std::size_t>(i)];
      corner = Image(corner);
    }
    face.radius = 0;  // No longer a circle's.
  }

 private:
  VectorS DirectionInCore(const VectorS& direction) const { return linear_.transpose() * direction; }
  VectorS Image(const VectorS& point) const { return linear_ * point + offset_; }
  dgd::SupportPoint<S, L> Image(const dgd::SupportPoint<S, L>& support) const {
    return {Image(support.point), support.feature};
  }

  CoreType core_;
  MatrixS linear_;
  VectorS offset_;
  dgd::SquareMatrix<double, L> inverse_;
  double condition_;
  double least_stretch_;
  S inradius_;
};

}  // namespace dgd_test
