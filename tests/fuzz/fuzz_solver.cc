// The solver on any two sets in any poses: growth distance, yes/no, signed distance and time of impact, cold and from
// any warm start, in double and float, in space and in the plane.
//
// Whatever the numbers: no exception but std::invalid_argument from a set's constructor, an end, and a result that is
// finite and ordered unless its status says that there is none. Where the numbers keep the contract of
// dgd/convex_set.h, an optimal result is certified; and where they are such as a robot's or a game's, it is optimal.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "fuzz/fuzz_input.h"
#include "fuzz/fuzz_target.h"
#include "support/pairs/any_pair.h"
#include "support/pairs/limits.h"
#include "support/pairs/set_numbers.h"

namespace dgd_fuzz {
namespace {

using dgd::Status;
using dgd_test::AnyPair;
using dgd_test::PairNumbers;
using dgd_test::PoseNumbers;
using dgd_test::SetNumbers;
using dgd_test::SetType;
using dgd_test::Which;

// ---- From bytes to a case.

struct FuzzCase {
  bool is_float;
  int dimension;
  PairNumbers pair;
  PoseNumbers moved;  ///< Where set 2 is next.
  double relative_tolerance, separation_limit;
  int max_iterations;
};

SetType TypeOf(FuzzInput& input, int dimension) {
  constexpr int kSolids = static_cast<int>(SetType::kCircle);
  const int flats = static_cast<int>(dgd_test::kSetTypeCount) - kSolids;
  return static_cast<SetType>(dimension == 3 ? input.Below(kSolids) : kSolids + input.Below(flats));
}

SetNumbers ReadSet(FuzzInput& input, int dimension) {
  constexpr int kMostPoints = 24;
  SetNumbers set;
  set.type = TypeOf(input, dimension);
  // Half of all sets are such as an app's are: else few would get past the constructors.
  const bool is_moderate = input.Flip();
  set.lengths = is_moderate ? Eigen::Vector3d(input.ModerateVector().cwiseAbs()) : input.Vector();
  const bool is_sharp = input.Flip();
  const double radius = is_moderate ? std::abs(input.ModerateNumber()) : input.Number();
  set.radius = is_sharp ? 0 : radius;
  set.exponent = is_moderate ? 2 + std::abs(input.ModerateNumber()) : input.Number();
  set.stretch = input.Rotation(3);
  set.stretch *= 1 + std::abs(input.ModerateNumber());
  const int points = 3 + input.Below(kMostPoints);  // Three at least: a triangle's.
  for (int i = 0; i < points; ++i) set.points.push_back(is_moderate ? input.ModerateVector() : input.Vector());
  return set;
}

PoseNumbers ReadPose(FuzzInput& input, int dimension) {
  PoseNumbers pose;
  pose.rotation = input.Rotation(dimension);
  pose.translation = input.Flip() ? input.ModerateVector() : input.Vector();
  if (dimension == 2) pose.translation.z() = 0;
  return pose;
}

FuzzCase ReadCase(FuzzInput& input) {
  FuzzCase fuzz_case{};
  fuzz_case.is_float = input.Flip();
  fuzz_case.dimension = input.Below(4) == 0 ? 2 : 3;
  const int d = fuzz_case.dimension;
  fuzz_case.relative_tolerance = std::ldexp(1.0, -input.Below(64));
  fuzz_case.max_iterations = input.Flip() ? 100 : 1 + input.Below(256);
  fuzz_case.separation_limit =
      input.Flip() ? std::numeric_limits<double>::infinity() : std::abs(input.ModerateNumber());
  fuzz_case.pair.pose_1 = ReadPose(input, d);
  fuzz_case.pair.pose_2 = ReadPose(input, d);
  fuzz_case.moved = ReadPose(input, d);
  fuzz_case.pair.set_1 = ReadSet(input, d);
  fuzz_case.pair.set_2 = ReadSet(input, d);
  return fuzz_case;
}

/// Any features, and a normal of unit length or none: what a query of other sets may have left.
template <class S, int L>
dgd::WarmStart<S, L> ReadWarmStart(FuzzInput& input) {
  dgd::WarmStart<S, L> start;
  for (int axis = 0; axis < L; ++axis) start.normal_1[axis] = S(input.ModerateNumber());
  start.normal_1 = start.normal_1.stableNormalized().eval();
  for (std::size_t i = 0; i < start.features_1.size(); ++i) {
    start.features_1[i] = input.Flip() ? input.Byte() : input.Bits<dgd::FeatureId>();
    start.features_2[i] = input.Flip() ? input.Byte() : input.Bits<dgd::FeatureId>();
  }
  start.size = input.Below(L + 1);
  return start;
}

// ---- What may be demanded of which case.

template <int L>
bool IsRotation(const PoseNumbers& pose, double tolerance) {
  const dgd::SquareMatrix<double, L> rotation = pose.rotation.topLeftCorner<L, L>();
  const dgd::SquareMatrix<double, L> square = rotation.transpose() * rotation;
  return (square - dgd::SquareMatrix<double, L>::Identity()).cwiseAbs().maxCoeff() <= tolerance &&
         rotation.determinant() > 0;
}

/// Which of the promises hold for a pair in its poses.
enum class Demand {
  kNoCrash,    ///< The numbers break the contract: not finite, no rotation, a negative radius.
  kCertified,  ///< They keep it.
  kOptimal,    ///< And are a pair as an app has them: nothing is a thousand times another, nor near the scalar's range.
};

template <class S, int L>
Demand DemandOn(const AnyPair<S, L>& pair, const PairNumbers& numbers) {
  const double rounding = 16 * dgd::kEpsilon<S>;
  const bool are_poses = IsRotation<L>(numbers.pose_1, rounding) && IsRotation<L>(numbers.pose_2, rounding);
  const bool are_sets = numbers.set_1.radius >= 0 && numbers.set_2.radius >= 0;
  // These two of the tests' own check nothing, as a user's core may.
  const auto is_checked = [](const SetNumbers& set) {
    const bool is_super = set.type == SetType::kSuperellipsoid || set.type == SetType::kSuperellipse;
    return !is_super || (set.lengths.minCoeff() > 0 && set.exponent >= 2);
  };
  const double extent = pair.Extent(), inradii = pair.Inradii();
  const double reach =
      std::max(pair.Center(Which::kFirst).cwiseAbs().maxCoeff(), pair.Center(Which::kSecond).cwiseAbs().maxCoeff()) +
      extent;
  // What the certificate computes must not overflow; in float the query's own numbers must not, either.
  const double most = sizeof(S) == 8 ? 1e100 : 1e12;
  if (!are_poses || !are_sets || !is_checked(numbers.set_1) || !is_checked(numbers.set_2) ||
      !(reach <= most && inradii >= 1 / most && extent >= 1 / most)) {
    return Demand::kNoCrash;
  }
  const bool is_common = reach <= 100 * extent && inradii >= 1e-3 * extent && extent <= 1e3 && extent >= 1e-3;
  return is_common ? Demand::kOptimal : Demand::kCertified;
}

// ---- The questions, and what is wrong with an answer.

template <class S, int L>
class Questioning {
 public:
  explicit Questioning(const FuzzCase& fuzz_case) : case_(fuzz_case), pair_(fuzz_case.pair) {
    settings_.relative_tolerance = std::max(S(fuzz_case.relative_tolerance), 4 * dgd::kEpsilon<S>);
    settings_.max_iterations = fuzz_case.max_iterations;
    settings_.separation_limit = S(fuzz_case.separation_limit);
  }

