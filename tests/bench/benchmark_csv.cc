#include "bench/benchmark_csv.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "bench/peers/bullet_peers.h"

namespace dgd_bench {
namespace {

// A figure and the comma before it; empty if there is none.
void Append(std::ostream& stream, double figure) {
  stream << ',';
  if (!std::isnan(figure)) stream << figure;
}

}  // namespace

BenchmarkCsv::BenchmarkCsv(const std::filesystem::path& file, const BenchOptions& options)
    : file_(file), stream_(file) {
  CheckWritten();
  stream_.precision(std::numeric_limits<double>::max_digits10);
  stream_ << "# seed: " << options.seed << "\n# Bullet: " << BulletPrecision()
          << "\n# build type: " << DGD_BENCH_BUILD_TYPE << "\n# repeats: " << options.effort.repeats
          << "\n# rounds: " << options.effort.rounds << "\n# distance of: " << NameOf(options.distance_of) << '\n'
          << "margin_m,class,pair,signed_distance_m,method,time_us,is_missing,is_failure,normal_error_m,iterations,"
             "relative_gap,primal_infeasibility_m"
          << std::endl;
  CheckWritten();
}

void BenchmarkCsv::Write(const Block& block) {
  for (std::size_t pair = 0; pair < block.rows.size(); ++pair) {
    const PairRow& row = block.rows[pair];
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
      const auto& [microseconds, judgement] = row.samples[m];
      stream_ << block.margin << ',' << block.distance_class->key << ',' << pair << ',' << row.signed_distance << ','
              << kMethods[m].key << ',' << microseconds << ',' << judgement.is_missing << ',' << judgement.is_failure;
      Append(stream_, judgement.normal_error);
      Append(stream_, judgement.iterations);
      Append(stream_, judgement.relative_gap);
      Append(stream_, judgement.primal_infeasibility);
      stream_ << '\n';
    }
  }
  stream_.flush();
  CheckWritten();
}

void BenchmarkCsv::CheckWritten() const {
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace dgd_bench
