#include "support/any_set.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace dgd_test {

template <class S>
AnySet<S> MakeSet(const ReferenceSet& set) {
  const dgd::Vector3<S> size = set.size.cast<S>();
  const S radius = static_cast<S>(set.radius);
  switch (set.type) {
    case CoreType::kPoint:
      return dgd::RoundedSet{dgd::Point<S>(), radius};
    case CoreType::kSegment:
      return dgd::RoundedSet{dgd::Segment<S>(size[0]), radius};
    case CoreType::kTriangle:
      return dgd::RoundedSet{
          dgd::Triangle<S>(set.points.at(0).cast<S>(), set.points.at(1).cast<S>(), set.points.at(2).cast<S>()), radius};
    case CoreType::kBox:
      return dgd::RoundedSet{dgd::Box<S>(size), radius};
    case CoreType::kCylinder:
      return dgd::RoundedSet{dgd::Cylinder<S>(size[0], size[1]), radius};
    case CoreType::kCone:
      return dgd::RoundedSet{dgd::Cone<S>(size[0], size[1]), radius};
    case CoreType::kPolytope:
      break;
    default:
      throw std::logic_error(std::string("AnySet holds no ") + Name(set.type));
  }
  return dgd::RoundedSet{dgd::Polytope<S>(set.points), radius};
}

template <class S>
dgd::Result<S> SolverPair<S>::GrowthDistance(const dgd::Settings<S>& settings, dgd::WarmStart<S>* warm_start) const {
  return std::visit(
      [&](const auto& a, const auto& b) { return dgd::GrowthDistance(a, pose_1, b, pose_2, settings, warm_start); },
      set_1, set_2);
}

template <class S>
dgd::CollisionResult<S> SolverPair<S>::DetectCollision(const dgd::Settings<S>& settings,
                                                       dgd::WarmStart<S>* warm_start) const {
  return std::visit(
      [&](const auto& a, const auto& b) { return dgd::DetectCollision(a, pose_1, b, pose_2, settings, warm_start); },
      set_1, set_2);
}

template <class S>
dgd::Certificate SolverPair<S>::Certify(const dgd::Result<S>& result) const {
  return std::visit([&](const auto& a, const auto& b) { return dgd::Certify(a, pose_1, b, pose_2, result); }, set_1,
                    set_2);
}

template <class S>
S SolverPair<S>::Distance(const AnySet<S>& set, const dgd::Pose<S>& pose, const dgd::Vector3<S>& point) {
  const dgd::Vector3<S> local = pose.rotation.transpose() * (point - pose.translation);
  return std::visit([&](const auto& a) { return std::max(S(0), a.core.Distance(local) - a.radius); }, set);
}

template <class S>
dgd::Vector3<S> SolverPair<S>::Center(const AnySet<S>& set, const dgd::Pose<S>& pose) {
  return std::visit([&](const auto& a) -> dgd::Vector3<S> { return pose * a.core.Center(); }, set);
}

template <class S>
S SolverPair<S>::Inradius(const AnySet<S>& set) {
  return std::visit([](const auto& a) { return a.core.Inradius() + a.radius; }, set);
}

template AnySet<double> MakeSet<double>(const ReferenceSet& set);
template AnySet<float> MakeSet<float>(const ReferenceSet& set);
template struct SolverPair<double>;
template struct SolverPair<float>;

}  // namespace dgd_test
