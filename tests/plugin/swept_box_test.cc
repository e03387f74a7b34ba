// The box of a shape on its way, against where Bullet carries the shape.
#include "swept_box.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <LinearMath/btTransformUtil.h>
#include <gtest/gtest.h>

#include <array>

#include "pair_motion.h"
#include "plugin/bullet_oracle.h"
#include "plugin/rigid_body.h"
#include "support/random.h"

namespace dgd_test {
namespace {

constexpr double kStep = 1.0 / 60;  // s
constexpr double kReach = 0.01;     // m

btVector3 InCube(Random& random, double half) {
  const Eigen::Vector3d place = half * random.InCube();
  return Vec(place.x(), place.y(), place.z());
}

btTransform RandomPose(Random& random) {
  const Eigen::Vector3d axis = random.UnitVector();
  return btTransform(btQuaternion(Vec(axis.x(), axis.y(), axis.z()), btScalar(random.Uniform(0, 3))),
                     InCube(random, 2));
}

std::unique_ptr<btRigidBody> RandomBody(Random& random, btCollisionShape& shape) {
  auto body = MakeRigidBody(shape, 1, RandomPose(random));
  // From slow ones to such as turn by more than a radian in a step.
  const double spin = std::pow(10.0, random.Uniform(-1, 2));
  body->setLinearVelocity(InCube(random, random.Uniform(0, 60)));
  body->setAngularVelocity(InCube(random, spin));
  return body;
}

TEST(SweptBox, OfAChildOnASpinningBody_HoldsAllPlacesInTheOthersFrame) {
  Random random(1);
  const btVector3 half = Vec(0.1, 0.2, 0.3);
  btBoxShape box(half), ball(Vec(1, 1, 1));
  for (int i = 0; i < 2000; ++i) {
    const auto a = RandomBody(random, ball), b = RandomBody(random, ball);
    const btTransform child = RandomPose(random);
    const btTransform pose = a->getWorldTransform() * child, frame = b->getWorldTransform();
    const btCollisionObjectWrapper wrapper(nullptr, &box, a.get(), pose, -1, 0);
    const dgd_bullet::PairMotion motion(dgd_bullet::BoundedBody(*a), dgd_bullet::BoundedBody(*b), kStep);
    const dgd_bullet::Box swept = dgd_bullet::SweptBox(wrapper, frame, motion, kReach);
    for (int time = 0; time <= 8; ++time) {
      btTransform at_a, at_b;
      a->predictIntegratedTransform(btScalar(kStep * time / 8), at_a);
      b->predictIntegratedTransform(btScalar(kStep * time / 8), at_b);
      const btTransform in_b = at_b.inverseTimes(at_a * child);
      for (int corner = 0; corner < 8; ++corner) {
        const btVector3 place = in_b * (half * Vec(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1));
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(place[axis], swept.low[axis] + btScalar(kReach - 1e-4)) << i << ' ' << time;
          ASSERT_LE(place[axis], swept.high[axis] - btScalar(kReach - 1e-4)) << i << ' ' << time;
        }
      }
    }
  }
}

TEST(SweptBox, OfABodyAtRest_IsItsOwnAndTheDistance) {
  btBoxShape box(Vec(0.1, 0.2, 0.3));
  const btTransform pose = At(1, 2, 3);
  const btCollisionObjectWrapper wrapper(nullptr, &box, nullptr, pose, -1, 0);
  const dgd_bullet::Box swept = dgd_bullet::SweptBox(wrapper, At(1, 2, 3), dgd_bullet::PairMotion(), kReach);
  EXPECT_NEAR(double((swept.high - Vec(0.11, 0.21, 0.31)).length()), 0, 1e-6);
  EXPECT_NEAR(double((swept.low + Vec(0.11, 0.21, 0.31)).length()), 0, 1e-6);
}

}  // namespace
}  // namespace dgd_test
