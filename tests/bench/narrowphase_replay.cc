// narrowphase_replay: every method on the pairs that a narrowphase was asked about, time beside error. See --help.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "bench/contest.h"
#include "bench/peers/bullet_peers.h"
#include "command_line.h"
#include "dgd_bullet/record_file.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Asks every method about the same recorded pairs, in the order of the record: ours, the paper's algorithm,
Bullet's GJK/EPA and MPR, FCL. Times each, and has its answer judged by what belongs to none of them: growth
distances by their certificate, signed distances by planes and points of the sets' support functions.)";

constexpr const char* kFooter = R"(
Examples:
  polytope_drop --record --no-snapshots --out out
  narrowphase_replay out/builtin.rec            what fifty falling polytopes ask, Bullet in float
  narrowphase_replay_float64 out/builtin.rec    the same, Bullet in double
  narrowphase_replay out/builtin.rec --pair 81234
                                                one of them alone: its numbers, and each method's answer

A record of your own app: dgd_bullet/recorder.h.

Rows:     the methods; growth distance and signed distance are two problems. Warm is from the answer to the
          pair's last recorded pose; pairs without one are not asked about.
Columns:  pairs that the method takes; times of a query in us, each the least of --rounds means of --repeats,
          percentiles by nearest rank; p50 over that of Bullet's GJK/EPA. Of growth distances the worst
          relative gap and primal infeasibility, of signed distances the error of the normal (how much longer a
          way it takes to part the sets along it) and of the depth along it: 99 % and worst. Wrong yes/no
          answers, answers missing, queries that did not converge; and the pair with the worst error.

Exit status: 0; 1 a wrong answer or none from ours; 2 wrong command line, or no record; 3 the record is damaged
or not complete: what there is of it was replayed.)";

enum ReplayStatus { kReplayed = 0, kOursFailed = 1, kBadInput = 2, kDamagedRecord = 3 };

struct Options {
  std::filesystem::path record;
  int pairs = 20'000;
  ContestOptions contest;
  std::optional<int> pair;
};

std::variant<Options, ReplayStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMost = 100'000'000;
  Options options;
  dgd_demos::CommandLine line("narrowphase_replay", kDescription, kFooter);
  line.AddArgument("record", "FILE", options.record, "The record");
  line.AddNumber("--pairs", "N", options.pairs, {1, kMost}, "Pairs, spread evenly over the record");
  AddContestOptions(line, options.contest);
  line.AddIndex("--pair", options.pair, "Only the pair of this index");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ReplayStatus(*end);
  return options;
}

dgd_test::SetType TypeOf(dgd_bullet::RecordedShape::Core core) {
  using dgd_test::SetType;
  using Core = dgd_bullet::RecordedShape::Core;
  switch (core) {
    case Core::kPoint:
      return SetType::kPoint;
    case Core::kSegment:
      return SetType::kSegment;
    case Core::kTriangle:
      return SetType::kTriangle;
    case Core::kBox:
      return SetType::kBox;
    case Core::kCylinder:
      return SetType::kCylinder;
    case Core::kCone:
      return SetType::kCone;
    case Core::kHull:
      break;
  }
  return SetType::kPolytope;
}

dgd_test::SetNumbers SetFrom(const dgd_bullet::RecordedShape& shape) {
  using Core = dgd_bullet::RecordedShape::Core;
  dgd_test::SetNumbers set{.type = TypeOf(shape.core), .radius = shape.radius};
  if (shape.core == Core::kTriangle || shape.core == Core::kHull) {
    for (std::size_t i = 0; i < shape.numbers.size(); i += 3) {
      set.points.emplace_back(shape.numbers[i], shape.numbers[i + 1], shape.numbers[i + 2]);
    }
  } else {
    std::ranges::copy(shape.numbers, set.lengths.begin());
  }
  return set;
}

/// The nearest pose whose axes are orthonormal: those of float are off by 1e-7, which no solver answers for.
dgd_test::PoseNumbers PoseFrom(const dgd_bullet::RecordedPose& pose) {
  dgd_test::PoseNumbers numbers;
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Matrix3d rotation = Eigen::Map<const RowMajor>(pose.rotation.data());
  numbers.rotation = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  numbers.translation = Eigen::Map<const Eigen::Vector3d>(pose.translation.data());
  return numbers;
}

/// A pair of the record that was asked about before.
struct Turn {
  std::size_t index, last_index;
};

/// All that have a last pose; with the same two shapes, since bodies may change theirs.
std::vector<Turn> TurnsOf(const dgd_bullet::Record& record) {
  std::vector<Turn> turns;
  std::unordered_map<std::uint32_t, std::size_t> last;
  for (std::size_t i = 0; i < record.pairs.size(); ++i) {
    const dgd_bullet::RecordedPair& pair = record.pairs[i];
    const auto [place, is_new] = last.try_emplace(pair.body_pair, i);
    if (is_new) continue;
    const dgd_bullet::RecordedPair& before = record.pairs[place->second];
    if (before.shape_1 == pair.shape_1 && before.shape_2 == pair.shape_2) turns.push_back({i, place->second});
    place->second = i;
  }
  return turns;
}

std::vector<Turn> SpreadOver(const std::vector<Turn>& turns, std::size_t most) {
  if (turns.size() <= most) return turns;
  std::vector<Turn> chosen;
  for (std::size_t i = 0; i < most; ++i) chosen.push_back(turns[i * turns.size() / most]);
  return chosen;
}

