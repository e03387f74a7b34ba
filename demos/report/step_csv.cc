#include "report/step_csv.h"

namespace dgd_demos {

StepCsv::StepCsv(const std::filesystem::path& file, const RunInfo& info, OpenMode mode) : csv_(file, mode) {
  if (mode == OpenMode::kContinue) return;
  csv_ << "# scene: " << info.scene << "\n# seed: " << info.seed << "\n# narrowphase: " << info.narrowphase
       << "\n# precision: " << info.precision << "\n# build type: " << info.build_type
       << "\n# Energies are those at time_s, the end of the step. The collision columns are those of the step's "
          "collision detection, at the poses in which the step began; pairs are overlapping bounding boxes, queries "
          "those of them in which a body is awake. deepest_true_penetration_m is empty where it was not computed.\n"
       << "time_s,kinetic_energy_j,potential_energy_j,contacts,deepest_reported_penetration_m,narrowphase_us,pairs,"
          "queries,fallbacks,deepest_true_penetration_m\n";
  csv_.Flush();
}

void StepCsv::Write(const StepRecord& step) {
  const CollisionReport& collision = step.collision;
  csv_ << step.time << ',' << step.energy.kinetic << ',' << step.energy.potential << ',' << collision.contacts << ','
       << collision.deepest_penetration << ',' << collision.narrowphase_us << ',' << collision.pairs << ','
       << collision.queries << ',' << collision.fallbacks << ',';
  if (step.true_penetration) csv_ << *step.true_penetration;
  csv_ << '\n';
  if (timer_.IsDue()) csv_.Flush();
}

}  // namespace dgd_demos
