// All methods on the same pair: in turns, each one's answer judged; and what they amount to on many pairs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "bench/growth_pair.h"
#include "bench/method_figures.h"
#include "bench/peers/peer.h"
#include "command_line.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {

struct ContestMethod {
  std::string key;    ///< On the command line and in files.
  std::string title;  ///< In tables.
  std::variant<GrowthQuery, MakePeer> how;
  bool is_warm_peer = false;
  bool answers_apart = true;  ///< Says something of sets that are apart.
  bool may_abort = false;  ///< Whether an assertion of its own may end the process: it is queried in another one first.

  bool IsWarm() const;
  double Tolerance() const;
};

/// The methods of this process: Bullet's are those of the precision that it is linked with.
const std::vector<ContestMethod>& AllContestMethods();

using ContestMethods = std::vector<const ContestMethod*>;

/// What the programs that let methods compete have in common.
struct ContestOptions {
  std::vector<std::string> methods = {};  ///< Empty for all.
  int rounds = 3, repeats = 5;
  std::filesystem::path csv = {};  ///< Empty for none.
};
/// Adds --methods, --rounds, --repeats and --csv, whose defaults `options` holds.
void AddContestOptions(dgd_demos::CommandLine& line, ContestOptions& options);
ContestMethods MethodsOf(const ContestOptions& options);

/// Two shapes, as each method wants them.
class ContestPair {
 public:
  ContestPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2, const ContestMethods& methods);

  void MoveTo(const PairTurn& turn);

  /// One sample a method, in their order; times are left out of those that do not take the pair.
  /// @param rounds   Turns of all methods; the least mean counts.
  /// @param repeats  Queries in a row; their mean counts.
  std::vector<MethodSample> Measure(int rounds, int repeats) const;

  bool Takes(std::size_t method) const;

 private:
  /// Whether a method that may abort does, or never returns.
  bool GivesUp(std::size_t method) const;
  double Time(std::size_t method, int repeats) const;

  const ContestMethods& methods_;
  std::unique_ptr<GrowthPair> growth_;
  std::vector<std::unique_ptr<Peer>> peers_;  // Of each method; null for others, and for shapes that it does not take.
  dgd_test::AnyPair<double, 3> judged_;
};

/// All samples of each method.
class ContestFigures {
 public:
  explicit ContestFigures(const ContestMethods& methods) : figures_(methods.size()) {}

  /// @param index  Of the pair, to be found again.
  void Take(const ContestPair& pair, const std::vector<MethodSample>& samples, std::int64_t index);
  std::vector<MethodSummary> Summarize() const;

 private:
  std::vector<MethodFigures> figures_;
};

/// A table with a row a method, and the ratios of times to Bullet's GJK/EPA.
void PrintContest(const ContestMethods& methods, const std::vector<MethodSummary>& summaries);
void WriteContest(FiguresCsv& csv, const std::string& work, const ContestMethods& methods,
                  const std::vector<MethodSummary>& summaries);
/// Prints a number, or as many blanks for NaN.
void PrintNumber(const char* format, int width, double number);
/// Whether one of ours answered wrongly or not at all.
bool HaveOursFailed(const ContestMethods& methods, const std::vector<MethodSummary>& summaries);

}  // namespace dgd_bench
