#include "support/solver_pair.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/polytope.h"
#include "dgd/shapes/segment.h"
#include "dgd/shapes/triangle.h"

namespace dgd_test {

template <class S>
AnySet<S, 3> MakeSet(const ReferenceSet& set) {
  const dgd::Vector3<S> size = set.size.cast<S>();
  const auto rounded = [&set](const auto& core) { return Erase(dgd::RoundedSet{core, static_cast<S>(set.radius)}); };
  switch (set.type) {
    case CoreType::kPoint:
      return rounded(dgd::Point<S>());
    case CoreType::kSegment:
      return rounded(dgd::Segment<S>(size[0]));
    case CoreType::kTriangle:
      return rounded(
          dgd::Triangle<S>(set.points.at(0).cast<S>(), set.points.at(1).cast<S>(), set.points.at(2).cast<S>()));
    case CoreType::kBox:
      return rounded(dgd::Box<S>(size));
    case CoreType::kCylinder:
      return rounded(dgd::Cylinder<S>(size[0], size[1]));
    case CoreType::kCone:
      return rounded(dgd::Cone<S>(size[0], size[1]));
    case CoreType::kPolytope:
      break;
    default:
      throw std::logic_error(std::string("no SolverPair is made of a ") + Name(set.type));
  }
  return rounded(dgd::Polytope<S>(set.points));
}

template <class S>
S SolverPair<S>::Distance(const AnySet<S, 3>& set, const dgd::Pose<S>& pose, const dgd::Vector3<S>& point) {
  const dgd::Vector3<S> local = pose.rotation.transpose() * (point - pose.translation);
  return std::visit([&](const auto& a) { return std::max(S(0), a.core.Distance(local) - a.radius); }, set);
}

template <class S>
dgd::Vector3<S> SolverPair<S>::Center(const AnySet<S, 3>& set, const dgd::Pose<S>& pose) {
  return std::visit([&](const auto& a) -> dgd::Vector3<S> { return pose * a.core.Center(); }, set);
}

template <class S>
S SolverPair<S>::Inradius(const AnySet<S, 3>& set) {
  return std::visit([](const auto& a) { return a.core.Inradius() + a.radius; }, set);
}

template AnySet<double, 3> MakeSet<double>(const ReferenceSet& set);
template AnySet<float, 3> MakeSet<float>(const ReferenceSet& set);
template struct SolverPair<double>;
template struct SolverPair<float>;

}  // namespace dgd_test
