// The audit runs both narrowphases side by side: an app's contacts stay the built-in's to the last bit, and ours are
// compared with them.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "audit_report.h"

namespace dgd_preload {

/// Makes the built-in's algorithm of a pair, and ours, which is called after it with a manifold and a result of its
/// own: nothing that an app sees is changed. Bullet's callbacks are not called for our contacts.
class AuditCreateFunc final : public btCollisionAlgorithmCreateFunc {
 public:
  /// @param builtin  Used for as long as its configuration lives.
  /// @param ours     One whose contacts are those of the present poses: that of the closest points.
  /// @param report   Filled by the algorithms' calls.
  AuditCreateFunc(btCollisionAlgorithmCreateFunc& builtin, btCollisionAlgorithmCreateFunc& ours, AuditReport& report);

  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* body_0,
                                                 const btCollisionObjectWrapper* body_1) override;

 private:
  btCollisionAlgorithmCreateFunc &builtin_, &ours_;
  AuditReport& report_;
};

/// The audit of a process.
class Audit {
 public:
  /// One for each two functions, which lives as long as this.
  AuditCreateFunc* CreateFuncOf(btCollisionAlgorithmCreateFunc& builtin, btCollisionAlgorithmCreateFunc& ours);

  std::string ToText() const { return report_.ToText(); }

 private:
  using Functions = std::pair<btCollisionAlgorithmCreateFunc*, btCollisionAlgorithmCreateFunc*>;

  AuditReport report_;
  std::mutex mutex_;
  std::map<Functions, std::unique_ptr<AuditCreateFunc>> create_funcs_;
};

}  // namespace dgd_preload
