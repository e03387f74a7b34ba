#include "bench/contest.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "bench/growth_methods.h"
#include "bench/guarded_peer.h"
#include "bench/peers/bullet_peers.h"
#include "bench/peers/fcl_peer.h"
#include "bench/peers/ours_peer.h"
#include "bench/referee.h"
#include "bench/stopwatch.h"
#include "bench/textbook/comparators.h"

namespace dgd_bench {
namespace {

MethodSample SampleOf(const GrowthAnswer& answer, const Referee& referee) {
  MethodSample sample = answer.sample;
  sample.is_wrong = (referee.AreApart() && answer.upper_bound < 1) || (referee.Overlap() && answer.lower_bound > 1);
  return sample;
}

MethodSample SampleOf(const std::optional<SeparationAnswer>& answer, bool answers_apart, const Referee& referee) {
  MethodSample sample;
  if (!answer || !answer->HasNormal()) {
    sample.is_missing = answers_apart || referee.Overlap();
    return sample;
  }
  const SeparationErrors errors = referee.Judge(*answer);
  sample.normal_error = errors.normal;
  sample.depth_error = errors.depth;
  sample.witness_error = errors.witness;
  sample.is_wrong = errors.is_wrong;
  return sample;
}

}  // namespace

bool ContestMethod::IsWarm() const {
  const auto* query = std::get_if<GrowthQuery>(&how);
  return is_warm_peer || (query != nullptr && query->is_warm);
}

double ContestMethod::Tolerance() const {
  const auto* query = std::get_if<GrowthQuery>(&how);
  return query != nullptr ? query->tolerance : 0;
}

const std::vector<ContestMethod>& AllContestMethods() {
  static const std::vector<ContestMethod> kMethods = [] {
    const std::string of_bullet = std::string(", ") + BulletPrecision();
    std::vector<ContestMethod> methods = {
        {.key = "bullet_gjk_epa", .title = "Bullet GJK/EPA" + of_bullet, .how = MakeBulletGjkEpa},
        {.key = "bullet_mpr", .title = "Bullet MPR" + of_bullet, .how = MakeBulletMpr, .answers_apart = false},
        {.key = "fcl", .title = "FCL (libccd), double", .how = MakeFclPeer, .may_abort = true},
        {.key = "signed_distance", .title = "ours, signed distance", .how = MakeOursPeer},
        {.key = "signed_distance_warm",
         .title = "ours, signed distance, warm",
         .how = MakeOursWarmPeer,
         .is_warm_peer = true},
    };
    for (const GrowthMethod& method : kGrowthMethods) {
      methods.push_back({.key = method.key, .title = method.title, .how = method.query});
    }
    return methods;
  }();
  return kMethods;
}

ContestPair::ContestPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2,
                         const ContestMethods& methods)
    : methods_(methods), growth_(MakeComparedPair(set_1, set_2)), judged_({set_1, set_2, {}, {}}) {
  for (const ContestMethod* method : methods) {
    const auto* make = std::get_if<MakePeer>(&method->how);
    peers_.push_back(make != nullptr ? (*make)(set_1, set_2) : nullptr);
  }
}

void ContestPair::MoveTo(const PairTurn& turn) {
  judged_.MoveTo(turn.pose_1, turn.pose_2);
  for (const auto& peer : peers_) {
    if (peer != nullptr) peer->MoveTo(turn);
  }
  // Warm starts depend on the pair's relative pose alone: set 2 is where set 1 would have seen it.
  const Eigen::Matrix3d rotation = turn.pose_1.rotation * turn.last_pose_1.rotation.transpose();
  const dgd_test::PoseNumbers seen_2{
      rotation * turn.last_pose_2.rotation,
      turn.pose_1.translation + rotation * (turn.last_pose_2.translation - turn.last_pose_1.translation)};
  growth_->MoveTo({turn.pose_1, seen_2, turn.pose_2});
}

bool ContestPair::Takes(std::size_t method) const {
  const auto* query = std::get_if<GrowthQuery>(&methods_[method]->how);
  if (query == nullptr) return peers_[method] != nullptr;
  return growth_->Takes(*query);
}

std::vector<MethodSample> ContestPair::Measure(int rounds, int repeats) const {
  std::vector<char> gives_up(methods_.size());
  for (std::size_t m = 0; m < methods_.size(); ++m) gives_up[m] = Takes(m) && GivesUp(m);
  const std::vector<double> times = LeastOfRounds(rounds, methods_.size(), [&](std::size_t m) {
    return Takes(m) && !gives_up[m] ? Time(m, repeats) : MethodSample::kNone;
  });
  const Referee referee(judged_);
  std::vector<MethodSample> samples(methods_.size());
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    if (!Takes(m)) continue;
    if (gives_up[m]) {
      samples[m] = SampleOf(std::nullopt, methods_[m]->answers_apart, referee);
    } else if (peers_[m] != nullptr) {
      samples[m] = SampleOf(peers_[m]->Ask(), methods_[m]->answers_apart, referee);
    } else {
      samples[m] = SampleOf(growth_->Solve(std::get<GrowthQuery>(methods_[m]->how)), referee);
    }
    samples[m].microseconds = times[m];
  }
  return samples;
}

