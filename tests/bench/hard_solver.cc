#include <stdexcept>

#include "bench/hard_method.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {
namespace {

template <class S>
class SignedDistanceHardQuery : public HardQuery {
 public:
  explicit SignedDistanceHardQuery(const dgd_test::PairNumbers& pair) : pair_(pair) {}

  HardAnswer Ask() const override {
    dgd::WarmStart<S> warm_start;
    const dgd::Result<S> growth = pair_.GrowthDistance({}, &warm_start);
    if (growth.status == dgd::Status::kInvalidInput) return {.reason = "invalid input"};
    const dgd::SignedDistanceResult<S> result = pair_.SignedDistance(growth, &warm_start);
    if (result.status != dgd::Status::kOptimal) return {.reason = "not optimal"};
    return {.distance = double(result.separation), .normal = result.normal.template cast<double>()};
  }

 private:
  dgd_test::AnyPair<S, 3> pair_;
};

/// A set that a constructor refuses.
class RefusedQuery : public HardQuery {
 public:
  HardAnswer Ask() const override { return {.reason = "refused"}; }
};

template <class S>
std::unique_ptr<HardQuery> Make(const dgd_test::PairNumbers& pair) try {
  return std::make_unique<SignedDistanceHardQuery<S>>(pair);
} catch (const std::invalid_argument&) {
  return std::make_unique<RefusedQuery>();
}

}  // namespace

std::unique_ptr<HardQuery> MakeSignedDistanceInDouble(const dgd_test::PairNumbers& pair) { return Make<double>(pair); }
std::unique_ptr<HardQuery> MakeSignedDistanceInFloat(const dgd_test::PairNumbers& pair) { return Make<float>(pair); }

}  // namespace dgd_bench
