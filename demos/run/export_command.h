// `headless_sim export`: a scene as a world file, for other programs that read Bullet's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <variant>

#include "exit_status.h"

namespace dgd_demos {

struct ExportOptions {
  std::filesystem::path scene, file;
  std::uint64_t seed = 1;
};

std::variant<ExportOptions, ExitStatus> ParseExportOptions(int argc, const char* const* argv);

/// @throws SceneError about the scene; std::runtime_error if the file cannot be written.
ExitStatus Export(const ExportOptions& options);

}  // namespace dgd_demos
