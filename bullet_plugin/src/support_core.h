// A core behind a function pointer: for shapes that only Bullet can evaluate, and for whatever meets them.
#pragma once

#include "dgd/convex_set.h"
#include "dgd/supporting_face.h"
#include "solver_types.h"

namespace dgd_bullet {

class SupportCore {
 public:
  using Scalar = double;
  using Function = dgd::SupportPoint<double> (*)(const void* object, const Vector3& direction);

  /// @param accuracy  Relative rounding error of the function's values.
  SupportCore(const void* object, Function function, const Vector3& center, double inradius, double accuracy)
      : object_(object), function_(function), center_(center), inradius_(inradius), accuracy_(accuracy) {}

  /// Any other core, which must outlive this.
  template <class Core>
  explicit SupportCore(const Core& core)
      : SupportCore(
            &core,
            [](const void* object, const Vector3& direction) {
              return static_cast<const Core*>(object)->Support(direction);
            },
            core.Center(), core.Inradius(), 0) {}

  dgd::SupportPoint<double> Support(const Vector3& direction) const { return function_(object_, direction); }
  const Vector3& Center() const { return center_; }
  double Inradius() const { return inradius_; }
  double Accuracy() const { return accuracy_; }

  /// Nothing is known of its faces.
  void SupportFace(const Vector3&, dgd::SupportingFace<double>&) const {}

 private:
  const void* object_;
  Function function_;
  Vector3 center_;
  double inradius_;
  double accuracy_;
};

}  // namespace dgd_bullet
