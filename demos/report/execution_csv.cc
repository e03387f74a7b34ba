#include "report/execution_csv.h"

#include "report/csv_file.h"

namespace dgd_demos {

void WriteExecutionCsv(const std::filesystem::path& file, const Arm& arm, const std::vector<ExecutionStep>& steps) {
  CsvFile csv(file);
  csv << "time_s,tracking_error_m,flange_x_m,flange_y_m,flange_z_m,contacts";
  for (const Joint& joint : arm.joints) {
    csv << ',' << joint.name << "_planned_rad," << joint.name << "_rad," << joint.name << "_rad_s," << joint.name
        << "_nm";
  }
  csv << '\n';
  for (const ExecutionStep& step : steps) {
    csv << step.time << ',' << step.tracking_error << ',' << step.flange.x() << ',' << step.flange.y() << ','
        << step.flange.z() << ',' << step.contacts;
    for (Eigen::Index i = 0; i < step.angles.size(); ++i) {
      csv << ',' << step.planned[i] << ',' << step.angles[i] << ',' << step.velocities[i] << ',' << step.efforts[i];
    }
    csv << '\n';
  }
  csv.Flush();
}

}  // namespace dgd_demos
