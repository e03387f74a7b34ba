// What one method came to on many pairs: times and errors, for tables, files and plots.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace dgd_bench {

/// One method on one pair. NaN where it has no such figure.
struct MethodSample {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double microseconds = kNone;
  double iterations = kNone;            ///< Evaluations of the support functions, or steps of another kind.
  double relative_gap = kNone;          ///< Of growth distances, as the next two: dgd/certificate.h.
  double primal_infeasibility = kNone;  ///< Metres.
  double dual_infeasibility = kNone;
  double exact_error = kNone;   ///< Of growth distances, relative: bench/exact_growth_distance.h.
  double normal_error = kNone;  ///< Of signed distances, as the next two: bench/referee.h. Metres.
  double depth_error = kNone;
  double witness_error = kNone;
  bool is_wrong = false;    ///< Yes or no.
  bool is_missing = false;  ///< No answer where there is one.
  bool is_failure = false;  ///< The method says itself that it has not converged.
};

/// An error over all pairs.
struct ErrorFigure {
  double p50 = MethodSample::kNone, p99 = MethodSample::kNone, most = MethodSample::kNone;
  std::int64_t worst_pair = -1;  ///< Index of the pair with the most; -1 for none.
};

/// The errors of MethodSample, in the order of its members.
enum class ErrorKind : std::uint8_t { kGap, kPrimal, kDual, kExact, kNormal, kDepth, kWitness };
inline constexpr std::array<const char*, 7> kErrorNames = {
    "relative_gap",   "primal_infeasibility_m", "dual_infeasibility", "exact_error",
    "normal_error_m", "depth_error_m",          "witness_error_m"};

struct MethodSummary {
  std::size_t pairs = 0;  ///< 0: the method takes none of them.
  /// Nearest rank, us.
  double p0001 = MethodSample::kNone, p25 = p0001, p50 = p0001, p75 = p0001, p99 = p0001, p9999 = p0001, mean = p0001;
  double iterations = p0001;  ///< Mean.
  std::array<ErrorFigure, kErrorNames.size()> errors;
  std::int64_t wrong = 0, missing = 0, failures = 0;  ///< Pairs.

  const ErrorFigure& Of(ErrorKind kind) const { return errors[static_cast<std::size_t>(kind)]; }
};

class MethodFigures {
 public:
  /// @param pair  Its index, to be found again.
  void Take(const MethodSample& sample, std::int64_t pair);

  MethodSummary Summarize() const;

 private:
  std::vector<MethodSample> samples_;
  std::vector<std::int64_t> pairs_;
};

/// A method in a file or a table.
struct MethodLabel {
  std::string work;    ///< Which pairs.
  std::string method;  ///< A short name.
  std::string title;   ///< In words.
  bool is_warm = false;
  double tolerance = 0;  ///< Of the relative gap; 0 for the method's own.
  int vertices = 0;      ///< Of each set, where the work differs in nothing else; 0 for the others.
};

/// One row a method and work; units are in the columns' names, NaN is an empty field.
class FiguresCsv {
 public:
  /// Creates or overwrites the file. Throws std::runtime_error naming it if it cannot be written, as Write() does.
  explicit FiguresCsv(const std::filesystem::path& file);

  void Write(const MethodLabel& label, const MethodSummary& summary);

 private:
  void CheckWritten() const;

  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace dgd_bench
