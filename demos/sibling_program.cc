#include "sibling_program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "stop_signals.h"

namespace dgd_demos {

std::string ProgramFor(const std::string& precision) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path program =
      self.parent_path() / (precision == "float" ? "headless_sim" : "headless_sim_float64");
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error(program.string() + ": does not exist, which simulates with Bullet in " + precision);
  }
  return program.string();
}

int RunAndWait(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t process = 0;
  const int error = posix_spawn(&process, program.c_str(), nullptr, nullptr, argv.data(), environ);
  if (error != 0) throw std::runtime_error(program + ": cannot be started: " + std::strerror(error));
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    if (IsStopRequested()) kill(process, SIGTERM);
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace dgd_demos
