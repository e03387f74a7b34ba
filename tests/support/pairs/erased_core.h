// Cores of any type behind three names, for polytopes, for curved cores, and for cores that do not tell their features
// apart, so that the solver is instantiated for pairs of these instead of for every pair of types, which would take
// minutes to compile. A virtual call hands each question on to the core itself, so that the answers are the same to the
// last digit.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include "dgd/convex_set.h"
#include "dgd/shapes.h"

namespace dgd_test {

/// All that the solver and the certificate may ask of a core. Features are vertices or pieces; a core that does not
/// tell them apart has none, and is not asked.
template <class S, int L>
class CoreQuestions {
 public:
  using Point = dgd::Vector<S, L>;

  virtual ~CoreQuestions() = default;
  virtual dgd::SupportPoint<S, L> Support(const Point& direction) const = 0;
  virtual dgd::SupportPoint<S, L> Support(const Point& direction, dgd::FeatureId hint) const = 0;
  virtual dgd::SupportPoint<S, L> GuessSupport(const Point& direction) const = 0;
  virtual bool IsGuessing() const = 0;
  virtual dgd::EdgeSlope<S> SteepestAscent(dgd::VertexId vertex, const Point& up, const Point& outwards) const = 0;
  virtual bool IsLinked() const = 0;
  virtual Point Center() const = 0;
  virtual S Inradius() const = 0;
  virtual dgd::SquareMatrix<S, L> Spread() const = 0;
  virtual dgd::FeatureId FeatureCount() const = 0;
  virtual dgd::CurvedPoint<S, L> FeatureSupport(dgd::FeatureId feature, const Point& direction) const = 0;
  virtual dgd::FlatDisc<S> Face(dgd::FeatureId piece) const = 0;
  virtual S SupportValue(const Point& direction) const = 0;
  virtual S Distance(const Point& point) const = 0;

 protected:
  CoreQuestions() = default;
  CoreQuestions(const CoreQuestions&) = default;
  CoreQuestions& operator=(const CoreQuestions&) = default;
};

template <class Core>
class CoreAnswers final : public CoreQuestions<typename Core::Scalar, dgd::kDimension<Core>> {
 public:
  using S = typename Core::Scalar;
  static constexpr int L = dgd::kDimension<Core>;
  using Point = dgd::Vector<S, L>;

  explicit CoreAnswers(Core core) : core_(std::move(core)) {}

  dgd::SupportPoint<S, L> Support(const Point& direction) const override { return core_.Support(direction); }
  dgd::SupportPoint<S, L> Support(const Point& direction, dgd::FeatureId hint) const override {
    return dgd::SupportNear(core_, direction, hint);
  }
  dgd::SupportPoint<S, L> GuessSupport(const Point& direction) const override {
    return dgd::GuessSupport(core_, direction);
  }
  bool IsGuessing() const override { return dgd::IsGuessing(core_); }
  dgd::EdgeSlope<S> SteepestAscent([[maybe_unused]] dgd::VertexId vertex, [[maybe_unused]] const Point& up,
                                   [[maybe_unused]] const Point& outwards) const override {
    if constexpr (dgd::LinkedCore<Core>) {
      return core_.SteepestAscent(vertex, up, outwards);
    } else {
      return {};
    }
  }
  bool IsLinked() const override {
    if constexpr (dgd::LinkedCore<Core>) return core_.IsLinked();
    return false;
  }
  Point Center() const override { return core_.Center(); }
  S Inradius() const override { return core_.Inradius(); }
  dgd::SquareMatrix<S, L> Spread() const override { return dgd::SpreadOf(core_); }
  dgd::FeatureId FeatureCount() const override {
    if constexpr (dgd::SmoothCore<Core>) {
      return core_.PieceCount();
    } else if constexpr (dgd::VertexCore<Core>) {
      return core_.VertexCount();
    } else {
      return 0;
    }
  }
  dgd::CurvedPoint<S, L> FeatureSupport([[maybe_unused]] dgd::FeatureId feature,
                                        [[maybe_unused]] const Point& direction) const override {
    if constexpr (dgd::SmoothCore<Core>) {
      return core_.PieceSupport(feature, direction);
    } else if constexpr (dgd::VertexCore<Core>) {
      return {core_.Vertex(feature), dgd::SquareMatrix<S, L>::Zero()};
    } else {
      return {core_.Center(), dgd::SquareMatrix<S, L>::Zero()};
    }
  }
  dgd::FlatDisc<S> Face([[maybe_unused]] dgd::FeatureId piece) const override {
    if constexpr (dgd::FacedCore<Core>) return core_.Face(piece);
    return {};
  }
  S SupportValue(const Point& direction) const override { return core_.SupportValue(direction); }
  S Distance(const Point& point) const override { return core_.Distance(point); }

