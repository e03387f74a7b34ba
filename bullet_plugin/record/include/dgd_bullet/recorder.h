// Records the queries of a narrowphase, to be replayed through others: see tests/bench/narrowphase_replay.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A file of recorded pairs (dgd_bullet/record_file.h). Set as Options::pair_observer, it is shown each pair of convex
/// shapes that the dispatcher processes; with another narrowphase, the app calls OnPair() itself. Any number of threads
/// may.
///
/// Left out, and counted, are shapes that only their own support function describes (multi-spheres, scaled shapes,
/// users' own), and what is no shape: without points, or with a size that is not finite.
class DGD_BULLET_EXPORT Recorder final : public PairObserver {
 public:
  /// Makes or replaces the file. Throws std::runtime_error naming it if it cannot be written.
  explicit Recorder(const std::string& path);
  ~Recorder();  ///< Closes the file, and reports no errors.
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// What comes now belongs to the next step: call it from the world's tick callback. Until then, it is step 0.
  void NextStep();

  /// One pair of convex shapes, in the order in which Bullet queries them. Never throws: errors of writing are reported
  /// at the end.
  void OnPair(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1) noexcept override;

  std::uint64_t pair_count() const;  ///< So far, without those left out.

  /// Ends the file; what is added later is lost. Throws std::runtime_error naming the file if not all of it could be
  /// written.
  void Close();

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
