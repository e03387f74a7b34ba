// The raw measurements, for programs.
#pragma once

#include <filesystem>
#include <fstream>

#include "bench/bench_options.h"
#include "bench/measurement.h"

namespace dgd_bench {

/// One row per pair and method; units are in the names of the columns, NaN is an empty field.
class BenchmarkCsv {
 public:
  /// Creates or overwrites the file and writes its head. Throws std::runtime_error if it cannot be written.
  BenchmarkCsv(const std::filesystem::path& file, const BenchOptions& options);

  /// Throws std::runtime_error if that fails, as on a full disk.
  void Write(const Block& block);

 private:
  void CheckWritten() const;

  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace dgd_bench
