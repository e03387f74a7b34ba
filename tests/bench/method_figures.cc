#include "bench/method_figures.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "bench/percentile.h"

namespace dgd_bench {
namespace {

constexpr std::array<double MethodSample::*, kErrorNames.size()> kErrorMembers = {
    &MethodSample::relative_gap, &MethodSample::primal_infeasibility, &MethodSample::dual_infeasibility,
    &MethodSample::exact_error,  &MethodSample::normal_error,         &MethodSample::depth_error,
    &MethodSample::witness_error};

double Mean(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

}  // namespace

void MethodFigures::Take(const MethodSample& sample, std::int64_t pair) {
  samples_.push_back(sample);
  pairs_.push_back(pair);
}

MethodSummary MethodFigures::Summarize() const {
  MethodSummary summary;
  summary.pairs = samples_.size();
  // Those that have it, in ascending order.
  const auto sorted = [this](double MethodSample::*member) {
    std::vector<double> numbers;
    for (const MethodSample& sample : samples_) {
      if (!std::isnan(sample.*member)) numbers.push_back(sample.*member);
    }
    std::ranges::sort(numbers);
    return numbers;
  };
  const std::vector<double> times = sorted(&MethodSample::microseconds);
  summary.p0001 = Percentile(times, 1e-4);
  summary.p25 = Percentile(times, 0.25);
  summary.p50 = Percentile(times, 0.5);
  summary.p75 = Percentile(times, 0.75);
  summary.p99 = Percentile(times, 0.99);
  summary.p9999 = Percentile(times, 0.9999);
  summary.mean = Mean(times);
  summary.iterations = Mean(sorted(&MethodSample::iterations));
  for (std::size_t e = 0; e < kErrorMembers.size(); ++e) {
    const std::vector<double> numbers = sorted(kErrorMembers[e]);
    if (numbers.empty()) continue;
    const auto worst = std::ranges::find(samples_, numbers.back(), kErrorMembers[e]);
    summary.errors[e] = {Percentile(numbers, 0.5), Percentile(numbers, 0.99), numbers.back(),
                         pairs_[static_cast<std::size_t>(worst - samples_.begin())]};
  }
  summary.wrong = std::ranges::count(samples_, true, &MethodSample::is_wrong);
  summary.missing = std::ranges::count(samples_, true, &MethodSample::is_missing);
  summary.failures = std::ranges::count(samples_, true, &MethodSample::is_failure);
  return summary;
}

FiguresCsv::FiguresCsv(const std::filesystem::path& file) : file_(file), stream_(file) {
  stream_.precision(std::numeric_limits<double>::max_digits10);
  stream_ << "work,method,title,start,tolerance,vertices,pairs,p0.01_us,p25_us,p50_us,p75_us,p99_us,p99.99_us,mean_us,"
             "iterations";
  for (const char* name : kErrorNames) {
    stream_ << ',' << name << "_p50," << name << "_p99," << name << "_max," << name << "_worst_pair";
  }
  stream_ << ",wrong,missing,failures" << std::endl;
  CheckWritten();
}

void FiguresCsv::Write(const MethodLabel& label, const MethodSummary& summary) {
  const auto append = [this](double number) {
    stream_ << ',';
    if (!std::isnan(number)) stream_ << number;
  };
  stream_ << label.work << ',' << label.method << ",\"" << label.title << "\"," << (label.is_warm ? "warm" : "cold")
          << ',' << label.tolerance << ',' << label.vertices << ',' << summary.pairs;
  for (const double time : {summary.p0001, summary.p25, summary.p50, summary.p75, summary.p99, summary.p9999,
                            summary.mean, summary.iterations}) {
    append(time);
  }
  for (const ErrorFigure& error : summary.errors) {
    append(error.p50);
    append(error.p99);
    append(error.most);
    stream_ << ',';
    if (error.worst_pair >= 0) stream_ << error.worst_pair;
  }
  stream_ << ',' << summary.wrong << ',' << summary.missing << ',' << summary.failures << std::endl;
  CheckWritten();
}

void FiguresCsv::CheckWritten() const {
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace dgd_bench