bool ContestPair::GivesUp(std::size_t method) const {
  constexpr std::chrono::seconds kPatience(5);
  return methods_[method]->may_abort && *AskInChild(*peers_[method], 1, kPatience).reason != '\0';
}

double ContestPair::Time(std::size_t method, int repeats) const {
  if (peers_[method] != nullptr) return peers_[method]->Time(repeats);
  return growth_->Time(std::get<GrowthQuery>(methods_[method]->how), repeats);
}

void AddContestOptions(dgd_demos::CommandLine& line, ContestOptions& options) {
  constexpr int kMost = 1'000'000;
  std::vector<std::string> keys;
  std::string all_keys;
  for (const ContestMethod& method : AllContestMethods()) {
    if (!keys.empty()) all_keys += ", ";
    all_keys += keys.emplace_back(method.key);
  }
  line.AddChoices("--methods", "A,B", options.methods, keys, "Some of the methods: " + all_keys);
  line.AddNumber("--rounds", "N", options.rounds, {1, kMost}, "Turns of all methods; the least mean of each counts");
  line.AddNumber("--repeats", "N", options.repeats, {1, kMost}, "Queries in a row; their mean counts");
  line.AddPath("--csv", "FILE", options.csv, "Write the figures to this file");
}

ContestMethods MethodsOf(const ContestOptions& options) {
  ContestMethods methods;
  for (const ContestMethod& method : AllContestMethods()) {
    if (options.methods.empty() || std::ranges::count(options.methods, method.key) > 0) methods.push_back(&method);
  }
  return methods;
}

void ContestFigures::Take(const ContestPair& pair, const std::vector<MethodSample>& samples, std::int64_t index) {
  for (std::size_t m = 0; m < figures_.size(); ++m) {
    if (pair.Takes(m)) figures_[m].Take(samples[m], index);
  }
}

std::vector<MethodSummary> ContestFigures::Summarize() const {
  std::vector<MethodSummary> summaries;
  for (const MethodFigures& figures : figures_) summaries.push_back(figures.Summarize());
  return summaries;
}

void PrintNumber(const char* format, int width, double number) {
  if (std::isnan(number)) {
    std::printf("%*s", width, "");
  } else {
    std::printf(format, number);
  }
}

void PrintContest(const ContestMethods& methods, const std::vector<MethodSummary>& summaries) {
  std::printf("%-32s%8s%8s%8s%9s%8s%7s%10s%10s%10s%10s%10s%7s%8s%8s%10s\n", "", "pairs", "p50", "p99", "p99.99", "mean",
              "ratio", "gap max", "primal", "norm. p99", "norm. max", "depth max", "wrong", "missing", "failed",
              "worst");
  double bullet_p50 = MethodSample::kNone;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m]->key == "bullet_gjk_epa") bullet_p50 = summaries[m].p50;
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const MethodSummary& summary = summaries[m];
    std::printf("%-32s", methods[m]->title.c_str());
    if (summary.pairs == 0) {
      std::printf("unsupported\n");
      continue;
    }
    std::printf("%8zu%8.3f%8.3f%9.3f%8.3f", summary.pairs, summary.p50, summary.p99, summary.p9999, summary.mean);
    PrintNumber("%7.2f", 7, summary.p50 / bullet_p50);
    const ErrorFigure &gap = summary.Of(ErrorKind::kGap), &normal = summary.Of(ErrorKind::kNormal);
    PrintNumber("%10.1e", 10, gap.most);
    PrintNumber("%10.1e", 10, summary.Of(ErrorKind::kPrimal).most);
    PrintNumber("%10.1e", 10, normal.p99);
    PrintNumber("%10.1e", 10, normal.most);
    PrintNumber("%10.1e", 10, summary.Of(ErrorKind::kDepth).most);
    std::printf("%7lld%8lld%8lld", static_cast<long long>(summary.wrong), static_cast<long long>(summary.missing),
                static_cast<long long>(summary.failures));
    const std::int64_t worst = std::max(gap.worst_pair, normal.worst_pair);
    if (worst >= 0) std::printf("%10lld", static_cast<long long>(worst));
    std::printf("\n");
  }
}

void WriteContest(FiguresCsv& csv, const std::string& work, const ContestMethods& methods,
                  const std::vector<MethodSummary>& summaries) {
  for (std::size_t m = 0; m < summaries.size(); ++m) {
    const ContestMethod& method = *methods[m];
    csv.Write({work, method.key, method.title, method.IsWarm(), method.Tolerance()}, summaries[m]);
  }
}

bool HaveOursFailed(const ContestMethods& methods, const std::vector<MethodSummary>& summaries) {
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (methods[m]->title.starts_with("ours") && summaries[m].wrong + summaries[m].missing > 0) return true;
  }
  return false;
}

}  // namespace dgd_bench
