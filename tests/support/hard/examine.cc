#include "support/hard/examine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "support/hard/distance_truth.h"
#include "support/pairs/limits.h"
#include "support/pairs/status_name.h"

namespace dgd_test {
namespace {

template <class S, int L>
class Examiner {
 public:
  Examiner(const HardClass& hard_class, const HardCase& hard_case, const PairNumbers& numbers)
      : class_(hard_class), case_(hard_case), numbers_(numbers), pair_(numbers) {
    remarks_.precision(std::numeric_limits<double>::max_digits10);
  }

  Examination Run() {
    result_ = pair_.GrowthDistance({});
    examination_.iterations = result_.iterations;
    examination_.microseconds = LeastTime();
    // The slivers that these cases are made of lose as many digits as curved cores do.
    constexpr bool kIsCurved = true;
    limits_.emplace(pair_, result_, kIsCurved, double(dgd::kSqrtEpsilon<S>));
    JudgeGrowthDistance();
    JudgeYesNo(pair_.DetectCollision({}));
    examination_.remarks = remarks_.str();
    return examination_;
  }

 private:
  using Point = typename AnyPair<S, L>::Point;

  double LeastTime() const {
    constexpr int kRounds = 3;
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) {
      const auto start = std::chrono::steady_clock::now();
      const dgd::Result<S, L> result = pair_.GrowthDistance({});
      const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
      if (result.iterations == result_.iterations) least = std::min(least, elapsed.count());
    }
    return least;
  }

  /// What poses that are not rigid make of a length.
  double Roughness() const { return class_.pose_error * limits_->size * std::max(1.0, double(result_.upper_bound)); }

  void JudgeGrowthDistance() {
    const dgd::Certificate certificate = pair_.Certify(result_);
    examination_.relative_gap = certificate.relative_gap;
    const Point between_centers = pair_.Center(Which::kSecond) - pair_.Center(Which::kFirst);
    const double along = std::abs(result_.normal.template cast<double>().dot(between_centers));
    examination_.shortfall =
        certificate.relative_gap * along / std::max(1.0, double(result_.upper_bound)) / limits_->size;
    examination_.primal_infeasibility = certificate.primal_infeasibility / limits_->size;
    switch (result_.status) {
      case dgd::Status::kOptimal:
        Demand("relative gap", certificate.relative_gap, limits_->gap + class_.pose_error);
        DemandValid(certificate);
        break;
      case dgd::Status::kCoincidentCenters: {
        const double distance = (pair_.Center(Which::kSecond) - pair_.Center(Which::kFirst)).norm();
        Demand("distance of coincident centres", distance, 4 * Limits<S>::kEpsilon * limits_->size);
        Demand("separation error", certificate.separation_error, limits_->separation + Roughness());
        break;
      }
      case dgd::Status::kNoInterior:
        Decline();
        // Less than the rounding of the points may be declined.
        if (pair_.Inradii() > Limits<S>::kUnits * Limits<S>::kEpsilon * (pair_.Extent() + pair_.Offset())) {
          examination_.growth_distance = Verdict::kRefuted;
          remarks_ << "  though one set has an interior\n";
        }
        break;
      case dgd::Status::kStalled:
      case dgd::Status::kIterationLimit:
        Decline();
        DemandValid(certificate);
        break;
      default:
        Decline();
        break;
    }
  }

  void DemandValid(const dgd::Certificate& certificate) {
    if (!std::isfinite(double(result_.upper_bound))) return;  // No witness, and none is claimed.
    Demand("primal infeasibility", certificate.primal_infeasibility, limits_->primal + Roughness());
    Demand("dual infeasibility", certificate.dual_infeasibility, limits_->dual + class_.pose_error);
    Demand("separation error", certificate.separation_error, limits_->separation + Roughness());
  }

  void Decline() {
    examination_.growth_distance = Verdict::kDeclined;
    remarks_ << "  " << NameOf(result_.status) << " after " << result_.iterations << " iterations, bounds "
             << result_.lower_bound << " .. " << result_.upper_bound << "\n";
  }

  /// False for NaN, too.
  void Demand(const char* what, double figure, double limit) {
    if (figure <= limit) return;
    examination_.growth_distance = Verdict::kRefuted;
    remarks_ << "  " << NameOf(result_.status) << ", " << what << " " << figure << ", at most " << limit << "\n";
  }

  void JudgeYesNo(const dgd::CollisionResult<S, L>& answer) {
    if (answer.status != dgd::Status::kSeparated && answer.status != dgd::Status::kColliding &&
        answer.status != dgd::Status::kTouching) {
      examination_.is_undecided_yes_no = true;
      remarks_ << "  yes/no: " << NameOf(answer.status) << "\n";
      return;
    }
    const std::string complaint = Contradiction(answer);
    if (complaint.empty()) return;
    examination_.is_wrong_yes_no = true;
    remarks_ << "  yes/no: " << NameOf(answer.status) << ", but " << complaint << "\n";
  }

