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
  int size = 0;
  for (int i = 0; i < patch.size; ++i) {
    dgd::ContactPoint<double> point = patch.points[static_cast<std::size_t>(i)];
    point.on_1 -= time_ * way_a_.translation;
    point.on_2 -= time_ * way_b_.translation;
    const double approach = time_ * motion_.TimeStep() * motion_.ApproachSpeed(point.on_1, point.on_2, normal);
    point.separation += approach;
    if (approach < 0 && point.separation < -flush) continue;
    patch.points[static_cast<std::size_t>(size++)] = point;
  }
  patch.size = size;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