class Replay {
 public:
  Replay(const dgd_bullet::Record& record, const Options& options)
      : record_(record), options_(options), methods_(MethodsOf(options.contest)), figures_(methods_) {
    for (const dgd_bullet::RecordedShape& shape : record.shapes) sets_.push_back(SetFrom(shape));
  }

  const ContestMethods& methods() const { return methods_; }

  /// One sample a method.
  std::vector<MethodSample> Ask(const Turn& turn) {
    const dgd_bullet::RecordedPair &now = record_.pairs[turn.index], &last = record_.pairs[turn.last_index];
    const auto [place, is_new] =
        pairs_.try_emplace({now.shape_1, now.shape_2}, sets_[now.shape_1], sets_[now.shape_2], methods_);
    ContestPair& pair = place->second;
    pair.MoveTo({PoseFrom(last.pose_1), PoseFrom(last.pose_2), PoseFrom(now.pose_1), PoseFrom(now.pose_2)});
    std::vector<MethodSample> samples = pair.Measure(options_.contest.rounds, options_.contest.repeats);
    figures_.Take(pair, samples, static_cast<std::int64_t>(turn.index));
    return samples;
  }

  std::vector<MethodSummary> Summarize() const { return figures_.Summarize(); }

  /// All numbers of one pair.
  std::string Dump(std::size_t index) const {
    const dgd_bullet::RecordedPair& pair = record_.pairs[index];
    return dgd_test::Dump({sets_[pair.shape_1], sets_[pair.shape_2], PoseFrom(pair.pose_1), PoseFrom(pair.pose_2)});
  }

 private:
  const dgd_bullet::Record& record_;
  const Options& options_;
  const ContestMethods methods_;
  std::vector<dgd_test::SetNumbers> sets_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, ContestPair> pairs_;  // By shapes: bodies share them.
  ContestFigures figures_;
};

void PrintOne(const ContestMethods& methods, const std::vector<MethodSample>& samples) {
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const MethodSample& sample = samples[m];
    std::printf("%-32s", methods[m]->title.c_str());
    if (std::isnan(sample.microseconds)) {
      std::printf("unsupported\n");
      continue;
    }
    std::printf("%8.3f us", sample.microseconds);
    PrintNumber(", %g iterations", 0, sample.iterations);
    PrintNumber(", gap %.1e", 0, sample.relative_gap);
    PrintNumber(", primal infeasibility %.1e m", 0, sample.primal_infeasibility);
    PrintNumber(", normal off by %.1e m", 0, sample.normal_error);
    PrintNumber(", depth by %.1e m", 0, sample.depth_error);
    PrintNumber(", points outside by %.1e m", 0, sample.witness_error);
    std::printf("%s%s%s\n", sample.is_wrong ? ", wrong" : "", sample.is_missing ? ", no answer" : "",
                sample.is_failure ? ", not converged" : "");
  }
}

ReplayStatus Run(const Options& options) {
  const dgd_bullet::Record record = dgd_bullet::ReadRecord(options.record);
  if (record.problem) std::fprintf(stderr, "%s\n", record.problem->c_str());
  std::vector<Turn> turns = TurnsOf(record);
  std::printf("%s: %zu shapes, %zu pairs (%zu of them not for the first time), recorded with Bullet in %s\n",
              options.record.c_str(), record.shapes.size(), record.pairs.size(), turns.size(),
              record.real_bytes == sizeof(double) ? "double" : "float");
  if (record.left_out > 0) {
    std::printf("%llu pairs were left out of the record\n", static_cast<unsigned long long>(record.left_out));
  }
  Replay replay(record, options);
  if (options.pair) {
    const auto index = static_cast<std::size_t>(*options.pair);
    if (index >= record.pairs.size()) {
      std::fprintf(stderr, "--pair %zu: the record has %zu pairs\n", index, record.pairs.size());
      return kBadInput;
    }
    const auto found = std::ranges::find(turns, index, &Turn::index);
    const Turn turn = found != turns.end() ? *found : Turn{index, index};
    const dgd_bullet::RecordedPair& pair = record.pairs[index];
    std::printf("pair %zu, step %llu, bodies' pair %u, last asked about as pair %zu\n%s\n", index,
                static_cast<unsigned long long>(pair.step), pair.body_pair, turn.last_index,
                replay.Dump(index).c_str());
    PrintOne(replay.methods(), replay.Ask(turn));
    return record.problem ? kDamagedRecord : kReplayed;
  }

  turns = SpreadOver(turns, static_cast<std::size_t>(options.pairs));
  std::printf("%zu pairs, Bullet linked in %s; times in us, errors in m\n", turns.size(), BulletPrecision());
  {
    dgd_demos::ProgressBar progress("replaying", 1);
    for (std::size_t i = 0; i < turns.size(); ++i) {
      replay.Ask(turns[i]);
      progress.Update(double(i + 1) / double(turns.size()));
    }
  }
  const std::vector<MethodSummary> summaries = replay.Summarize();
  PrintContest(replay.methods(), summaries);
  if (!options.contest.csv.empty()) {
    FiguresCsv csv(options.contest.csv);
    WriteContest(csv, options.record.stem().string(), replay.methods(), summaries);
  }
  if (record.problem) return kDamagedRecord;
  return HaveOursFailed(replay.methods(), summaries) ? kOursFailed : kReplayed;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
