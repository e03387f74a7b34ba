// hard_cases: the catalogue of hard cases, asked of the growth distance and of others. See --help.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bench/exit_status.h"
#include "bench/guarded_peer.h"
#include "bench/peers/any_pair_peer.h"
#include "bench/peers/bullet_peers.h"
#include "bench/peers/fcl_peer.h"
#include "command_line.h"
#include "program_main.h"
#include "support/hard/distance_truth.h"
#include "support/hard/examine.h"

namespace dgd_bench {
namespace {

using dgd_test::DistanceTruth;
using dgd_test::Examination;
using dgd_test::HardCase;
using dgd_test::HardClass;
using dgd_test::PairNumbers;
using dgd_test::Verdict;

constexpr const char* kDescription =
    R"(Asks the growth distance, Bullet's GJK and EPA, and FCL (libccd) about the hard cases of the tests:
needles, size ratios, micrometres, exact contact of all features, flat sets, and what other engines'
public issues report. Judges every answer by the pair's support functions alone.)";

constexpr const char* kFooter = R"(
Examples:
  hard_cases                          all classes, Bullet in float: a minute
  hard_cases_float64                  the same, Bullet in double
  hard_cases --class rims --cases 2000
  hard_cases --class rims --replay 17 all about one case
  hard_cases --list                   the classes, and what is hard about each

Rows:     growth distance, by its certificate, and its collision check; signed distance, Bullet and FCL by
          the distance and the normal that they report. Each method is asked about the numbers as its
          scalar rounds them.
Columns:  cases that the method has sets for; share certified: of the growth distance by the certificate
          within the limits of rounding, of the others where the supporting planes along the normal are as
          far apart as the distance says; declined: gave up, said nothing, crashed, or did not end in half
          a second; refuted: not borne out; wrong: apart said to overlap, or the opposite, by more than the tolerance; the
          certificate's worst gap as a length, or how much of the distance or least translation the worst
          normal misses, of answers that are not wrong, relative to the pair's size; the longest time in us,
          each the least of --rounds.
Tolerance: of the growth distance 64 units of the last digit of a coordinate; of the others 1e-9 of the
          pair's size in double and 1e-5 in float, or --tolerance.

Exit status: 0; 1 a growth distance was refuted or wrong; 2 wrong command line.)";

struct Options {
  int cases = 200;
  std::uint64_t seed = 1;
  int rounds = 3;
  double tolerance = 0;
  std::string only;
  std::optional<int> replay;
  bool is_list = false;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMost = 1'000'000;
  Options options;
  dgd_demos::CommandLine line("hard_cases", kDescription, kFooter);
  std::vector<std::string> names;
  for (const HardClass& hard_class : dgd_test::AllHardClasses()) names.emplace_back(hard_class.name);
  line.AddNumber("--cases", "N", options.cases, {1, kMost}, "Cases of each class");
  line.AddSeed(options.seed, "Seed of the cases");
  line.AddNumber("--rounds", "N", options.rounds, {1, kMost},
                 "Times that each query is timed, of which the least counts");
  line.AddNumber("--tolerance", "T", options.tolerance, {0, 0.1},
                 "Of distances and of yes or no, relative; 0 for the scalar's");
  line.AddChoice("--class", "NAME", options.only, names, "Only this class");
  line.AddIndex("--replay", options.replay, "Print every method's answer to the case of this index");
  line.AddFlag("--list", options.is_list, "List the classes");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

/// What one method makes of a class.
struct Row {
  int asked = 0, certified = 0, declined = 0, refuted = 0, wrong = 0;
  double worst_error = 0;
  double longest = 0;  // us

  Row& operator+=(const Row& other) {
    asked += other.asked;
    certified += other.certified;
    declined += other.declined;
    refuted += other.refuted;
    wrong += other.wrong;
    worst_error = std::max(worst_error, other.worst_error);
    longest = std::max(longest, other.longest);
    return *this;
  }
};

/// What is true of a case as one scalar rounds it.
struct RoundedCase {
  RoundedCase(const PairNumbers& exact, bool is_double, const Options& options)
      : numbers(is_double ? exact : dgd_test::RoundedToFloat(exact)), truth(dgd_test::TruthOf(numbers)) {
    tolerance = options.tolerance > 0 ? options.tolerance : is_double ? 1e-9 : 1e-5;
    // And what the last digits of the coordinates leave open.
    const double rounding =
        is_double ? dgd_test::YesNoTolerance<double>(truth.reach, 0) : dgd_test::YesNoTolerance<float>(truth.reach, 0);
    slack = tolerance * std::max(truth.size, truth.upper) + rounding;
  }

