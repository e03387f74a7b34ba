// A signed-distance solver on a pair of sets, of another library or of ours: one way to ask them all.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "support/pairs/set_numbers.h"

namespace dgd_bench {

/// What such a solver says: how far the sets are apart, below 0 for overlap, and along which normal.
struct SeparationAnswer {
  /// From set 1 to set 2, world; of unit length, unless the solver knows none: then zero, or not finite.
  Eigen::Vector3d normal;
  double separation;                     ///< Metres.
  Eigen::Vector3d witness_1, witness_2;  ///< Points of the sets that are so far apart, world.

  bool HasNormal() const { return normal.squaredNorm() > 0; }
};

/// Where a pair of bodies is, and where it was when it was last asked about.
struct PairTurn {
  dgd_test::PoseNumbers last_pose_1, last_pose_2, pose_1, pose_2;
};

/// Both sets, made ready once, then asked in many poses.
class Peer {
 public:
  Peer() = default;
  virtual ~Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// The last poses are for those that remember.
  virtual void MoveTo(const PairTurn& turn) = 0;
  virtual double Time(int repeats) const = 0;               ///< Mean of so many queries in a row, us.
  virtual std::optional<SeparationAnswer> Ask() const = 0;  ///< Nothing where the solver reports nothing.
};

/// Null for sets that the solver has no shapes for.
using MakePeer = std::unique_ptr<Peer> (*)(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
