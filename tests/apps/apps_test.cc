// Every app, some cases of each: ours against the built-in in the same run.
#include "apps/apps.h"

#include <LinearMath/btScalar.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "apps/verdict.h"

namespace dgd_apps {

/// For GoogleTest's messages.
static void PrintTo(const App& app, std::ostream* stream) { *stream << app.name; }

namespace {

enum class Precision { kFloat, kDouble, kEither };
constexpr Precision kPrecision = sizeof(btScalar) == sizeof(float) ? Precision::kFloat : Precision::kDouble;

constexpr std::array<double, 3> kRates = {60, 240, 1000};  // Hz

/// What ours is known to be worse at than its bound. README.md says why.
struct KnownLoss {
  std::string_view app, figure, group;
  Precision precision;
  /// Of ours, at each rate, with a little room: a loss does not get worse unseen. 0 where none is known.
  std::array<double, kRates.size()> most;

  double MostFor(const Verdict& it) const {
    const bool is_it = app == it.app->name && figure == it.figure->name && group == it.group &&
                       (precision == kPrecision || precision == Precision::kEither);
    const auto rate = std::ranges::find(kRates, it.rate);
    return is_it ? most[static_cast<std::size_t>(rate - kRates.begin())] : 0;
  }
};
constexpr std::array<KnownLoss, 10> kKnownLosses = {{
    {"gripper", "dropped parts", "box", Precision::kEither, {0, 0, 2}},
    {"gripper", "slip in 0.8 s, mm", "box", Precision::kEither, {0, 0, 3.9}},
    // Hexagonal prisms between flat jaws.
    {"jaws", "dropped parts", "hull", Precision::kDouble, {7, 3, 3}},
    {"jaws", "slip in 2 s, mm", "hull", Precision::kDouble, {0, 9.5, 6.4}},
    {"jaws", "slip in 2 s, mm", "hull", Precision::kFloat, {0, 0, 5.6}},
    // One wedge of sixteen still rocks; in double none does.
    {"fracture", "speed at rest, mm/s", "in flight", Precision::kFloat, {22, 0, 0}},
    {"tips", "tips too early", "box", Precision::kDouble, {5.1, 0, 0}},
    // A slender box, 5 x 15 cm, pushed at 0.97 of what tips it: its corners land late, and it rocks.
    {"tips", "tips too early", "box", Precision::kFloat, {0, 1.1, 0}},
    {"tips", "tilt of those that stand, mrad", "box", Precision::kFloat, {0, 2.8, 0}},
    {"chain", "heavy on light: sunk, mm", "heavy on hulls", Precision::kDouble, {6.5, 0, 0}},
}};

class AppTest : public testing::TestWithParam<App> {
 protected:
  static void ExpectNotWorse(double rate) {
    const Runs runs = RunBoth(GetParam(), rate, /*is_quick=*/true);
    ASSERT_FALSE(runs.ours.empty());
    ASSERT_EQ(runs.ours.size(), runs.builtin.size());
    const std::vector<Verdict> verdicts = Judge(runs);
    const bool has_groups = !verdicts.back().group.empty();
    bool is_as_known = true;
    for (const Verdict& verdict : verdicts) {
      // Where each group passes, all cases do.
      if (has_groups && verdict.group.empty()) continue;
      is_as_known = ExpectAsKnown(verdict) && is_as_known;
    }
    EXPECT_TRUE(is_as_known) << FormatCases(runs);
  }

 private:
  static bool ExpectAsKnown(const Verdict& verdict) {
    double known = 0;
    for (const KnownLoss& it : kKnownLosses) known = std::max(known, it.MostFor(verdict));
    if (known == 0) {
      EXPECT_TRUE(verdict.Passes()) << FormatFailures({verdict});
      return verdict.Passes();
    }
    const bool is_as_known = verdict.Passes() || verdict.ours <= known;
    EXPECT_TRUE(is_as_known) << FormatFailures({verdict});
    return is_as_known;
  }
};

INSTANTIATE_TEST_SUITE_P(Apps, AppTest, testing::ValuesIn(Apps()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(AppTest, At60Hz_IsNotWorseThanTheBuiltin) { ExpectNotWorse(kRates[0]); }
TEST_P(AppTest, At240Hz_IsNotWorseThanTheBuiltin) { ExpectNotWorse(kRates[1]); }
TEST_P(AppTest, At1000Hz_IsNotWorseThanTheBuiltin) { ExpectNotWorse(kRates[2]); }

// A loss whose app or figure has another name by now would never be looked for.
TEST(KnownLosses, NameAppsAndFiguresThatAre) {
  for (const KnownLoss& known : kKnownLosses) {
    const auto app = std::ranges::find(Apps(), known.app, &App::name);
    ASSERT_NE(app, Apps().end()) << known.app;
    EXPECT_EQ(std::ranges::count(app->figures, known.figure, &Figure::name), 1) << known.figure;
  }
}

// Chance has no part in it: a run can be repeated.
TEST(App, SameConditions_SameFiguresToTheBit) {
  for (const App& app : {Ricochet(), Gripper(), Fracture()}) {
    const Conditions conditions = {Narrowphase::kOurs, 240, true};
    const Cases first = app.run(conditions), second = app.run(conditions);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].values, second[i].values) << first[i].name;
  }
}

// Each is judged by something, and says why it is judged so.
TEST(App, Figures_HaveBandsWithAReason) {
  for (const App& app : Apps()) {
    EXPECT_FALSE(app.figures.empty()) << app.name;
    for (const Figure& figure : app.figures) {
      EXPECT_FALSE(figure.reason.empty()) << app.name << ": " << figure.name;
      EXPECT_GE(figure.band, 0);
      EXPECT_LE(figure.band, 0.3) << app.name << ": " << figure.name;
      EXPECT_GE(figure.floor, 0);
    }
  }
}

}  // namespace
}  // namespace dgd_apps
