// Every class of experiments, some cases of each: ours against theory, within what the built-in leaves in the same run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <string_view>

#include "physics/comparison.h"

namespace dgd_physics {

/// For GoogleTest's messages.
static void PrintTo(const Experiment& experiment, std::ostream* stream) { *stream << experiment.name; }

namespace {

/// Errors above the bound that are known, with a little room: README.md says where they come from.
struct KnownError {
  std::string_view name;
  double rate;   // Hz
  double error;  // At most.
};
constexpr std::array<KnownError, 9> kKnownErrors = {{{"disc_circle", 60, 0.6},
                                                     {"poles", 60, 0.5},
                                                     {"poles", 240, 0.25},
                                                     {"poles", 1000, 0.06},
                                                     {"angular_momentum", 60, 0.035},
                                                     {"angular_momentum", 240, 0.035},
                                                     {"angular_momentum", 1000, 0.035},
                                                     {"rebound_settings", 240, 0.075},
                                                     {"rebound_settings", 1000, 0.25}}};

double BoundOf(const Comparison& comparison) {
  double bound = comparison.Bound();
  for (const KnownError& known : kKnownErrors) {
    if (known.name == comparison.experiment->name && known.rate == comparison.rate)
      bound = std::max(bound, known.error);
  }
  return bound;
}

class ExperimentTest : public testing::TestWithParam<Experiment> {
 protected:
  static void ExpectWithinBound(double rate) {
    const Comparison comparison = Compare(GetParam(), {.rate = rate, .is_quick = true});
    ExpectAtMost(BoundOf(comparison), comparison);
  }

  /// A compound of one child behaves as the child, where the built-in's do not, too.
  static void ExpectAsTheChild(double rate) {
    Conditions conditions = {.narrowphase = Narrowphase::kOurs, .rate = rate, .is_quick = true};
    const Samples of_child = GetParam().measure(conditions);
    conditions.in_compounds = true;
    const Comparison comparison = Compare(GetParam(), conditions);
    ExpectAtMost(std::max(BoundOf(comparison), ErrorBound(GetParam(), rate, RmsError(of_child))), comparison);
  }

 private:
  static void ExpectAtMost(double bound, const Comparison& comparison) {
    ASSERT_FALSE(comparison.ours.empty());
    ASSERT_EQ(comparison.ours.size(), comparison.builtin.size());
    EXPECT_LE(comparison.OurError(), bound)
        << "root mean square error; the built-in's: " << comparison.BuiltinError() << '\n'
        << FormatCases(comparison);
  }
};

INSTANTIATE_TEST_SUITE_P(Physics, ExperimentTest, testing::ValuesIn(Experiments()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ExperimentTest, At60Hz_ErrorIsWithinBound) { ExpectWithinBound(60); }
TEST_P(ExperimentTest, At240Hz_ErrorIsWithinBound) { ExpectWithinBound(240); }
TEST_P(ExperimentTest, At1000Hz_ErrorIsWithinBound) { ExpectWithinBound(1000); }

TEST_P(ExperimentTest, InCompoundsAt60Hz_ErrorIsTheChilds) { ExpectAsTheChild(60); }
TEST_P(ExperimentTest, InCompoundsAt240Hz_ErrorIsTheChilds) { ExpectAsTheChild(240); }

// Chance has no part in it: a run can be repeated.
TEST(Experiment, SameConditions_SameSamplesToTheBit) {
  for (const Experiment& experiment : Experiments()) {
    if (experiment.name != "head_on" && experiment.name != "gas" && experiment.name != "taps") continue;
    const Conditions conditions = {Narrowphase::kOurs, 240, true};
    const Samples first = experiment.measure(conditions), second = experiment.measure(conditions);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].measured, second[i].measured) << first[i].name;
  }
}

}  // namespace
}  // namespace dgd_physics
