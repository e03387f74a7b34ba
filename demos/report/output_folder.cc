#include "report/output_folder.h"

#include <stdexcept>
#include <system_error>

namespace dgd_demos {

void MakeOutputFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": the folder cannot be made: " + error.message());
}

}  // namespace dgd_demos
