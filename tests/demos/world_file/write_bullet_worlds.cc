// Writes the worlds of bullet_worlds.h as files, for headless_sim: write_bullet_worlds DIR
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "report/whole_file.h"
#include "world_file/bullet_worlds.h"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "Usage: write_bullet_worlds DIR\n");
    return 2;
  }
  std::filesystem::create_directories(argv[1]);
  for (const dgd_test::WorldCase& world_case : dgd_test::AllWorldCases()) {
    const std::vector<std::byte> bytes = world_case.make()->Serialize();
    dgd_demos::WriteWholeFile(std::filesystem::path(argv[1]) / (world_case.name + ".bullet"),
                              {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