  /// Empty if the answer is right.
  std::string Contradiction(const dgd::CollisionResult<S, L>& answer) const {
    // What the construction says is true of its own numbers; rounded to float, they are others.
    if (sizeof(S) == sizeof(double)) {
      if (answer.status == dgd::Status::kSeparated && case_.side == Side::kOverlapping) return "made to overlap";
      if (answer.status == dgd::Status::kColliding && case_.side == Side::kApart) return "made to be apart";
    }
    std::ostringstream complaint;
    if constexpr (L == 3) {
      ContradictByDistance(answer, complaint);
    } else {
      ContradictByGrowthDistance(answer, complaint);
    }
    return complaint.str();
  }

  /// A plane proves that the sets are apart, or that they are not that they overlap.
  void ContradictByDistance(const dgd::CollisionResult<S, L>& answer, std::ostream& complaint) const {
    const DistanceTruth truth = TruthOf(numbers_);
    const double slack = YesNoTolerance<S>(truth.reach, class_.pose_error);
    if (answer.status == dgd::Status::kSeparated) {
      const Point normal = answer.normal.template cast<double>().normalized();
      const double separation = SeparationAlong(numbers_, normal);
      if (!(separation >= -slack)) complaint << "along its normal the sets are apart by " << separation << " m";
      return;
    }
    // "Touching" claims no more than a growth distance of 1 within its tolerance.
    const bool is_touching = answer.status == dgd::Status::kTouching;
    const double between_centers = (pair_.Center(Which::kSecond) - pair_.Center(Which::kFirst)).norm();
    const double tolerance = slack + (is_touching ? double(dgd::kSqrtEpsilon<S>) * between_centers : 0);
    if (truth.lower > tolerance || (is_touching && truth.upper < -tolerance)) {
      complaint << "the distance is between " << truth.lower << " and " << truth.upper << " m, tolerance " << tolerance;
    }
  }

  /// In the plane, where no other proof is at hand.
  void ContradictByGrowthDistance(const dgd::CollisionResult<S, L>& answer, std::ostream& complaint) const {
    const bool is_touching = answer.status == dgd::Status::kTouching;
    const double slack = limits_->answer + limits_->answer_floor + (is_touching ? double(dgd::kSqrtEpsilon<S>) : 0);
    const double lower = double(result_.lower_bound), upper = double(result_.upper_bound);
    if ((answer.status != dgd::Status::kSeparated && lower > 1 + slack) ||
        (answer.status != dgd::Status::kColliding && upper < 1 - slack)) {
      complaint << "the growth distance is between " << lower << " and " << upper << ", tolerance " << slack;
    }
  }

  const HardClass& class_;
  const HardCase& case_;
  const PairNumbers& numbers_;
  AnyPair<S, L> pair_;
  dgd::Result<S, L> result_;
  std::optional<Limits<S>> limits_;
  Examination examination_;
  std::ostringstream remarks_;
};

}  // namespace

const char* NameOf(Verdict verdict) {
  static const char* const kNames[] = {"certified", "declined", "refuted"};
  return kNames[static_cast<int>(verdict)];
}

template <class S>
double YesNoTolerance(double reach, double pose_error) {
  constexpr double kUnits = 64;  // Of the last digit of a coordinate.
  return (kUnits * double(dgd::kEpsilon<S>) + pose_error) * reach;
}

template <class S>
Examination Examine(const HardClass& hard_class, const HardCase& hard_case) {
  const PairNumbers numbers = sizeof(S) == sizeof(float) ? RoundedToFloat(hard_case.pair) : hard_case.pair;
  try {
    return InfoOf(numbers.set_1.type).dimension == 2 ? Examiner<S, 2>(hard_class, hard_case, numbers).Run()
                                                     : Examiner<S, 3>(hard_class, hard_case, numbers).Run();
  } catch (const std::invalid_argument& refusal) {
    Examination examination;
    examination.growth_distance = Verdict::kDeclined;
    examination.is_undecided_yes_no = true;
    examination.remarks = std::string("  refused: ") + refusal.what() + "\n";
    return examination;
  }
}

template double YesNoTolerance<double>(double reach, double pose_error);
template double YesNoTolerance<float>(double reach, double pose_error);
template Examination Examine<double>(const HardClass& hard_class, const HardCase& hard_case);
template Examination Examine<float>(const HardClass& hard_class, const HardCase& hard_case);

}  // namespace dgd_test
