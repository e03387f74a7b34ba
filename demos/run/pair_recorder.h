// The recorder of a run's queries. It is a library of its own, which a build may leave out (DGD_BUILD_RECORD).
#pragma once

#ifdef DGD_DEMOS_RECORD
#include <dgd_bullet/recorder.h>
#else
#include <dgd_bullet/options.h>

#include <stdexcept>
#include <string>
#endif

namespace dgd_demos {

#ifdef DGD_DEMOS_RECORD
inline constexpr bool kHasRecorder = true;
using PairRecorder = dgd_bullet::Recorder;
#else
inline constexpr bool kHasRecorder = false;
/// Is never made.
class PairRecorder final : public dgd_bullet::PairObserver {
 public:
  explicit PairRecorder(const std::string& path) { throw std::logic_error(path + ": no recorder is built"); }
  void OnPair(const btCollisionObjectWrapper&, const btCollisionObjectWrapper&) noexcept override {}
  void NextStep() {}
  void Close() {}
};
#endif

}  // namespace dgd_demos