 private:
  Core core_;
};

// Those of the tests that make sets themselves, compiled once: each takes a third of a second to half a second in each.
extern template class CoreAnswers<dgd::Point<double>>;
extern template class CoreAnswers<dgd::Segment<double>>;
extern template class CoreAnswers<dgd::Triangle<double>>;
extern template class CoreAnswers<dgd::Box<double>>;
extern template class CoreAnswers<dgd::Polytope<double>>;
extern template class CoreAnswers<dgd::CoreReference<dgd::Polytope<double>>>;
extern template class CoreAnswers<dgd::Cylinder<double>>;
extern template class CoreAnswers<dgd::Cone<double>>;
extern template class CoreAnswers<dgd::Frustum<double>>;
extern template class CoreAnswers<dgd::Ellipsoid<double>>;
extern template class CoreAnswers<dgd::Point<float>>;
extern template class CoreAnswers<dgd::Segment<float>>;
extern template class CoreAnswers<dgd::Triangle<float>>;
extern template class CoreAnswers<dgd::Box<float>>;
extern template class CoreAnswers<dgd::Polytope<float>>;
extern template class CoreAnswers<dgd::CoreReference<dgd::Polytope<float>>>;
extern template class CoreAnswers<dgd::Cylinder<float>>;
extern template class CoreAnswers<dgd::Cone<float>>;
extern template class CoreAnswers<dgd::Frustum<float>>;
extern template class CoreAnswers<dgd::Ellipsoid<float>>;
extern template class CoreAnswers<dgd::Point<double, 2>>;
extern template class CoreAnswers<dgd::Box<double, 2>>;
extern template class CoreAnswers<dgd::Ellipsoid<double, 2>>;

/// What the names have in common.
template <class ScalarType, int L>
class ErasedCore {
 public:
  using Scalar = ScalarType;
  using Point = dgd::Vector<Scalar, L>;

  explicit ErasedCore(std::shared_ptr<const CoreQuestions<Scalar, L>> core) : core_(std::move(core)) {}

  dgd::SupportPoint<Scalar, L> Support(const Point& direction) const { return core_->Support(direction); }
  dgd::SupportPoint<Scalar, L> Support(const Point& direction, dgd::FeatureId hint) const {
    return core_->Support(direction, hint);
  }
  Point Center() const { return core_->Center(); }
  Scalar Inradius() const { return core_->Inradius(); }
  dgd::SquareMatrix<Scalar, L> Spread() const { return core_->Spread(); }
  Scalar SupportValue(const Point& direction) const { return core_->SupportValue(direction); }
  Scalar Distance(const Point& point) const { return core_->Distance(point); }

 protected:
  const CoreQuestions<Scalar, L>& Core() const { return *core_; }

 private:
  std::shared_ptr<const CoreQuestions<Scalar, L>> core_;
};

template <class S, int L>
class ErasedVertexCore : public ErasedCore<S, L> {
 public:
  using ErasedCore<S, L>::ErasedCore;

  dgd::Vector<S, L> Vertex(dgd::VertexId vertex) const {
    return this->Core().FeatureSupport(vertex, dgd::Vector<S, L>::Zero()).point;
  }
  dgd::VertexId VertexCount() const { return this->Core().FeatureCount(); }
  dgd::SupportPoint<S, L> GuessSupport(const dgd::Vector<S, L>& direction) const {
    return this->Core().GuessSupport(direction);
  }
  bool IsGuessing() const { return this->Core().IsGuessing(); }
  dgd::EdgeSlope<S> SteepestAscent(dgd::VertexId vertex, const dgd::Vector<S, L>& up,
                                   const dgd::Vector<S, L>& outwards) const {
    return this->Core().SteepestAscent(vertex, up, outwards);
  }
  bool IsLinked() const { return this->Core().IsLinked(); }
};

template <class S, int L>
class ErasedSmoothCore : public ErasedCore<S, L> {
 public:
  using ErasedCore<S, L>::ErasedCore;

  dgd::CurvedPoint<S, L> PieceSupport(dgd::FeatureId piece, const dgd::Vector<S, L>& direction) const {
    return this->Core().FeatureSupport(piece, direction);
  }
  dgd::FeatureId PieceCount() const { return this->Core().FeatureCount(); }
  dgd::FlatDisc<S> Face(dgd::FeatureId piece) const { return this->Core().Face(piece); }
};

/// As a user's core with the least that ConvexCore asks for: without features, and without hints.
template <class ScalarType, int L>
class ErasedPlainCore : private ErasedCore<ScalarType, L> {
 public:
  using Scalar = ScalarType;
  using Base = ErasedCore<Scalar, L>;
  using Base::Base, Base::Center, Base::Distance, Base::Inradius, Base::SupportValue;

  dgd::SupportPoint<Scalar, L> Support(const dgd::Vector<Scalar, L>& direction) const {
    return Base::Support(direction);
  }
};
static_assert(!dgd::HintedCore<ErasedPlainCore<double, 3>>);

template <class Core>
auto Erase(Core core) {
  using S = typename Core::Scalar;
  constexpr int L = dgd::kDimension<Core>;
  using ErasedFlat = std::conditional_t<dgd::VertexCore<Core>, ErasedVertexCore<S, L>, ErasedPlainCore<S, L>>;
  using Erased = std::conditional_t<dgd::SmoothCore<Core>, ErasedSmoothCore<S, L>, ErasedFlat>;
  return Erased(std::make_shared<CoreAnswers<Core>>(std::move(core)));
}

/// A set of any type.
template <class S, int L>
using AnySet = std::variant<dgd::RoundedSet<ErasedVertexCore<S, L>>, dgd::RoundedSet<ErasedSmoothCore<S, L>>,
                            dgd::RoundedSet<ErasedPlainCore<S, L>>>;

template <class Core>
AnySet<typename Core::Scalar, dgd::kDimension<Core>> Erase(const dgd::RoundedSet<Core>& set) {
  return dgd::RoundedSet{Erase(set.core), set.radius};
}

}  // namespace dgd_test
