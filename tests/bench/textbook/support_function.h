// A convex set as a textbook has it: a virtual support function, the margin inside.
#pragma once

#include <utility>

#include "dgd/convex_set.h"

namespace dgd_bench {

template <int L>
class SupportFunction {
 public:
  using Vector = dgd::Vector<double, L>;

  SupportFunction() = default;
  virtual ~SupportFunction() = default;
  SupportFunction(const SupportFunction&) = delete;
  SupportFunction& operator=(const SupportFunction&) = delete;

  /// The point of the set that is farthest along `direction`, of any length but 0; the set's own frame, metres.
  virtual Vector Support(const Vector& direction) const = 0;
  virtual Vector Center() const = 0;
  virtual double Inradius() const = 0;
};

/// Of a set of the solver's: both ask the same code for the core's point, compiled alike.
template <class Core>
class SupportFunctionOf final : public SupportFunction<dgd::kDimension<Core>> {
 public:
  using Vector = typename SupportFunction<dgd::kDimension<Core>>::Vector;

  explicit SupportFunctionOf(const dgd::RoundedSet<Core>& set) : set_(set) {}

  Vector Support(const Vector& direction) const override {
    return set_.core.Support(direction).point + set_.radius / direction.norm() * direction;
  }
  Vector Center() const override { return set_.core.Center(); }
  double Inradius() const override { return set_.core.Inradius() + set_.radius; }

 private:
  dgd::RoundedSet<Core> set_;
};

}  // namespace dgd_bench
