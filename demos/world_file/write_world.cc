#include "world_file/write_world.h"

#include <LinearMath/btSerializer.h>
#include <btBulletDynamicsCommon.h>

#include <cstring>
#include <fstream>
#include <system_error>

#include "scene/scene_error.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

// Bullet fills most of its structures, not all: without this, the rest is whatever was in memory before.
class ZeroingSerializer : public btDefaultSerializer {
 public:
  unsigned char* internalAlloc(size_t size) override {
    unsigned char* memory = btDefaultSerializer::internalAlloc(size);
    std::memset(memory, 0, size);
    return memory;
  }
};

void WriteAtomically(const unsigned char* bytes, int count, const std::filesystem::path& file) {
  std::filesystem::path part = file;
  part += ".part";
  std::error_code error;
  {
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes), count);
    stream.close();
    if (stream) std::filesystem::rename(part, file, error);
    if (stream && !error) return;
  }
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw SceneError(file.string() + ": it cannot be written" + (error ? ": " + error.message() : ""));
}

}  // namespace

void WriteWorldFile(btDynamicsWorld& world, const BodyNames& names, const std::filesystem::path& file) {
  ZeroingSerializer serializer;
  for (const auto& [body, name] : names) serializer.registerNameForPointer(body, name.c_str());
  world.serialize(&serializer);
  WriteAtomically(serializer.getBufferPointer(), serializer.getCurrentBufferSize(), file);
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
