// All methods on the same recorded pair: in turns, each one's answer judged.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "bench/method_figures.h"
#include "bench/peers/peer.h"
#include "bench/speed_pair.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {

struct ContestMethod {
  std::string key;    ///< On the command line and in files.
  std::string title;  ///< In tables.
  std::variant<SpeedQuestion, MakePeer> how;
  bool is_warm_peer = false;
  bool answers_apart = true;  ///< Says something of sets that are apart.

  bool IsWarm() const;
  double Tolerance() const;
};

/// Those that this process knows: of Bullet, the precision that it is linked with.
const std::vector<ContestMethod>& AllContestMethods();

/// Two shapes, as each method wants them.
class ContestPair {
 public:
  ContestPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2,
              const std::vector<const ContestMethod*>& methods);

  void MoveTo(const PairTurn& turn);

  /// One sample a method, in their order; times are left out of those that do not take the pair.
  /// @param rounds   Turns of all methods, of which the least mean counts.
  /// @param repeats  Queries in a row, of which the mean is taken.
  std::vector<MethodSample> Measure(int rounds, int repeats) const;

  bool Takes(std::size_t method) const;

 private:
  double Time(std::size_t method, int repeats) const;

  const std::vector<const ContestMethod*>& methods_;
  std::unique_ptr<SpeedPair<3>> growth_;      // Null for types that it has none for.
  std::vector<std::unique_ptr<Peer>> peers_;  // Of each method; null for others, and for shapes that it does not take.
  dgd_test::AnyPair<double, 3> judged_;
};

}  // namespace dgd_bench