  PairNumbers numbers;
  DistanceTruth truth;
  double tolerance;
  double slack;  // m
};

struct Judgement {
  Verdict verdict = Verdict::kCertified;
  bool is_wrong = false;
  double error = 0;
};

Judgement Judge(const RoundedCase& rounded, const std::optional<SeparationAnswer>& answer) {
  if (!answer) return {Verdict::kDeclined};
  const DistanceTruth& truth = rounded.truth;
  const double distance = answer->separation;
  Judgement judgement;
  judgement.is_wrong = (distance <= 0 && truth.lower > rounded.slack) || (distance > 0 && truth.upper < -rounded.slack);
  const double length = answer->normal.norm();
  const bool is_unit = std::isfinite(distance) && std::abs(length - 1) <= std::max(rounded.tolerance, 1e-6);
  if (!is_unit) return {Verdict::kRefuted, judgement.is_wrong, 0};
  const double separation = dgd_test::SeparationAlong(rounded.numbers, answer->normal / length);
  if (!(std::abs(separation - distance) <= rounded.slack)) judgement.verdict = Verdict::kRefuted;
  if (!judgement.is_wrong)
    judgement.error = std::max(0.0, truth.lower - separation) / std::max(truth.size, truth.upper);
  return judgement;
}

struct Method {
  const char* name;
  bool is_double;
  MakePeer make;
  bool is_ours = false;  // Others may never end.
};

std::vector<Method> AllMethods() {
  const bool is_bullet_in_double = BulletPrecision() == std::string_view("double");
  return {{"signed distance, double", true, MakeSignedDistanceInDouble, true},
          {"signed distance, float", false, MakeSignedDistanceInFloat, true},
          {is_bullet_in_double ? "Bullet float64" : "Bullet float", is_bullet_in_double, MakeBulletGjkEpa},
          {"FCL (libccd), double", true, MakeFclPeer}};
}

constexpr std::array kGrowthDistances = {"growth distance, double", "growth distance, float"};

void Take(const Judgement& judgement, double microseconds, Row& row) {
  const auto is = [&](Verdict verdict) { return judgement.verdict == verdict ? 1 : 0; };
  row += {1,
          is(Verdict::kCertified),
          is(Verdict::kDeclined),
          is(Verdict::kRefuted),
          judgement.is_wrong ? 1 : 0,
          judgement.error,
          microseconds};
}

Judgement JudgementOf(const Examination& examination) {
  const double error = examination.growth_distance == Verdict::kCertified ? examination.shortfall : 0;
  return {examination.growth_distance, examination.is_wrong_yes_no, error};
}

/// The rows of one class: the growth distances, then the other methods.
struct ClassRows {
  const HardClass* hard_class;
  std::vector<Row> rows;
};

bool IsOfSpace(const HardCase& hard_case) { return dgd_test::InfoOf(hard_case.pair.set_1.type).dimension == 3; }

/// A set that a method refuses to be made of counts as declined.
std::unique_ptr<Peer> MakePosed(const Method& method, const PairNumbers& numbers, bool& is_refused) try {
  std::unique_ptr<Peer> peer = method.make(numbers.set_1, numbers.set_2);
  if (peer != nullptr) peer->MoveTo({numbers.pose_1, numbers.pose_2, numbers.pose_1, numbers.pose_2});
  return peer;
} catch (const std::exception&) {
  is_refused = true;
  return nullptr;
}

TimedAnswer AskPatiently(const Method& method, const Peer& peer, int rounds) {
  constexpr std::chrono::milliseconds kPatience{500};  // A thousand times what the longest queries that end take.
  return method.is_ours ? AskAndTime(peer, rounds) : AskInChild(peer, rounds, kPatience);
}

void AskMethod(const Method& method, const RoundedCase& rounded, const Options& options, Row& row) {
  bool is_refused = false;
  const std::unique_ptr<Peer> peer = MakePosed(method, rounded.numbers, is_refused);
  if (is_refused) Take({Verdict::kDeclined}, 0, row);
  if (peer == nullptr) return;
  const TimedAnswer timed = AskPatiently(method, *peer, options.rounds);
  Take(Judge(rounded, timed.answer), timed.microseconds, row);
}

ClassRows AskAll(const HardClass& hard_class, const std::vector<Method>& methods, const Options& options) {
  ClassRows result{&hard_class, std::vector<Row>(kGrowthDistances.size() + methods.size())};
  for (int index = 0; index < options.cases; ++index) {
    const HardCase hard_case = dgd_test::MakeHardCase(hard_class, options.seed, index);
    const Examination in_double = dgd_test::Examine<double>(hard_class, hard_case);
    const Examination in_float = dgd_test::Examine<float>(hard_class, hard_case);
    Take(JudgementOf(in_double), in_double.microseconds, result.rows[0]);
    Take(JudgementOf(in_float), in_float.microseconds, result.rows[1]);
    if (!IsOfSpace(hard_case)) continue;
    try {
      const RoundedCase as_double(hard_case.pair, true, options), as_float(hard_case.pair, false, options);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const RoundedCase& rounded = methods[m].is_double ? as_double : as_float;
        AskMethod(methods[m], rounded, options, result.rows[kGrowthDistances.size() + m]);
      }
    } catch (const std::invalid_argument&) {
      // Rounded, or at all, the numbers are no sets: nobody knows what is true.
    }
  }
  return result;
}

std::string NameOfRow(std::size_t row, const std::vector<Method>& methods) {
  return row < kGrowthDistances.size() ? kGrowthDistances[row] : methods[row - kGrowthDistances.size()].name;
}

void Print(const ClassRows& measured, const std::vector<Method>& methods) {
  std::printf("%s: %s\n", measured.hard_class->name, measured.hard_class->why);
  for (std::size_t i = 0; i < measured.rows.size(); ++i) {
    const Row& row = measured.rows[i];
    std::printf("  %-26s%8d", NameOfRow(i, methods).c_str(), row.asked);
    if (row.asked == 0) {
      std::printf("  unsupported\n");
      continue;
    }
    std::printf("%10.2f%%%10d%9d%7d%10.1e%10.1f\n", 100.0 * row.certified / row.asked, row.declined, row.refuted,
                row.wrong, row.worst_error, row.longest);
  }
  std::fflush(stdout);
}

void Replay(const HardClass& hard_class, const std::vector<Method>& methods, const Options& options) {
  const HardCase hard_case = dgd_test::MakeHardCase(hard_class, options.seed, *options.replay);
  std::cout << hard_class.name << ", case " << *options.replay << "\n" << dgd_test::Dump(hard_case.pair);
  const auto print = [](const char* name, const Examination& examination) {
    std::cout << name << ": " << NameOf(examination.growth_distance) << ", gap " << examination.relative_gap << "\n"
              << examination.remarks;
  };
  print(kGrowthDistances[0], dgd_test::Examine<double>(hard_class, hard_case));
  print(kGrowthDistances[1], dgd_test::Examine<float>(hard_class, hard_case));
  if (!IsOfSpace(hard_case)) return;
  for (const Method& method : methods) {
    const RoundedCase rounded(hard_case.pair, method.is_double, options);
    bool is_refused = false;
    const std::unique_ptr<Peer> peer = MakePosed(method, rounded.numbers, is_refused);
    std::cout << method.name << ": true distance " << rounded.truth.lower << " .. " << rounded.truth.upper << " m, ";
    if (peer == nullptr) {
      std::cout << (is_refused ? "refused\n" : "unsupported\n");
      continue;
    }
    const TimedAnswer timed = AskPatiently(method, *peer, 1);
    const std::optional<SeparationAnswer>& answer = timed.answer;
    const Judgement judgement = Judge(rounded, answer);
    std::cout << NameOf(judgement.verdict) << (judgement.is_wrong ? ", wrong" : "");
    if (answer) std::cout << ", says " << answer->separation << " m along " << answer->normal.transpose();
    std::cout << ' ' << timed.reason << '\n';
  }
}

ExitStatus Run(const Options& options) {
  const std::vector<Method> methods = AllMethods();
  std::vector<const HardClass*> chosen;
  for (const HardClass& hard_class : dgd_test::AllHardClasses()) {
    if (options.is_list) std::printf("%-22s%s\n", hard_class.name, hard_class.why);
    if (options.only.empty() || options.only == hard_class.name) chosen.push_back(&hard_class);
  }
  if (options.is_list) return kSuccess;
  if (options.replay) {
    std::cout.precision(std::numeric_limits<double>::max_digits10);
    for (const HardClass* hard_class : chosen) Replay(*hard_class, methods, options);
    return kSuccess;
  }
  std::printf("%d cases a class, seed %llu\n", options.cases, static_cast<unsigned long long>(options.seed));
  std::printf("%-28s%8s%11s%10s%9s%7s%10s%10s\n", "", "cases", "certified", "declined", "refuted", "wrong", "error",
              "us");
  const HardClass all_classes{"all", "all of these", nullptr};
  ClassRows total{&all_classes, std::vector<Row>(kGrowthDistances.size() + methods.size())};
  bool is_sound = true;
  for (const HardClass* hard_class : chosen) {
    const ClassRows measured = AskAll(*hard_class, methods, options);
    Print(measured, methods);
    for (std::size_t i = 0; i < measured.rows.size(); ++i) total.rows[i] += measured.rows[i];
  }
  for (std::size_t i = 0; i < kGrowthDistances.size(); ++i) {
    is_sound = is_sound && total.rows[i].refuted == 0 && total.rows[i].wrong == 0;
  }
  Print(total, methods);
  return is_sound ? kSuccess : kFailedQuery;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
