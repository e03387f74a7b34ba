#include "support/pairs/tally.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <istream>
#include <limits>
#include <ostream>
#include <string>

namespace dgd_test {
namespace {

constexpr std::int64_t Tally::*kCounts[] = {&Tally::pairs,        &Tally::queries,       &Tally::non_optimal,
                                            &Tally::non_monotone, &Tally::disagreements, &Tally::failed_pairs};
constexpr Worst Tally::*kWorsts[] = {&Tally::relative_gap, &Tally::primal_infeasibility, &Tally::dual_infeasibility,
                                     &Tally::separation_error, &Tally::growth_distance_error};

}  // namespace

void Worst::Take(double new_figure, std::int64_t new_index) {
  if (std::isnan(new_figure)) new_figure = std::numeric_limits<double>::infinity();
  const bool is_worse = new_figure > figure || (new_figure == figure && new_index < index);
  if (index >= 0 && !is_worse) return;
  figure = new_figure;
  index = new_index;
}

void Tally::CountIterations(int count) {
  ++queries;
  ++iterations[std::min(static_cast<std::size_t>(std::max(count, 0)), kMostIterations)];
}

void Tally::Merge(const Tally& other) {
  for (const auto count : kCounts) this->*count += other.*count;
  for (const auto worst : kWorsts) {
    if ((other.*worst).index >= 0) (this->*worst).Take((other.*worst).figure, (other.*worst).index);
  }
  for (std::size_t i = 0; i <= kMostIterations; ++i) iterations[i] += other.iterations[i];
}

double Tally::MeanIterations() const {
  double sum = 0;
  for (std::size_t i = 0; i <= kMostIterations; ++i) sum += static_cast<double>(i) * static_cast<double>(iterations[i]);
  return sum / static_cast<double>(queries);
}

int Tally::IterationPercentile(double share) const {
  const double rank = std::ceil(share * static_cast<double>(queries));
  std::int64_t seen = 0;
  for (std::size_t i = 0; i <= kMostIterations; ++i) {
    seen += iterations[i];
    if (static_cast<double>(seen) >= rank) return static_cast<int>(i);
  }
  return static_cast<int>(kMostIterations);
}

void Write(std::ostream& out, const Tally& tally) {
  for (const auto count : kCounts) out << tally.*count << ' ';
  for (const auto worst : kWorsts) {
    char exactly[40];
    std::snprintf(exactly, sizeof exactly, "%a", (tally.*worst).figure);
    out << exactly << ' ' << (tally.*worst).index << ' ';
  }
  for (const std::int64_t count : tally.iterations) out << count << ' ';
  out << '\n';
}

void Read(std::istream& in, Tally& tally) {
  for (const auto count : kCounts) in >> tally.*count;
  for (const auto worst : kWorsts) {
    std::string exactly;  // Streams do not read "%a".
    in >> exactly >> (tally.*worst).index;
    (tally.*worst).figure = std::strtod(exactly.c_str(), nullptr);
  }
  for (std::int64_t& count : tally.iterations) in >> count;
}

}  // namespace dgd_test
