// The narrowphase for unmodified programs, in one precision of Bullet. The stub opens it once a dispatcher of that
// precision fills its tables.
#include "backend.h"

#include <errno.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "audit.h"
#include "dgd_bullet/option_text.h"
#include "dgd_bullet/register.h"
#include "environment.h"
#include "total_statistics.h"

namespace dgd_preload {
namespace {

/// One narrowphase per configuration. The end of a configuration goes unnoticed, so none is ever freed: a configuration
/// that is made later at the same address shares the narrowphase, which refers to neither of them. Memory for
/// algorithms and manifolds comes from the dispatcher that each call brings, and so from its own configuration's pools.
class Narrowphases {
 public:
  /// Throws as MakeNarrowphase().
  explicit Narrowphases(const dgd_bullet::Options& options) : options_(options) {
    dgd_bullet::MakeNarrowphase(options);
  }

  dgd_bullet::Narrowphase& Of(const void* configuration) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<dgd_bullet::Narrowphase>& narrowphase = of_configuration_[configuration];
    if (narrowphase == nullptr) narrowphase = dgd_bullet::MakeNarrowphase(options_);
    return *narrowphase;
  }

  dgd_bullet::Statistics Total() {
    const std::lock_guard lock(mutex_);
    dgd_bullet::Statistics total;
    for (const auto& [configuration, narrowphase] : of_configuration_) {
      Add(dgd_bullet::StatisticsOf(*narrowphase), total);
    }
    return total;
  }

 private:
  const dgd_bullet::Options options_;
  std::mutex mutex_;
  std::unordered_map<const void*, std::shared_ptr<dgd_bullet::Narrowphase>> of_configuration_;
};

/// These are never destroyed: worlds with static storage may outlive any object of ours.
Narrowphases* g_narrowphases = nullptr;
Audit* g_audit = nullptr;  ///< Null unless both narrowphases are used.

constexpr const char* kPrecision = sizeof(btScalar) == sizeof(double) ? "double" : "float";

/// A program that uses dgd_bullet itself queries Bullet's configuration only for types that dgd_bullet leaves to it.
constexpr const char* kNoPairs =
    "; no pair went through dgd-bullet-run: none met, or the program uses dgd_bullet itself";

void PrintStatistics() {
  const dgd_bullet::Statistics total = g_narrowphases->Total();
  std::fprintf(stderr, "dgd-bullet: %s, Bullet in %s%s:\n%s", program_invocation_name, kPrecision,
               total.pairs.empty() ? kNoPairs : "", dgd_bullet::ToJson(total).c_str());
}

void PrintAudit() {
  const std::string pairs = g_audit->ToText();
  if (pairs.empty()) {
    std::fprintf(stderr, "dgd-bullet: audit of %s, Bullet in %s%s.\n", program_invocation_name, kPrecision, kNoPairs);
    return;
  }
  std::fprintf(stderr,
               "dgd-bullet: audit of %s, Bullet in %s. The contacts of these pairs were the built-in's; separations, "
               "in metres, are those of the deepest contact of a call:\n%s",
               program_invocation_name, kPrecision, pairs.c_str());
}

/// @return null where the types are left to Bullet.
btCollisionAlgorithmCreateFunc* OurCreateFunc(const void* configuration, Table table, int type_0, int type_1,
                                              btCollisionAlgorithmCreateFunc& original) {
  dgd_bullet::Narrowphase& narrowphase = g_narrowphases->Of(configuration);
  if (g_audit == nullptr && table == kContacts) return dgd_bullet::ContactCreateFunc(narrowphase, type_0, type_1);
  auto* closest_points = dgd_bullet::ClosestPointsCreateFunc(narrowphase, type_0, type_1);
  if (g_audit == nullptr || closest_points == nullptr) return closest_points;
  return g_audit->CreateFuncOf(original, *closest_points);
}

/// Throws std::exception with the reason why there are none.
void MakeNarrowphases() {
  const char* text = std::getenv(kOptions);
  dgd_bullet::Options options = dgd_bullet::ParseOptions(text != nullptr ? text : "");
  options.count_pairs = IsOn(kStatistics);
  g_narrowphases = new Narrowphases(options);
  if (options.count_pairs) std::atexit(PrintStatistics);
  if (!IsOn(kAudit)) return;
  g_audit = new Audit();
  std::atexit(PrintAudit);
}

}  // namespace
}  // namespace dgd_preload

extern "C" {

[[gnu::visibility("default")]] const char* dgd_bullet_preload_start() {
  static const std::string& reason = *new std::string([]() -> std::string {
    try {
      dgd_preload::MakeNarrowphases();
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }());
  return reason.empty() ? nullptr : reason.c_str();
}

[[gnu::visibility("default")]] void* dgd_bullet_preload_choose_create_func(const void* configuration,
                                                                           dgd_preload::Table table, int type_0,
                                                                           int type_1, void* original) {
  try {
    btCollisionAlgorithmCreateFunc* ours = dgd_preload::OurCreateFunc(
        configuration, table, type_0, type_1, *static_cast<btCollisionAlgorithmCreateFunc*>(original));
    return ours != nullptr ? ours : original;
  } catch (const std::exception&) {
    return original;  // No memory for another narrowphase.
  }
}
}
