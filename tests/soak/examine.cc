#include "soak/examine.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>

#include "support/pairs/limits.h"
#include "support/pairs/status_name.h"

namespace dgd_soak {
namespace {

using dgd_test::AnyPair;
using dgd_test::Limits;
using dgd_test::NameOf;
using dgd_test::PairNumbers;
using dgd_test::Tally;
using dgd_test::Which;

template <class S, int L>
class Examination {
 public:
  /// @param trace  Where to write every answer; null for nowhere.
  Examination(const SoakCase& soak_case, const Query& query, Tally& tally, std::ostream* trace)
      : case_(soak_case), query_(query), tally_(tally), trace_(trace), pair_(Numbers()) {
    complaints_.precision(std::numeric_limits<double>::max_digits10);
    if (trace != nullptr) trace->precision(std::numeric_limits<double>::max_digits10);
    if constexpr (kIsFloat) in_double_.emplace(Numbers());
    if (!kIsFloat && query.tolerance > 0) settings_.relative_tolerance = static_cast<S>(query.tolerance);
  }

  std::string Run() {
    dgd::WarmStart<S, L> warm_start, yes_no_start;
    const int frames = query_.modes.warm ? 1 + static_cast<int>(case_.motion.size()) : 1;
    for (frame_ = 0; frame_ < frames; ++frame_) {
      MoveToFrame();
      const dgd::Result<S, L> result = AskGrowthDistance(warm_start);
      if (frame_ > 0 || query_.modes.cold) Judge(result);
      if (query_.modes.yes_no) CheckYesNo(result, yes_no_start);
    }
    ++tally_.pairs;
    std::string complaints = complaints_.str();
    if (!complaints.empty()) ++tally_.failed_pairs;
    return complaints;
  }

 private:
  static constexpr bool kIsFloat = sizeof(S) == sizeof(float);

  PairNumbers Numbers() const { return kIsFloat ? dgd_test::RoundedToFloat(case_.pair) : case_.pair; }

  /// Of float, too, the case's own numbers: MoveTo() rounds them.
  void MoveToFrame() {
    PairNumbers numbers = case_.pair;
    if (frame_ > 0) numbers.pose_2 = case_.motion[static_cast<std::size_t>(frame_ - 1)];
    pair_.MoveTo(numbers.pose_1, numbers.pose_2);
    if constexpr (kIsFloat) {
      numbers = dgd_test::RoundedToFloat(numbers);
      in_double_->MoveTo(numbers.pose_1, numbers.pose_2);
    }
  }

  /// Its bounds are watched while they approach each other; but not in every second frame, nor at the start of every
  /// second pair, as nobody watches an app's: portal refinement solves only those.
  dgd::Result<S, L> AskGrowthDistance(dgd::WarmStart<S, L>& warm_start) {
    if (trace_ != nullptr) TraceFrame();
    if ((case_.index + frame_) % 2 != 0) return pair_.GrowthDistance(settings_, &warm_start);
    dgd::Iterate<S, L> last{0, 0, std::numeric_limits<S>::infinity(), dgd::Vector<S, L>::Zero()};
    bool is_monotone = true;
    const auto result = pair_.GrowthDistance(settings_, &warm_start, [&](const dgd::Iterate<S, L>& iterate) {
      if (trace_ != nullptr) Trace(iterate);
      if (is_monotone && !IsMonotone(last, iterate)) {
        is_monotone = false;
        Complain("not monotone") << last.lower_bound << " .. " << last.upper_bound << " to " << iterate.lower_bound
                                 << " .. " << iterate.upper_bound << " in iteration " << iterate.iteration << "\n";
      }
      last = iterate;
    });
    if (!is_monotone) ++tally_.non_monotone;
    return result;
  }

  /// The lower bound never falls, the upper one never rises, and they do not cross, but for rounding. False for NaN,
  /// too.
  bool IsMonotone(const dgd::Iterate<S, L>& last, const dgd::Iterate<S, L>& next) const {
    // Planes that the ray meets at a slant magnify it: at a sine of 0.06, 6.5 last digits were seen.
    constexpr double kUnits = 32;
    return IsMonotone(last, next, kUnits) || IsMonotone(last, next, kUnits + UnitsOfHeight(next));
  }

