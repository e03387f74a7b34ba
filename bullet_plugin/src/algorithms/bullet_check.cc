#include "algorithms/bullet_check.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btScalar.h>

#include <cstdio>
#include <stdexcept>
#include <string>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// The name of a version that Bullet writes as 324: "Bullet 3.24".
std::string VersionName(int version) {
  char text[32];
  std::snprintf(text, sizeof(text), "Bullet %d.%02d", version / 100, version % 100);
  return text;
}

/// The precision of the Bullet library that is linked, or loaded first. btIsDoublePrecision() is inline: it reports the
/// headers. Of the functions that only the library has, this one has the same name in both precisions, returns the size
/// of a struct that differs, and reads nothing of its object, whose constructor is inline: no memory is touched by code
/// that takes it for larger than it is.
std::string PrecisionOfLibrary() {
  const int bytes = btPersistentManifold(nullptr, nullptr, 0, 0, 0).calculateSerializeBufferSize();
  if (bytes == sizeof(btPersistentManifoldFloatData)) return "in float";
  if (bytes == sizeof(btPersistentManifoldDoubleData)) return "in double";
  return "of another version";
}

}  // namespace

// No function of the library returns its version. A shared one has it in the name that the dynamic linker looks for.
void RequireMatchingBullet(int app_version) {
  const std::string own_precision = sizeof(btScalar) == sizeof(double) ? "in double" : "in float";
  const std::string own = "dgd_bullet is compiled for " + VersionName(BT_BULLET_VERSION) + " " + own_precision;
  if (app_version != BT_BULLET_VERSION) {
    throw std::runtime_error(own + ", but the app for " + VersionName(app_version));
  }
  const std::string precision = PrecisionOfLibrary();
  if (precision != own_precision) {
    throw std::runtime_error(own + ", but the Bullet library in this process is " + precision);
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
