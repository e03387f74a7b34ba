#include "sweep/local_workers.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "sibling_program.h"

namespace dgd_demos {
namespace {

constexpr int kCannotBeStarted = 127;  // The status that shells have for it.

// Replaces this process by the run's.
[[noreturn]] void Become(const std::string& program, const std::string& run, int pipe) {
  // The run ends with the sweep, and Ctrl-C on a terminal reaches the sweep alone.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  dup2(pipe, STDOUT_FILENO);
  dup2(pipe, STDERR_FILENO);
  execl(program.c_str(), program.c_str(), "one", run.c_str(), nullptr);
  _exit(kCannotBeStarted);
}

// The last line that is not empty.
std::string LastLine(const std::string& text) {
  const std::size_t last = text.find_last_not_of(" \n\r\t");
  if (last == std::string::npos) return "";
  const std::size_t newline = text.rfind('\n', last);
  const std::size_t first = newline == std::string::npos ? 0 : newline + 1;
  return text.substr(first, last + 1 - first);
}

RunRecord Failure(int run, const std::string& message) { return {run, RunRecord::Status::kFailed, message, "", {}}; }

// The record that a finished child has printed, or one that says why there is none.
RunRecord RecordOf(int run, int status, const std::string& output) {
  const std::string last = LastLine(output);
  const std::string remark = last.empty() ? "" : "; its last line: " + last;
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
  // Not above 0 after a signal, and where nothing happens within the time.
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
