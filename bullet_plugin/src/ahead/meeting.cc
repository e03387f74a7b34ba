#include "ahead/meeting.h"

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

void MovingPair::MoveTo(double time) {
  DGD_ASSERT(!(time < 0 || time > 1));
  time_ = time;
  a_.pose = way_a_.At(time);
  b_.pose = way_b_.At(time);
}

void MovingPair::MoveToStart(const Vector3& normal, double flush, dgd::ContactPatch<double>& patch) const {
  DGD_ASSERT(IsUnit(normal));
  const auto way_of = [&](const dgd::Motion<double>& motion, const Vector3& at) -> Vector3 {
    return time_ * (motion.translation + motion.rotation.cross(at - motion.CenterAt(time_)));
  };
  int size = 0;
  for (int i = 0; i < patch.size; ++i) {
    dgd::ContactPoint<double> point = patch.points[static_cast<std::size_t>(i)];
    const double approach = normal.dot(way_of(way_a_, point.on_1) - way_of(way_b_, point.on_2));
    point.separation += approach;
    if (approach < 0 && point.separation < -flush) continue;
    point.on_1 -= time_ * way_a_.translation;
    point.on_2 -= time_ * way_b_.translation;
    patch.points[static_cast<std::size_t>(size++)] = point;
  }
  patch.size = size;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
