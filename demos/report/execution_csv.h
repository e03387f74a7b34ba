// The CSV of an execution: one row a step.
#pragma once

#include <filesystem>
#include <vector>

#include "motion/arm.h"
#include "simulation/execution.h"

namespace dgd_demos {

/// Creates or overwrites the file. Of each step: time, tracking error, flange, pairs in contact; and of each joint, by
/// its name, planned angle, angle, velocity and effort. Numbers read back to the bit.
/// @throws std::runtime_error if the file cannot be written.
void WriteExecutionCsv(const std::filesystem::path& file, const Arm& arm, const std::vector<ExecutionStep>& steps);

}  // namespace dgd_demos
