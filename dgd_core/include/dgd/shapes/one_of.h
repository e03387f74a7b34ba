// A core of one of several types, which are resolved at run time: what is compiled for it serves all of them.
#pragma once

#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

#include "dgd/convex_set.h"
#include "dgd/types.h"

namespace dgd {

/// Fulfils each concept of convex_set.h that all of its types fulfil. A concept that only makes queries faster is
/// fulfilled if one type fulfils it, and the functions return that nothing is known for the others.
/// @tparam Cores  Each type once; all of the same scalar and dimension.
template <ConvexCore... Cores>
class OneOf {
  using Variant = std::variant<Cores...>;
  using First = std::variant_alternative_t<0, Variant>;
  static constexpr int L = kDimension<First>;

  template <class Core>
  static constexpr bool kHas = (std::same_as<Core, Cores> || ...);

 public:
  using Scalar = typename First::Scalar;
  using Point = Vector<Scalar, L>;

  template <class Core>
  requires kHas<Core> OneOf(const Core& core) : core_(core), center_(core.Center()), inradius_(core.Inradius()) {}

  /// Calls visitor(core) with the core as the type that it is.
  template <class Visitor>
  decltype(auto) Visit(Visitor&& visitor) const {
    return std::visit(std::forward<Visitor>(visitor), core_);
  }

  SupportPoint<Scalar, L> Support(const Point& direction) const {
    return Visit([&](const auto& core) { return core.Support(direction); });
  }
  const Point& Center() const { return center_; }
  Scalar Inradius() const { return inradius_; }

  Point Vertex(VertexId vertex) const requires(VertexCore<Cores>&&...) {
    return Visit([=](const auto& core) -> Point { return core.Vertex(vertex); });
  }
  VertexId VertexCount() const requires(VertexCore<Cores>&&...) {
    return Visit([](const auto& core) { return core.VertexCount(); });
  }

  CurvedPoint<Scalar, L> PieceSupport(FeatureId piece, const Point& direction) const requires(SmoothCore<Cores>&&...) {
    return Visit([&](const auto& core) { return core.PieceSupport(piece, direction); });
  }
  FeatureId PieceCount() const requires(SmoothCore<Cores>&&...) {
    return Visit([](const auto& core) { return core.PieceCount(); });
  }
  FlatDisc<Scalar> Face(FeatureId piece) const requires(FacedCore<Cores> || ...) {
    return Visit([=]<class Core>(const Core& core) -> FlatDisc<Scalar> {
      if constexpr (FacedCore<Core>) return core.Face(piece);
      return {};
    });
  }

  SupportPoint<Scalar, L> Support(const Point& direction, FeatureId hint) const requires(HintedCore<Cores> || ...) {
    return Visit([&](const auto& core) { return SupportNear(core, direction, hint); });
  }
  SupportPoint<Scalar, L> GuessSupport(const Point& direction) const requires(GuessingCore<Cores> || ...) {
    return Visit([&](const auto& core) { return dgd::GuessSupport(core, direction); });
  }
  bool IsGuessing() const requires(GuessingCore<Cores> || ...) {
    return Visit([](const auto& core) { return dgd::IsGuessing(core); });
  }
  EdgeSlope<Scalar> SteepestAscent(VertexId vertex, const Point& up, const Point& outwards) const
      requires(LinkedCore<Cores> || ...) {
    return Visit([&]<class Core>(const Core& core) -> EdgeSlope<Scalar> {
      if constexpr (LinkedCore<Core>) return core.SteepestAscent(vertex, up, outwards);
      return {vertex, -std::numeric_limits<Scalar>::infinity()};
    });
  }
  bool IsLinked() const requires(LinkedCore<Cores> || ...) {
    return Visit([]<class Core>(const Core& core) {
      if constexpr (LinkedCore<Core>) return core.IsLinked();
      return false;
    });
  }
  const PointArrays<Scalar>* Scan() const requires(ScannedCore<Cores> || ...) {
    return Visit([]<class Core>(const Core& core) -> const PointArrays<Scalar>* {
      if constexpr (ScannedCore<Core>) return core.Scan();
      return nullptr;
    });
  }
  SquareMatrix<Scalar, L> Spread() const {
    return Visit([](const auto& core) -> SquareMatrix<Scalar, L> {
      return SpreadOf(core) * SquareMatrix<Scalar, L>::Identity();
    });
  }
  /// Whether MoveCenterNear() may move the centre.
  bool MovesCenter() const requires((CenteredCore<Cores> || SharedCenteredCore<Cores>) || ...) {
    return Visit([]<class Core>(const Core& core) {
      if constexpr (SharedCenteredCore<Core>) return core.MovesCenter();
      return CenteredCore<Core>;
    });
  }
  void MoveCenterNear(const Point& point) requires((CenteredCore<Cores> || SharedCenteredCore<Cores>) || ...) {
    std::visit(
        [&]<class Core>(Core& core) {
          if constexpr (CenteredCore<Core>) {
            core.MoveCenterNear(point);
            center_ = core.Center();
          } else if constexpr (SharedCenteredCore<Core>) {
            if (!core.MovesCenter()) return;
            const auto ball = core.BallNear(point);
            center_ = ball.center;
            inradius_ = ball.radius;
          }
        },
        core_);
  }

  Scalar SupportValue(const Point& direction) const requires(CertifiableCore<Cores>&&...) {
    return Visit([&](const auto& core) { return core.SupportValue(direction); });
  }
  Scalar Distance(const Point& point) const requires(CertifiableCore<Cores>&&...) {
    return Visit([&](const auto& core) { return core.Distance(point); });
  }
  template <class Face>
  void SupportFace(const Point& direction, Face& face) const {
    Visit([&](const auto& core) { core.SupportFace(direction, face); });
  }

 private:
  Variant core_;
  // The core's own: queries read them more often than support points.
  Point center_;
  Scalar inradius_;
};

}  // namespace dgd
