#include "sweep/local_workers.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace dgd_demos {
namespace {

constexpr int kCannotBeStarted = 127;  // As shells have it.

// Does not return.
[[noreturn]] void Become(const std::string& program, const std::string& run, int pipe) {
  // A process that is left alone is of no use; and Ctrl-C on a terminal is for the sweep, which then ends this one.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  dup2(pipe, STDOUT_FILENO);
  dup2(pipe, STDERR_FILENO);
  execl(program.c_str(), program.c_str(), "one", run.c_str(), nullptr);
  _exit(kCannotBeStarted);
}

// The last line that says something, and whether it ends with a newline or not.
std::string LastLine(const std::string& text) {
  const std::size_t last = text.find_last_not_of(" \n\r\t");
  if (last == std::string::npos) return "";
  const std::size_t newline = text.rfind('\n', last);
  const std::size_t first = newline == std::string::npos ? 0 : newline + 1;
  return text.substr(first, last + 1 - first);
}

RunRecord Failure(int run, const std::string& message) { return {run, RunRecord::Status::kFailed, message, "", {}}; }

// What a child that has ended leaves: its record, or why there is none.
RunRecord RecordOf(int run, int status, const std::string& output) {
  const std::string last = LastLine(output);
  const std::string remark = last.empty() ? "" : "; the last that it said: " + last;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return Failure(run, "ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")" + remark);
  }
  if (WEXITSTATUS(status) == kCannotBeStarted && last.empty()) return Failure(run, "its program cannot be started");
  try {
    return ParseRunRecord(last);
  } catch (const std::runtime_error&) {
    return Failure(run, "ended with status " + std::to_string(WEXITSTATUS(status)) + " and no record" + remark);
  }
}

}  // namespace

std::string ProgramFor(const std::string& precision) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path program =
      self.parent_path() / (precision == "float" ? "headless_sim" : "headless_sim_float64");
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error(program.string() + ": is not there, which simulates with Bullet in " + precision);
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
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

LocalWorkers::LocalWorkers(int jobs) : jobs_(jobs) {}

LocalWorkers::~LocalWorkers() {
  for (const Child& child : children_) {
    kill(child.process, SIGKILL);
    waitpid(child.process, nullptr, 0);
    close(child.pipe);
  }
}

void LocalWorkers::Start(const RunSpec& run) {
  const std::string program = ProgramFor(run.precision), spec = run.ToJson().dump();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  const pid_t process = fork();
  if (process == 0) Become(program, spec, ends[1]);
  close(ends[1]);
  if (process < 0) {
    close(ends[0]);
    throw std::runtime_error(std::string("no process: ") + std::strerror(errno));
  }
  children_.push_back({run.number, process, ends[0], ""});
}

std::optional<RunRecord> LocalWorkers::Wait(std::chrono::milliseconds patience) {
  std::vector<pollfd> polled;
  for (const Child& child : children_) polled.push_back({child.pipe, POLLIN, 0});
  // Interrupted or in vain: the caller looks around, and comes again.
  if (poll(polled.data(), polled.size(), static_cast<int>(patience.count())) <= 0) return std::nullopt;
  for (std::size_t i = 0; i < polled.size(); ++i) {
    if (polled[i].revents == 0) continue;
    std::array<char, 4096> text;
    const ssize_t count = read(children_[i].pipe, text.data(), text.size());
    if (count > 0) {
      children_[i].output.append(text.data(), static_cast<std::size_t>(count));
      continue;
    }
    int status = 0;
    waitpid(children_[i].process, &status, 0);
    close(children_[i].pipe);
    const RunRecord record = RecordOf(children_[i].run, status, children_[i].output);
    children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
    return record;
  }
  return std::nullopt;
}

}  // namespace dgd_demos
