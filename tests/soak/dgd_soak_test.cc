// The soak as its users run it: exit statuses, tables, resuming and replaying.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Outcome;

Outcome RunSoak(const std::string& arguments, const std::string& prefix = "") {
  return dgd_test::RunProgram(prefix + DGD_TEST_PROGRAM, arguments);
}

/// From the first table on: without the line that says how many pairs there are.
std::string TablesOf(const std::string& output) {
  const auto begin = output.find("\n\n");
  return begin == std::string::npos ? output : output.substr(begin);
}

std::string FreshFile(const std::string& name) {
  const std::string file = testing::TempDir() + "dgd_soak_test_" + name;
  std::filesystem::remove(file);
  return file;
}

// Some seconds: more of them are for whoever has the time.
TEST(DgdSoak, SomePairsInDouble_NoneFails) {
  const Outcome outcome = RunSoak("--pairs 20000 --scalar double");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("no case failed"), std::string::npos);
}

// The seed is one whose pairs are all solved: in float, a few of a million are not (README).
TEST(DgdSoak, SomePairsInFloat_NoneFails) {
  const Outcome outcome = RunSoak("--pairs 20000 --seed 2 --scalar float");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

TEST(DgdSoak, ManyFrames_AreAskedOfEachPair) {
  const Outcome outcome = RunSoak("--pairs 20 --frames 30 --types box --scalar double");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  std::istringstream row(outcome.output.substr(outcome.output.find("box-box")));
  std::string name;
  int pairs = 0, queries = 0;
  row >> name >> pairs >> queries;
  EXPECT_EQ(pairs, 20) << outcome.output;
  EXPECT_EQ(queries, 20 * 31) << outcome.output;
}

TEST(DgdSoak, ResumedRun_EndsWithTheTablesOfAnUninterruptedOne) {
  const std::string state = FreshFile("resumed");
  const Outcome whole = RunSoak("--pairs 3000 --threads 2");
  RunSoak("--pairs 1111 --threads 1 --state " + state);
  const Outcome resumed = RunSoak("--pairs 3000 --threads 2 --resume " + state);
  EXPECT_EQ(resumed.status, whole.status);
  EXPECT_EQ(TablesOf(resumed.output), TablesOf(whole.output));
}

TEST(DgdSoak, StoppedRun_SavesItsStateAndGoesOn) {
  const std::string state = FreshFile("stopped");
  const std::string options = "--types box,polytope --scalar double --pairs ";
  // Longer than any machine takes for it in the time.
  const Outcome stopped = RunSoak(options + "1000000000 --state " + state, "timeout --signal=TERM 1 ");
  EXPECT_NE(stopped.output.find("ended early"), std::string::npos) << stopped.output;
  ASSERT_TRUE(std::filesystem::exists(state));

  std::ifstream in(state);
  std::string line;
  std::getline(in, line);
  std::getline(in, line);
  long long done = 0;
  in >> done >> done;
  ASSERT_GT(done, 0);
  const std::string pairs = std::to_string(done + 500);
  const Outcome resumed = RunSoak(options + pairs + " --resume " + state);
  EXPECT_EQ(TablesOf(resumed.output), TablesOf(RunSoak(options + pairs).output));
}

TEST(DgdSoak, StateOfOtherOptions_IsRefused) {
  const std::string state = FreshFile("other");
  ASSERT_EQ(RunSoak("--pairs 10 --seed 2 --state " + state).status, 0);
  const Outcome outcome = RunSoak("--pairs 20 --seed 3 --resume " + state);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.output.find("--seed 2"), std::string::npos) << outcome.output;
  std::filesystem::resize_file(state, 200);
  EXPECT_EQ(RunSoak("--pairs 20 --seed 2 --resume " + state).status, 2);
}

TEST(DgdSoak, FilteredTypes_KeepTheirCases) {
  // The replay of an index says the same, whatever types are asked for.
  const Outcome plain = RunSoak("--replay 4711 --scalar double");
  const Outcome filtered = RunSoak("--replay 4711 --scalar double --types box,cone");
  EXPECT_EQ(plain.output, filtered.output);
  for (const char* part : {"case 4711", "set 1: ", "set 2: ", "rotation, by rows", "frame 0, cold", "frame 5, warm",
                           "certificate: relative gap", "yes/no: "}) {
    EXPECT_NE(plain.output.find(part), std::string::npos) << part << '\n' << plain.output;
  }
}

TEST(DgdSoak, TooSmallATolerance_FailsAndSaysHowToReplay) {
  // Below the rounding of any curved pair's bounds.
  const std::string options = "--scalar double --types cylinder,cone --tolerance 1e-18";
  const Outcome outcome = RunSoak(options + " --pairs 300");
  EXPECT_EQ(outcome.status, 1);
  const std::string replay = " --replay ";
  const auto at = outcome.output.find("--tolerance 1.0000000000000001e-18" + replay);
  ASSERT_NE(at, std::string::npos) << outcome.output;
  const auto number = outcome.output.find(replay, at) + replay.size();
  const std::string index = outcome.output.substr(number, outcome.output.find('\n', number) - number);
  const Outcome replayed = RunSoak(options + replay + index);
  EXPECT_EQ(replayed.status, 1);
  EXPECT_NE(replayed.output.find("complaints"), std::string::npos) << replayed.output;

  const Outcome shrunk = RunSoak(options + replay + index + " --shrink");
  EXPECT_EQ(shrunk.status, 1);
  const auto simplest = shrunk.output.find("double, the simplest that fails alike");
  ASSERT_NE(simplest, std::string::npos) << shrunk.output;
  EXPECT_NE(shrunk.output.find("complaints", simplest), std::string::npos) << shrunk.output;
  EXPECT_LT(shrunk.output.size() - simplest, simplest) << "nothing was left out\n" << shrunk.output;
}

TEST(DgdSoak, Csv_HoldsALineForEachPairOfTypesAndScalar) {
  const std::string csv = FreshFile("csv");
  ASSERT_EQ(RunSoak("--pairs 60 --types point,box,cone --csv " + csv).status, 0);
  std::ifstream in(csv);
  int lines = 0;
  for (std::string line; std::getline(in, line);) ++lines;
  EXPECT_EQ(lines, 3 + 2 * 6);
}

TEST(DgdSoak, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments :
       {"--pairs 0", "--frames 0", "--seed -1", "--types boxes", "--scalar half", "--mode hot", "--threads 0",
        "--tolerance 2", "--replay -1", "--shrink", "--resume /no/such/file", "--pairs 1 --state /no/such/folder/state",
        "--pairs 1 --csv /no/such/folder/csv", "--resume /dev/null"}) {
    const Outcome outcome = RunSoak(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.output;
    EXPECT_FALSE(outcome.output.empty()) << arguments;
  }
  EXPECT_EQ(RunSoak("--help").status, 0);
}

}  // namespace
