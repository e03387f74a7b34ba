// How errors are summed up, judged and printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "physics/comparison.h"

namespace dgd_physics {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Sample Of(double measured, std::string group = {}) {
  return {"", measured, /*theory=*/2, /*scale=*/4, std::move(group)};
}

TEST(RelativeError, IsRelativeToTheScaleAndAtMostOne) {
  EXPECT_DOUBLE_EQ(RelativeError(Of(3)), 0.25);
  EXPECT_DOUBLE_EQ(RelativeError(Of(1)), 0.25);
  EXPECT_DOUBLE_EQ(RelativeError(Of(2)), 0);
  for (const double lost : {100.0, kInfinity, -kInfinity, kNan}) EXPECT_EQ(RelativeError(Of(lost)), 1) << lost;
}

TEST(RelativeError, OfNegativeTheory_IsRelativeToItsAbsoluteValue) {
  EXPECT_DOUBLE_EQ(RelativeError(RelativeToTheory("", -3, -4)), 0.25);
}

TEST(RmsError, IsRootOfMeanSquare) {
  EXPECT_DOUBLE_EQ(RmsError({Of(2), Of(5)}), std::sqrt(0.75 * 0.75 / 2));
  EXPECT_DOUBLE_EQ(RmsError({Of(kNan)}), 1);
  EXPECT_DOUBLE_EQ(RmsError({}), 1);  // What measures nothing does not pass.
}

Experiment Plain() { return {"plain", "", nullptr, false}; }
Experiment Rebound() { return {"rebound", "", nullptr, true}; }

TEST(ErrorBound, IsATenthAboveTheBuiltin) {
  for (const double rate : {60.0, 240.0, 1000.0}) EXPECT_NEAR(ErrorBound(Plain(), rate, 0.5), 0.553, 1e-12);
}

TEST(ErrorBound, OfRebounds_IsAlsoAbsolute) {
  EXPECT_DOUBLE_EQ(ErrorBound(Rebound(), 60, 0.5), 0.02);
  EXPECT_DOUBLE_EQ(ErrorBound(Rebound(), 240, 0.5), 0.01);
  EXPECT_DOUBLE_EQ(ErrorBound(Rebound(), 1000, 0.5), 0.005);
  EXPECT_DOUBLE_EQ(ErrorBound(Rebound(), 60, 0), 0.003);
}

class WithTwoGroups : public testing::Test {
 protected:
  // Ours is as good on average, but not with boxes.
  const Experiment experiment_ = Plain();
  const Comparison all_ = {&experiment_, 60, "", {Of(2, "boxes"), Of(6, "hulls")}, {Of(6, "boxes"), Of(2, "hulls")}};
};

TEST_F(WithTwoGroups, EachIsJudgedByItself) {
  const std::vector<Comparison> judged = WithGroups(all_);
  ASSERT_EQ(judged.size(), 3U);
  EXPECT_TRUE(judged[0].Passes());
  EXPECT_EQ(judged[1].group, "boxes");
  EXPECT_FALSE(judged[1].Passes());
  EXPECT_EQ(judged[2].group, "hulls");
  EXPECT_TRUE(judged[2].Passes());
}

TEST_F(WithTwoGroups, FailuresAreListedByName) {
  EXPECT_EQ(FormatFailures(WithGroups(all_)), "fails: plain (boxes) at 60 Hz: 1, bound 0.003\n");
  EXPECT_EQ(FormatFailures({all_}), "");
}

TEST_F(WithTwoGroups, CsvHasALinePerCase) {
  const std::string csv = FormatCsv({all_}, "double");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_NE(csv.find("double,plain,60,\"\",2,6,2,4,0,1\n"), std::string::npos) << csv;
}

TEST(SelectIndices, OfAQuickRun_AreEveryStrideth) {
  EXPECT_EQ(SelectIndices({Narrowphase::kOurs, 60, true}, 8, 3), (std::vector{0, 3, 6}));
  EXPECT_EQ(SelectIndices({Narrowphase::kOurs, 60, false}, 3, 3), (std::vector{0, 1, 2}));
}

TEST(Experiments, HaveNamesOfTheirOwn) {
  for (const Experiment& experiment : Experiments()) {
    const auto is_it = [&experiment](const Experiment& other) { return other.name == experiment.name; };
    EXPECT_EQ(std::count_if(Experiments().begin(), Experiments().end(), is_it), 1) << experiment.name;
    EXPECT_FALSE(experiment.summary.empty()) << experiment.name;
  }
}

}  // namespace
}  // namespace dgd_physics
