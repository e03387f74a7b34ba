// The table at the end: a row a figure with its unit, a column a narrowphase, its spread over several runs, and the
// ratio to the first narrowphase.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figures.h"

namespace dgd_demos {

struct TableColumn {
  std::string narrowphase;
  std::vector<FigureValues> runs;  ///< Runs of one scene, a run a seed, at least one.
};

/// The rows aligned for reading; "-" where a run has no such figure. With several runs, medians are followed by their
/// interquartile range (IQR); each column after the first, by its quotient by the first.
std::string FormatTable(const std::vector<TableColumn>& columns);

/// The same figures for programs: one line a row, numbers that read back to the bit, and the key of each row in place
/// of its title.
/// @throws std::runtime_error if the file cannot be written.
void WriteTableCsv(const std::filesystem::path& file, const std::vector<TableColumn>& columns);

}  // namespace dgd_demos
