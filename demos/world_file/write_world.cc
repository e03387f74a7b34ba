#include "world_file/write_world.h"

#include <LinearMath/btSerializer.h>
#include <btBulletDynamicsCommon.h>

#include <cstring>

#include "report/whole_file.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

// Bullet does not fill all of its structures; without this, they contain uninitialized memory.
class ZeroingSerializer : public btDefaultSerializer {
 public:
  unsigned char* internalAlloc(size_t size) override {
    unsigned char* memory = btDefaultSerializer::internalAlloc(size);
    std::memset(memory, 0, size);
    return memory;
  }
};

}  // namespace

void WriteWorldFile(btDynamicsWorld& world, const BodyNames& names, const std::filesystem::path& file) {
  ZeroingSerializer serializer;
  for (const auto& [body, name] : names) serializer.registerNameForPointer(body, name.c_str());
  world.serialize(&serializer);
  WriteWholeFile(file, {reinterpret_cast<const char*>(serializer.getBufferPointer()),
                        static_cast<std::size_t>(serializer.getCurrentBufferSize())});
}

void WriteWorldFile(SimulatedWorld& world, const std::filesystem::path& file) {
  btDynamicsWorld& bullet = world.Bullet();
  BodyNames names;
  for (int i = 0; i < bullet.getNumCollisionObjects(); ++i) {
    const btCollisionObject* object = bullet.getCollisionObjectArray()[i];
    names[object] = world.Bodies()[static_cast<std::size_t>(object->getUserIndex())].name;
  }
  bullet.getSolverInfo().m_timeStep = ToBullet(world.time_step());
  WriteWorldFile(bullet, names, file);
}

}  // namespace dgd_demos
