// The one place where the demos choose between Bullet's narrowphase and ours.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

class btCollisionConfiguration;
class btDefaultCollisionConfiguration;

namespace dgd_demos {

enum class Narrowphase {
  kBuiltin,  ///< Bullet's GJK/EPA and its special pairs.
  kDgd,      ///< The plugin.
};

/// Name on the command line and in file names: "builtin" or "dgd".
std::string_view NameOf(Narrowphase narrowphase);

/// A narrowphase with options: "friction_anchors=off,patch_size=1" (dgd_bullet/option_text.h), which only the plugin
/// has.
struct NarrowphaseChoice {
  NarrowphaseChoice(Narrowphase of_kind, std::string with_options = "")
      : kind(of_kind), options(std::move(with_options)) {}

  /// The choice that Name() names: "builtin", "dgd", or "dgd:friction_anchors=off,patch_size=1".
  /// @throws std::invalid_argument about an unknown name or a wrong option.
  static NarrowphaseChoice Named(std::string_view name);
  std::string Name() const;

  Narrowphase kind;
  std::string options;
};

/// What differs between two worlds, and nothing else does.
/// @throws std::invalid_argument about an option that is wrong.
std::unique_ptr<btDefaultCollisionConfiguration> MakeCollisionConfiguration(const NarrowphaseChoice& narrowphase);

/// Queries so far that the plugin handed back to the built-in; 0 for the built-in itself.
std::uint64_t Fallbacks(const btCollisionConfiguration& configuration);

/// "float" or "double": what Bullet computes in here.
const char* BulletPrecision();

}  // namespace dgd_demos
