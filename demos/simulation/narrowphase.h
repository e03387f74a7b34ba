// The one place where the demos choose between Bullet's narrowphase and ours.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

class btCollisionConfiguration;
class btDefaultCollisionConfiguration;

namespace dgd_demos {

/// Each has its row in narrowphase.cc: name, and options of the plugin. A new variant is an enumerator and such a row.
enum class Narrowphase {
  kBuiltin,    ///< Bullet's GJK/EPA and its special pairs.
  kDgd,        ///< The plugin with its default options.
  kDgdGrowth,  ///< ... with the growth distance's own normals.
  kDgdSharp,   ///< ... without margins.
  kDgdLean,    ///< ... with manifolds for pairs that touch only.
};

/// All of them, in the order in which they are listed and compared.
std::vector<Narrowphase> AllNarrowphases();

/// As on the command line and in file names.
std::string_view NameOf(Narrowphase narrowphase);

/// What differs between the two worlds, and nothing else does.
std::unique_ptr<btDefaultCollisionConfiguration> MakeCollisionConfiguration(Narrowphase narrowphase);

/// Queries so far that the plugin handed back to the built-in; 0 for the built-in itself.
std::uint64_t Fallbacks(const btCollisionConfiguration& configuration);

/// "float" or "double": what Bullet computes in here.
const char* BulletPrecision();

}  // namespace dgd_demos