  void Ask(FuzzInput& input) {
    dgd::WarmStart<S, L> start = ReadWarmStart<S, L>(input), yes_no_start = start;
    AskOne(nullptr);
    AskOne(&start);
    Check(pair_.DetectCollision(settings_), "yes/no, cold");
    Check(pair_.DetectCollision(settings_, &yes_no_start), "yes/no, from any start");
    case_.pair.pose_2 = case_.moved;
    pair_.MoveTo(case_.pair.pose_1, case_.pair.pose_2);
    AskOne(&start);
    Check(pair_.DetectCollision(settings_, &yes_no_start), "yes/no, moved");
    if constexpr (L == 3) AskTimeOfImpact(input);
  }

 private:
  void AskOne(dgd::WarmStart<S, L>* start) {
    const dgd::Result<S, L> result = pair_.GrowthDistance(settings_, start);
    const char* question = start == nullptr ? "growth distance, cold" : "growth distance, from a start";
    Check(result, question);
    if constexpr (L == 3) {
      Check(pair_.SignedDistance(result, start, settings_), "signed distance");
    }
  }

  void AskTimeOfImpact(FuzzInput& input) requires(L == 3) {
    const auto motion_from = [&](const PoseNumbers& pose) {
      dgd::Motion<S> motion;
      motion.start = {pose.rotation.cast<S>(), pose.translation.cast<S>()};
      motion.translation = input.Vector().cast<S>();
      motion.rotation = input.Vector().cast<S>();
      return motion;
    };
    const dgd::Motion<S> motion_1 = motion_from(case_.pair.pose_1), motion_2 = motion_from(case_.pair.pose_2);
    const dgd::TimeOfImpactResult<S> result = pair_.TimeOfImpact(motion_1, motion_2);
    if (result.status == Status::kInvalidInput) return;
    Require(result.time >= 0 && result.time <= 1, "time of impact", "time");
  }

