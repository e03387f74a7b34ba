// A core behind a function pointer: for shapes that only their owner can evaluate, and for their partners.
#pragma once

#include <concepts>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"
#include "dgd/types.h"

namespace dgd {

/// Refers to its object, which outlives it.
class CustomCore {
 public:
  using Scalar = double;
  /// A point of the object that is farthest along a direction of any length; the object's frame, metres.
  using Function = SupportPoint<double> (*)(const void* object, const Vector3<double>& direction);

  /// @param center    In the core's relative interior; object's frame, metres.
  /// @param inradius  At most the radius of the ball about the centre inside the core; metres, >= 0.
  /// @param accuracy  Relative roundoff of the function's values.
  CustomCore(const void* object, Function function, const Vector3<double>& center, double inradius, double accuracy)
      : object_(object), function_(function), center_(center), inradius_(inradius), accuracy_(accuracy) {}

  /// Any other core.
  template <ConvexCore Core>
  requires(!std::same_as<Core, CustomCore>) explicit CustomCore(const Core& core)
      : CustomCore(
            &core,
            [](const void* object, const Vector3<double>& direction) {
              return static_cast<const Core*>(object)->Support(direction);
            },
            core.Center(), core.Inradius(), 0) {}

  SupportPoint<double> Support(const Vector3<double>& direction) const { return function_(object_, direction); }
  const Vector3<double>& Center() const { return center_; }
  double Inradius() const { return inradius_; }
  double Accuracy() const { return accuracy_; }

  /// Nothing is known of its faces.
  void SupportFace(const Vector3<double>&, SupportingFace<double>&) const {}

 private:
  const void* object_;
  Function function_;
  Vector3<double> center_;
  double inradius_;
  double accuracy_;
};

}  // namespace dgd
