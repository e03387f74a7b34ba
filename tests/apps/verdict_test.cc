// How figures are made up of cases, and judged.
#include "apps/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgd_apps {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const App kApp = {"app",
                  "for tests",
                  {{"mean", Combine::kMean, 0.1, 0.5, "as it is"}, {"worst", Combine::kWorst, 0, 0, "as it is"}},
                  nullptr};

Verdict VerdictOf(double builtin, double ours) { return {&kApp, &kApp.figures.front(), "", 60, builtin, ours}; }

TEST(CombineValues, MeanWorstAndTotal_AreOfTheFiguresOwnValues) {
  const Cases cases = {{"", "a", {1, 7}}, {"", "b", {3, 9}}};
  EXPECT_EQ(CombineValues({.name = "", .combine = Combine::kMean, .reason = ""}, cases, 0), 2);
  EXPECT_EQ(CombineValues({.name = "", .combine = Combine::kTotal, .reason = ""}, cases, 0), 4);
  EXPECT_EQ(CombineValues({.name = "", .combine = Combine::kWorst, .reason = ""}, cases, 1), 9);
}

// An app that breaks down must not pass by a comparison that is false for NaN.
TEST(CombineValues, ValueThatIsNotFinite_IsWorseThanAny) {
  for (const Combine combine : {Combine::kMean, Combine::kWorst, Combine::kTotal}) {
    const Figure figure = {.name = "", .combine = combine, .reason = ""};
    EXPECT_TRUE(std::isinf(CombineValues(figure, {{"", "a", {1}}, {"", "b", {kNan}}}, 0)));
  }
  EXPECT_FALSE(VerdictOf(INFINITY, INFINITY).Passes());
  EXPECT_TRUE(VerdictOf(INFINITY, 1).Passes());
}

TEST(Verdict, Bound_IsTheBuiltinsWithBandAndFloor) {
  EXPECT_TRUE(VerdictOf(10, 11.49).Passes());
  EXPECT_FALSE(VerdictOf(10, 11.51).Passes());
  EXPECT_TRUE(VerdictOf(0, 0.5).Passes());
  EXPECT_FALSE(VerdictOf(0, 0.51).Passes());
}

// What the built-in loses in one group excuses no loss of ours in another.
TEST(Judge, Groups_AreJudgedByThemselves) {
  const Runs runs = {
      &kApp, 60, {{"mesh", "a", {9, 9}}, {"plane", "b", {0, 0}}}, {{"mesh", "a", {0, 0}}, {"plane", "b", {8, 8}}}};
  const std::vector<Verdict> verdicts = Judge(runs);
  ASSERT_EQ(verdicts.size(), 6U);
  EXPECT_TRUE(std::ranges::all_of(verdicts, [](const Verdict& it) { return it.Passes() == (it.group != "plane"); }));
  const std::string failures = FormatFailures(verdicts);
  EXPECT_EQ(failures,
            "fails: app: mean (plane) at 60 Hz: built-in 0, ours 8, bound 0.5\n"
            "fails: app: worst (plane) at 60 Hz: built-in 0, ours 8, bound 0\n");
}

TEST(Judge, OneGroup_IsNotJudgedTwice) {
  const Runs runs = {&kApp, 60, {{"mesh", "a", {1, 1}}}, {{"mesh", "a", {1, 1}}}};
  EXPECT_EQ(Judge(runs).size(), 2U);
}

}  // namespace
}  // namespace dgd_apps