  void Check(const dgd::Result<S, L>& result, const char* question) {
    using std::isfinite;
    if (result.status == Status::kInvalidInput || result.status == Status::kNoInterior) return;
    const Demand demand = DemandOn(pair_, case_.pair);
    Require(isfinite(result.lower_bound) && !std::isnan(result.upper_bound) && isfinite(result.separation) &&
                result.normal.allFinite() && result.witness_1.allFinite() && result.witness_2.allFinite(),
            question, "not finite");
    Require(result.lower_bound >= 0 && result.lower_bound <= result.upper_bound, question, "bounds not in order");
    if (demand == Demand::kNoCrash) return;
    const dgd_test::Limits<S> limits(pair_, result, true, double(settings_.relative_tolerance));
    if (result.status == Status::kOptimal) {
      const dgd::Certificate certificate = pair_.Certify(result);
      Require(certificate.relative_gap <= kSlack * limits.gap, question, "gap", certificate.relative_gap, limits.gap);
      Require(certificate.primal_infeasibility <= kSlack * limits.primal, question, "primal infeasibility",
              certificate.primal_infeasibility, limits.primal);
      Require(certificate.dual_infeasibility <= kSlack * limits.dual, question, "dual infeasibility",
              certificate.dual_infeasibility, limits.dual);
      Require(certificate.separation_error <= kSlack * limits.separation, question, "separation",
              certificate.separation_error, limits.separation);
    } else if (demand == Demand::kOptimal && settings_.max_iterations >= 100) {
      const bool may_end_so = result.status == Status::kSeparated || result.status == Status::kCoincidentCenters;
      // Asked for more than rounding allows, a query ends short of it.
      const bool is_nearly_optimal = result.RelativeGap() <= S(kSlack * limits.answer) + 64 * dgd::kSqrtEpsilon<S>;
      Require(may_end_so || is_nearly_optimal, question, "neither optimal nor nearly so", double(result.RelativeGap()),
              limits.answer);
    }
  }

  void Check(const dgd::CollisionResult<S, L>& result, const char* question) {
    if (result.status == Status::kInvalidInput || result.status == Status::kNoInterior) return;
    Require(std::isfinite(result.separation) && result.normal.allFinite() && result.point.allFinite(), question,
            "not finite");
    if (result.status != Status::kSeparated || DemandOn(pair_, case_.pair) == Demand::kNoCrash) return;
    Require(result.separation > 0, question, "separated by nothing");
  }

  void Check(const dgd::SignedDistanceResult<S>& result, const char* question) requires(L == 3) {
    if (result.status == Status::kInvalidInput) return;
    Require(std::isfinite(result.separation) && !std::isnan(result.upper_bound) && result.normal.allFinite() &&
                result.witness_1.allFinite() && result.witness_2.allFinite(),
            question, "not finite");
    if (DemandOn(pair_, case_.pair) == Demand::kNoCrash) return;
    const double proven = SeparationAlong(pair_, result.normal.template cast<double>());
    const double reach =
        pair_.Extent() + pair_.Offset() + pair_.Center(Which::kFirst).norm() + pair_.Center(Which::kSecond).norm();
    Require(std::abs(proven - double(result.separation)) <=
                kSlack * dgd_test::Limits<S>::kSeparationUnits * dgd::kEpsilon<S> * reach,
            question, "separation", proven, double(result.separation));
  }

  void Require(bool holds, const char* question, const char* what, double figure = 0, double limit = 0) const {
    if (holds) return;
    std::ostringstream message;
    message.precision(17);
    message << question << ": " << what << " " << figure << " (" << limit << ") in "
            << (case_.is_float ? "float" : "double") << "\ntolerance " << settings_.relative_tolerance << ", "
            << settings_.max_iterations << " iterations, separation limit " << settings_.separation_limit << "\n"
            << Dump(case_.pair);
    Fail(message.str());
  }

  /// The soak's limits are for sets no more skewed than its own.
  static constexpr double kSlack = 16;

  FuzzCase case_;
  AnyPair<S, L> pair_;
  dgd::Settings<S> settings_;
};

template <class S, int L>
void Ask(const FuzzCase& fuzz_case, FuzzInput& input) {
  std::optional<Questioning<S, L>> questioning;
  try {
    questioning.emplace(fuzz_case);
  } catch (const std::invalid_argument&) {
    return;  // A shape's constructor refused its numbers.
  }
  questioning->Ask(input);
}

}  // namespace
}  // namespace dgd_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dgd_fuzz;
  FuzzInput input({data, size});
  FuzzCase fuzz_case = ReadCase(input);
  if (fuzz_case.is_float) {
    // The certificate is for the numbers that the query sees.
    fuzz_case.pair = dgd_test::RoundedToFloat(fuzz_case.pair);
    fuzz_case.dimension == 2 ? Ask<float, 2>(fuzz_case, input) : Ask<float, 3>(fuzz_case, input);
  } else {
    fuzz_case.dimension == 2 ? Ask<double, 2>(fuzz_case, input) : Ask<double, 3>(fuzz_case, input);
  }
  return 0;
}
