// What a pair's algorithm reports to a dispatcher that decides the pair itself as long as it is apart.
#pragma once

#include <LinearMath/btVector3.h>

#include "dgd_bullet/linkage.h"

class btCollisionAlgorithm;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct SeparationReport {
  /// The algorithm of two convex shapes that was called last, or null.
  const btCollisionAlgorithm* algorithm = nullptr;
  /// Whether its pair is apart along the cached axis, and nothing of the pair changes in a call that finds the same:
  /// neither its contacts nor its manifold nor what is cached. Only then is valid what follows.
  bool is_apart = false;
  bool is_swapped = false;      ///< Whether body A is the second one of the call.
  double separation = -1;       ///< Lower bound of the distance along the normal, metres; < 0 if there is none.
  double contact_distance = 0;  ///< Bodies that are nearer than this may have contacts; metres.
  btVector3 normal_in_a;        ///< Normal from A to B, in A's frame; unit.
  btVector3 normal_w;           ///< The normal in the world.
};

/// The place that the thread's calls report to, or null.
extern constinit thread_local SeparationReport* separation_report;

/// Sets that place as long as this lives.
class ReportScope {
 public:
  explicit ReportScope(SeparationReport& report) : outer_(separation_report) { separation_report = &report; }
  ~ReportScope() { separation_report = outer_; }
  ReportScope(const ReportScope&) = delete;
  ReportScope& operator=(const ReportScope&) = delete;

 private:
  SeparationReport* const outer_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
