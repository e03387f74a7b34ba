#include "bench/growth_distance_query.h"

#include <cmath>

#include "bench/stopwatch.h"
#include "bench/textbook/plain_algorithm.h"
#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes/polytope.h"
#include "dgd/signed_distance.h"

namespace dgd_bench {
namespace {

template <class S>
dgd::Pose<S> ToPose(const dgd_demos::Pose& pose) {
  return {pose.rotation.cast<S>(), pose.position.cast<S>()};
}

// The pair as the solver takes it. Rounding to float is part of the solver's error: the oracle judges the true pair.
template <class S>
class SolverQuery : public Query {
 protected:
  using Set = dgd::RoundedSet<dgd::CoreReference<dgd::Polytope<S>>>;

  explicit SolverQuery(const HullPair& pair)
      : core_1_(pair.core_1.vertices),
        core_2_(pair.core_2.vertices),
        set_1_{core_1_, static_cast<S>(pair.margin)},
        set_2_{core_2_, static_cast<S>(pair.margin)},
        pose_1_(ToPose<S>(pair.pose_1)),
        pose_2_(ToPose<S>(pair.pose_2)) {}

  Judgement JudgeDistance(const HullPair& pair, const dgd::Result<S>& result) const {
    const dgd::Certificate certificate = dgd::Certify(set_1_, pose_1_, set_2_, pose_2_, result);
    Judgement judgement;
    judgement.is_failure = result.status != dgd::Status::kOptimal;
    judgement.normal_error = NormalError(pair, result.normal.template cast<double>());
    judgement.iterations = result.iterations;
    judgement.relative_gap = certificate.relative_gap;
    judgement.primal_infeasibility = certificate.primal_infeasibility;
    return judgement;
  }

  const dgd::Polytope<S> core_1_, core_2_;
  const Set set_1_, set_2_;
  const dgd::Pose<S> pose_1_, pose_2_;
};

template <class S>
class ColdQuery : public SolverQuery<S> {
 public:
  explicit ColdQuery(const HullPair& pair) : SolverQuery<S>(pair) {}

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Ask()); });
  }
  Judgement Judge(const HullPair& pair) const override { return this->JudgeDistance(pair, Ask()); }

 private:
  dgd::Result<S> Ask() const { return dgd::GrowthDistance(this->set_1_, this->pose_1_, this->set_2_, this->pose_2_); }
};

class WarmQuery : public SolverQuery<double> {
 public:
  explicit WarmQuery(const HullPair& pair) : SolverQuery(pair) {
    dgd::GrowthDistance(set_1_, pose_1_, set_2_, ToPose<double>(pair.last_pose_2), {}, &last_);
  }

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Ask()); });
  }
  Judgement Judge(const HullPair& pair) const override { return JudgeDistance(pair, Ask()); }

 private:
  dgd::Result<double> Ask() const {
    dgd::WarmStart<double> warm_start = last_;  // Each repeat is the second query again, not a third.
    const dgd::Result<double> result = dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_, {}, &warm_start);
    Keep(warm_start);
    return result;
  }

  dgd::WarmStart<double> last_;
};

/// The yardstick.
class PlainQuery : public SolverQuery<double> {
 public:
  explicit PlainQuery(const HullPair& pair) : SolverQuery(pair) {}

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Ask()); });
  }
  Judgement Judge(const HullPair& pair) const override { return JudgeDistance(pair, Ask()); }

 private:
  dgd::Result<double> Ask() const { return PlainGrowthDistance(plain_1_, pose_1_, plain_2_, pose_2_); }

  const SupportFunctionOf<Set::Core> plain_1_{set_1_}, plain_2_{set_2_};
};

/// The growth distance, and from there to the least translation or the distance.
class SignedDistanceQuery : public SolverQuery<double> {
 public:
  explicit SignedDistanceQuery(const HullPair& pair) : SolverQuery(pair) {}

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Ask()); });
  }

  Judgement Judge(const HullPair& pair) const override {
    const dgd::SignedDistanceResult<double> result = Ask();
    Judgement judgement;
    judgement.is_failure = result.status != dgd::Status::kOptimal;
    judgement.normal_error = NormalError(pair, result.normal);
    judgement.iterations = result.iterations;
    return judgement;
  }

 private:
  dgd::SignedDistanceResult<double> Ask() const {
    dgd::WarmStart<double> warm_start;
    const dgd::Result<double> growth = dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_, {}, &warm_start);
    dgd::SignedDistanceResult<double> result =
        dgd::SignedDistance(set_1_, pose_1_, set_2_, pose_2_, growth, &warm_start);
    result.iterations += growth.iterations;
    return result;
  }
};

class CollisionQuery : public SolverQuery<double> {
 public:
  explicit CollisionQuery(const HullPair& pair) : SolverQuery(pair) {}

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Ask()); });
  }

  Judgement Judge(const HullPair& pair) const override {
    const dgd::CollisionResult<double> result = Ask();
    Judgement judgement;
    judgement.iterations = result.iterations;
    judgement.is_failure = !IsRight(result.status, pair.signed_distance);
    return judgement;
  }

 private:
  static bool IsRight(dgd::Status status, double signed_distance) {
    // Rounding of the pair's own signed distance, m.
    constexpr double kRounding = 1e-11;
    // "Touching" is what the solver's tolerance, sqrt(epsilon) of about a metre, cannot tell apart from either.
    constexpr double kUndecided = 1e-7;
    switch (status) {
      case dgd::Status::kSeparated:
        return signed_distance > -kRounding;
      case dgd::Status::kColliding:
        return signed_distance < kRounding;
      case dgd::Status::kTouching:
        return std::abs(signed_distance) <= kUndecided;
      default:
        return false;
    }
  }

  dgd::CollisionResult<double> Ask() const { return dgd::DetectCollision(set_1_, pose_1_, set_2_, pose_2_); }
};

}  // namespace

std::unique_ptr<Query> MakeColdQuery(const HullPair& pair) { return std::make_unique<ColdQuery<double>>(pair); }
std::unique_ptr<Query> MakeColdFloatQuery(const HullPair& pair) { return std::make_unique<ColdQuery<float>>(pair); }
std::unique_ptr<Query> MakeWarmQuery(const HullPair& pair) { return std::make_unique<WarmQuery>(pair); }
std::unique_ptr<Query> MakeSignedDistanceQuery(const HullPair& pair) {
  return std::make_unique<SignedDistanceQuery>(pair);
}
std::unique_ptr<Query> MakePlainQuery(const HullPair& pair) { return std::make_unique<PlainQuery>(pair); }
std::unique_ptr<Query> MakeCollisionQuery(const HullPair& pair) { return std::make_unique<CollisionQuery>(pair); }

}  // namespace dgd_bench
