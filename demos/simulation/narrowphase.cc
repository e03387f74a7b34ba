#include "simulation/narrowphase.h"

#include <dgd_bullet/collision_configuration.h>

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>

namespace dgd_demos {
namespace {

struct Variant {
  Narrowphase narrowphase;
  std::string_view name;
  std::optional<dgd_bullet::Options> options;  // None: Bullet's own.
};

constexpr dgd_bullet::Options kWithGrowthNormals = [] {
  dgd_bullet::Options options;
  options.normal_mode = dgd_bullet::NormalMode::kGrowth;
  return options;
}();

constexpr dgd_bullet::Options kSharp = [] {
  dgd_bullet::Options options;
  options.geometry_mode = dgd_bullet::GeometryMode::kSharp;
  return options;
}();

constexpr dgd_bullet::Options kLean = [] {
  dgd_bullet::Options options;
  options.keep_empty_manifolds = false;
  return options;
}();

constexpr std::array kVariants = {
    Variant{Narrowphase::kBuiltin, "builtin", std::nullopt},
    Variant{Narrowphase::kDgd, "dgd", dgd_bullet::Options{}},
    Variant{Narrowphase::kDgdGrowth, "dgd_growth", kWithGrowthNormals},
    Variant{Narrowphase::kDgdSharp, "dgd_sharp", kSharp},
    Variant{Narrowphase::kDgdLean, "dgd_lean", kLean},
};

const Variant& VariantOf(Narrowphase narrowphase) {
  return *std::ranges::find(kVariants, narrowphase, &Variant::narrowphase);
}

}  // namespace

std::vector<Narrowphase> AllNarrowphases() {
  std::vector<Narrowphase> all;
  for (const Variant& variant : kVariants) all.push_back(variant.narrowphase);
  return all;
}

std::string_view NameOf(Narrowphase narrowphase) { return VariantOf(narrowphase).name; }

std::unique_ptr<btDefaultCollisionConfiguration> MakeCollisionConfiguration(Narrowphase narrowphase) {
  const std::optional<dgd_bullet::Options>& options = VariantOf(narrowphase).options;
  if (options) return std::make_unique<dgd_bullet::CollisionConfiguration>(*options);
  return std::make_unique<btDefaultCollisionConfiguration>();
}

std::uint64_t Fallbacks(const btCollisionConfiguration& configuration) {
  const auto* dgd = dynamic_cast<const dgd_bullet::CollisionConfiguration*>(&configuration);
  return dgd == nullptr ? 0 : dgd->statistics().Fallbacks();
}

const char* BulletPrecision() { return std::is_same_v<btScalar, double> ? "double" : "float"; }

}  // namespace dgd_demos
