// What an app is: a small world as programs build it, run on one narrowphase at one rate, and what the program sees of
// it in figures of which less is better. Knows no Bullet.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physics/experiment.h"

namespace dgd_apps {

using dgd_physics::Conditions;
using dgd_physics::Narrowphase;

/// What the values of an app's cases make up.
enum class Combine { kMean, kWorst, kTotal };

/// Something that an app sees. Less is better, and 0 is best.
struct Figure {
  std::string_view name;  ///< With its unit.
  Combine combine = Combine::kMean;
  double band = 0;          ///< By how much of the built-in's value ours may be above it.
  double floor = 0;         ///< By how much ours may be above that again, in the figure's unit.
  std::string_view reason;  ///< Why the band and the floor are as they are.
};

/// One run of an app: a value per figure, in the order of the app's figures.
struct Case {
  std::string group;  ///< Cases that are also judged by themselves: what the built-in loses on meshes excuses no plane.
  std::string name;
  std::vector<double> values;
};
using Cases = std::vector<Case>;

struct App {
  std::string_view name;
  std::string_view summary;  ///< One line: what moves, on what.
  std::vector<Figure> figures;
  /// The same cases in the same order for either narrowphase. Chance has no part in it.
  Cases (*run)(const Conditions& conditions);
};

/// Appends.
void AddTo(Cases& cases, Cases more);

/// A case for each setup, or in a quick run for every `stride`-th.
/// @param run  Case(const Conditions&, const Setup&).
template <class Setup, class RunSetup>
Cases RunCases(const Conditions& conditions, const std::vector<Setup>& all, std::size_t stride, const RunSetup& run) {
  Cases cases;
  for (std::size_t i = 0; i < all.size(); i += conditions.is_quick ? stride : 1)
    cases.push_back(run(conditions, all[i]));
  return cases;
}

/// Infinity if a value is not finite: an app that breaks down is worse than any other.
double CombineValues(const Figure& figure, const Cases& cases, std::size_t index);

}  // namespace dgd_apps