  static bool IsMonotone(const dgd::Iterate<S, L>& last, const dgd::Iterate<S, L>& next, double units) {
    const S slack = static_cast<S>(1 + units * double(dgd::kEpsilon<S>));
    return last.lower_bound <= next.lower_bound * slack && next.upper_bound <= last.upper_bound * slack &&
           next.lower_bound <= next.upper_bound * slack;
  }

  /// Last digits of a plane's height that the last digits of both sets' points are: many where it is near the centre
  /// for the size of the sets, as a flat cone's base. A quarter of them was the most that was seen, in 566 million
  /// queries of which four were beyond what is allowed at a slant.
  double UnitsOfHeight(const dgd::Iterate<S, L>& iterate) const {
    const typename AnyPair<S, L>::Point between = pair_.Center(Which::kSecond) - pair_.Center(Which::kFirst);
    const double height = std::abs(iterate.normal.template cast<double>().dot(between)) / double(iterate.lower_bound);
    return 2 * pair_.Extent() / height;
  }

  Limits<S> LimitsOf(const dgd::Result<S, L>& result) const {
    const bool is_curved = AllTypePairs()[case_.type_pair].IsCurved();
    return {pair_, result, is_curved, double(settings_.relative_tolerance)};
  }

  void Judge(const dgd::Result<S, L>& result) {
    tally_.CountIterations(result.iterations);
    const dgd::Certificate certificate = pair_.Certify(result);
    const Limits<S> limits = LimitsOf(result);
    if (trace_ != nullptr) Trace(result, certificate);
    if (IsCoincident(result, limits)) return;
    if (result.status != dgd::Status::kOptimal) {
      ++tally_.non_optimal;
      if (!IsShortOfFloat(result, certificate, limits)) {
        Complain("status") << NameOf(result.status) << " after " << result.iterations << " iterations, bounds "
                           << result.lower_bound << " .. " << result.upper_bound << "\n";
      }
    } else {
      tally_.relative_gap.Take(certificate.relative_gap, case_.index);
      Demand("relative gap", certificate.relative_gap, limits.gap);
      CheckGrowthDistance(result, limits);
    }
    // In this order, std::max keeps a NaN.
    const double beyond_last_digit = std::max(certificate.primal_infeasibility - limits.carried, 0.0);
    tally_.primal_infeasibility.Take(beyond_last_digit / limits.size, case_.index);
    tally_.dual_infeasibility.Take(certificate.dual_infeasibility, case_.index);
    tally_.separation_error.Take(certificate.separation_error / limits.size, case_.index);
    Demand("primal infeasibility in m", certificate.primal_infeasibility, limits.primal);
    Demand("dual infeasibility", certificate.dual_infeasibility, limits.dual);
    Demand("separation error in m", certificate.separation_error, limits.separation);
  }

  /// Stalled in float, where the rounding of needles' and sheets' points decides more than the tolerance does.
  static bool IsShortOfFloat(const dgd::Result<S, L>& result, const dgd::Certificate& certificate,
                             const Limits<S>& limits) {
    return kIsFloat && result.status == dgd::Status::kStalled && certificate.relative_gap <= limits.answer;
  }

  /// A right answer where the centres' distance is within the rounding of their coordinates.
  bool IsCoincident(const dgd::Result<S, L>& result, const Limits<S>& limits) const {
    const double distance = (pair_.Center(Which::kSecond) - pair_.Center(Which::kFirst)).norm();
    return result.status == dgd::Status::kCoincidentCenters && distance <= 4 * Limits<S>::kEpsilon * limits.size;
  }

  /// Against the one known from the case's construction; of float, against double's answer to the same numbers.
  void CheckGrowthDistance(const dgd::Result<S, L>& result, const Limits<S>& limits) {
    double expected = frame_ == 0 ? case_.growth_distance : 0;
    if constexpr (kIsFloat) {
      const dgd::Result<double, L> in_double = in_double_->GrowthDistance({});
      if (in_double.status != dgd::Status::kOptimal) return;  // Double's own soak complains.
      expected = in_double.upper_bound;
    }
    if (expected == 0) return;
    const double error = std::abs(double(result.upper_bound) - expected);
    tally_.growth_distance_error.Take(error / expected, case_.index);
    Demand("error of the growth distance", error, limits.answer * expected + limits.answer_floor);
  }

