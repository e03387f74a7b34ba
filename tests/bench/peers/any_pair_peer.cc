#include "bench/peers/any_pair_peer.h"

#include "bench/stopwatch.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {
namespace {

template <class S>
class SignedDistancePeer : public Peer {
 public:
  SignedDistancePeer(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2)
      : pair_({set_1, set_2, {}, {}}) {}

  void MoveTo(const PairTurn& turn) override { pair_.MoveTo(turn.pose_1, turn.pose_2); }

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Solve()); });
  }

  std::optional<SeparationAnswer> Ask() const override {
    const dgd::SignedDistanceResult<S> result = Solve();
    if (result.status != dgd::Status::kOptimal) return std::nullopt;
    return SeparationAnswer{result.normal.template cast<double>(), double(result.separation),
                            result.witness_1.template cast<double>(), result.witness_2.template cast<double>()};
  }

 private:
  dgd::SignedDistanceResult<S> Solve() const {
    dgd::WarmStart<S> warm_start;
    const dgd::Result<S> growth = pair_.GrowthDistance({}, &warm_start);
    if (growth.status == dgd::Status::kInvalidInput) return {};
    return pair_.SignedDistance(growth, &warm_start);
  }

  dgd_test::AnyPair<S, 3> pair_;
};

}  // namespace

std::unique_ptr<Peer> MakeSignedDistanceInDouble(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  return std::make_unique<SignedDistancePeer<double>>(set_1, set_2);
}

std::unique_ptr<Peer> MakeSignedDistanceInFloat(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  return std::make_unique<SignedDistancePeer<float>>(set_1, set_2);
}

}  // namespace dgd_bench
