#include "simulation/narrowphase.h"

#include <dgd_bullet/collision_configuration.h>
#include <dgd_bullet/option_text.h>
#include <dgd_bullet/register.h>

#include <stdexcept>
#include <type_traits>

namespace dgd_demos {

std::string_view NameOf(Narrowphase narrowphase) { return narrowphase == Narrowphase::kBuiltin ? "builtin" : "dgd"; }

NarrowphaseChoice NarrowphaseChoice::Named(std::string_view name) {
  if (name == "builtin") return Narrowphase::kBuiltin;
  const std::size_t colon = name.find(':');
  if (name.substr(0, colon) != "dgd") {
    throw std::invalid_argument("there is no narrowphase '" + std::string(name) +
                                "', but builtin, dgd, and dgd:OPTION=VALUE,...");
  }
  NarrowphaseChoice choice = Narrowphase::kDgd;
  if (colon != name.npos) choice.options = name.substr(colon + 1);
  dgd_bullet::MakeNarrowphase(dgd_bullet::ParseOptions(choice.options));
  return choice;
}

std::string NarrowphaseChoice::Name() const {
  const std::string name(NameOf(kind));
  return options.empty() ? name : name + ":" + options;
}

std::unique_ptr<btDefaultCollisionConfiguration> MakeCollisionConfiguration(const NarrowphaseChoice& narrowphase) {
  if (narrowphase.kind == Narrowphase::kBuiltin) return std::make_unique<btDefaultCollisionConfiguration>();
  return std::make_unique<dgd_bullet::CollisionConfiguration>(dgd_bullet::ParseOptions(narrowphase.options));
}

std::uint64_t Fallbacks(const btCollisionConfiguration& configuration) {
  const auto* dgd = dynamic_cast<const dgd_bullet::CollisionConfiguration*>(&configuration);
  return dgd == nullptr ? 0 : dgd->statistics().Fallbacks();
}

const char* BulletPrecision() { return std::is_same_v<btScalar, double> ? "double" : "float"; }

}  // namespace dgd_demos