  void CheckYesNo(const dgd::Result<S, L>& result, dgd::WarmStart<S, L>& warm_start) {
    const dgd::CollisionResult<S, L> answer = pair_.DetectCollision(settings_, &warm_start);
    const Limits<S> limits = LimitsOf(result);
    const double slack = limits.answer + limits.answer_floor;
    const bool surely_apart = double(result.lower_bound) > 1 + slack;
    const bool surely_colliding = double(result.upper_bound) < 1 - slack;
    const bool agrees = (answer.status == dgd::Status::kSeparated && !surely_colliding) ||
                        (answer.status == dgd::Status::kColliding && !surely_apart) ||
                        (answer.status == dgd::Status::kTouching && !surely_apart && !surely_colliding);
    if (trace_ != nullptr) {
      *trace_ << "  yes/no: " << NameOf(answer.status) << " after " << answer.iterations << " iterations, separation "
              << answer.separation << ", normal " << answer.normal.transpose() << "\n";
    }
    if (agrees) return;
    ++tally_.disagreements;
    Complain("yes/no") << NameOf(answer.status) << ", where the growth distance is between " << result.lower_bound
                       << " and " << result.upper_bound << "\n";
  }

  /// False for NaN, too.
  void Demand(const char* what, double figure, double limit) {
    if (!(figure <= limit)) Complain(what) << figure << ", at most " << limit << "\n";
  }

  std::ostream& Complain(const char* what) { return complaints_ << "  frame " << frame_ << ", " << what << ": "; }

  void TraceFrame() const {
    *trace_ << "frame " << frame_ << (frame_ == 0 ? ", cold" : ", warm") << "\n";
    if (frame_ > 0) {
      *trace_ << "  translation of set 2 " << case_.motion[static_cast<std::size_t>(frame_ - 1)].translation.transpose()
              << "\n";
    }
  }

  void Trace(const dgd::Iterate<S, L>& iterate) const {
    *trace_ << "  " << iterate.iteration << ": " << iterate.lower_bound << " .. " << iterate.upper_bound << ", normal "
            << iterate.normal.transpose() << "\n";
  }

  void Trace(const dgd::Result<S, L>& result, const dgd::Certificate& certificate) const {
    *trace_ << "  status: " << NameOf(result.status) << "\n  bounds: " << result.lower_bound << " .. "
            << result.upper_bound << "\n  separation: " << result.separation
            << "\n  witness 1: " << result.witness_1.transpose() << "\n  witness 2: " << result.witness_2.transpose()
            << "\n  certificate: relative gap " << certificate.relative_gap << ", primal infeasibility "
            << certificate.primal_infeasibility << " m, dual infeasibility " << certificate.dual_infeasibility
            << ", separation error " << certificate.separation_error << " m, size " << LimitsOf(result).size << " m\n";
  }

  const SoakCase& case_;
  const Query& query_;
  Tally& tally_;
  std::ostream* trace_;
  AnyPair<S, L> pair_;
  std::optional<AnyPair<double, L>> in_double_;
  dgd::Settings<S> settings_;
  int frame_ = 0;
  std::ostringstream complaints_;
};

template <class S>
std::string Run(const SoakCase& soak_case, const Query& query, Tally& tally, std::ostream* trace) {
  return AllTypePairs()[soak_case.type_pair].Dimension() == 2 ? Examination<S, 2>(soak_case, query, tally, trace).Run()
                                                              : Examination<S, 3>(soak_case, query, tally, trace).Run();
}

}  // namespace

template <class S>
std::string Examine(const SoakCase& soak_case, const Query& query, Tally& tally) {
  return Run<S>(soak_case, query, tally, nullptr);
}

template <class S>
std::string Describe(const SoakCase& soak_case, const Query& query) {
  std::ostringstream out;
  Tally tally;
  const std::string complaints = Run<S>(soak_case, query, tally, &out);
  return out.str() + (complaints.empty() ? "no complaints\n" : "complaints\n" + complaints);
}

template std::string Examine<double>(const SoakCase& soak_case, const Query& query, Tally& tally);
template std::string Examine<float>(const SoakCase& soak_case, const Query& query, Tally& tally);
template std::string Describe<double>(const SoakCase& soak_case, const Query& query);
template std::string Describe<float>(const SoakCase& soak_case, const Query& query);

}  // namespace dgd_soak
