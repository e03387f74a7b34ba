// A Bullet app that records its pairs, as a user would write it, against the installed package. Exit status 0 if the
// file has the pair.
#include <btBulletCollisionCommon.h>

#include <cstdio>
#include <exception>

#include "dgd_bullet/collision_configuration.h"
#include "dgd_bullet/record_file.h"
#include "dgd_bullet/recorder.h"

static void Record(const char* path) {
  dgd_bullet::Recorder recorder(path);
  dgd_bullet::Options options;
  options.pair_observer = &recorder;
  dgd_bullet::CollisionConfiguration configuration(options);
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  btSphereShape ball(1);
  btCollisionObject first, second;
  for (btCollisionObject* object : {&first, &second}) {
    object->setCollisionShape(&ball);
    world.addCollisionObject(object);
  }
  world.performDiscreteCollisionDetection();
  recorder.Close();
}

int main() {
  try {
    Record("pair.rec");
    const dgd_bullet::Record record = dgd_bullet::ReadRecord("pair.rec");
    return !record.problem && record.pairs.size() == 1 && record.shapes.size() == 1 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
