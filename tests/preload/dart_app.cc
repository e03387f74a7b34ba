// A DART app with Bullet as its collision detector: a box that overlaps a ground by 1 mm, and one that is 1 m above it.
// Exit status 0 if the contacts are those of the first, all 1 mm deep.
#include <cmath>
#include <cstdio>
#include <dart/collision/bullet/bullet.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/SimpleFrame.hpp>

using dart::dynamics::SimpleFrame;

static dart::dynamics::SimpleFramePtr MakeBox(double height, const Eigen::Vector3d& size) {
  auto frame = std::make_shared<SimpleFrame>(dart::dynamics::Frame::World());
  frame->setShape(std::make_shared<dart::dynamics::BoxShape>(size));
  frame->setTranslation(Eigen::Vector3d(0, 0, height));
  return frame;
}

int main() {
  const auto detector = dart::collision::BulletCollisionDetector::create();
  const auto ground = MakeBox(-0.5, {10, 10, 1});
  const auto box = MakeBox(0.499, {1, 1, 1}), high_box = MakeBox(2.5, {1, 1, 1});
  const auto group = detector->createCollisionGroup(ground.get(), box.get(), high_box.get());
  dart::collision::CollisionResult result;
  group->collide(dart::collision::CollisionOption(), &result);
  bool are_right = result.getNumContacts() > 0;
  for (const dart::collision::Contact& contact : result.getContacts()) {
    std::printf("%a\n", contact.penetrationDepth);
    are_right = are_right && std::abs(contact.penetrationDepth - 0.001) < 1e-6 && std::abs(contact.normal.z()) > 0.999;
  }
  return are_right ? 0 : 1;
}
