#include "simulation/narrowphase.h"

#include <dgd_bullet/collision_configuration.h>

namespace dgd_demos {

std::string_view NameOf(Narrowphase narrowphase) { return narrowphase == Narrowphase::kDgd ? "dgd" : "builtin"; }

std::unique_ptr<btDefaultCollisionConfiguration> MakeCollisionConfiguration(Narrowphase narrowphase) {
  if (narrowphase == Narrowphase::kDgd) return std::make_unique<dgd_bullet::CollisionConfiguration>();
  return std::make_unique<btDefaultCollisionConfiguration>();
}

std::uint64_t Fallbacks(const btCollisionConfiguration& configuration) {
  const auto* dgd = dynamic_cast<const dgd_bullet::CollisionConfiguration*>(&configuration);
  return dgd == nullptr ? 0 : dgd->statistics().Fallbacks();
}

}  // namespace dgd_demos
