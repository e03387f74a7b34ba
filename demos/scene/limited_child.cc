#include "scene/limited_child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <stdexcept>

namespace dgd_demos {
namespace {

using Clock = std::chrono::steady_clock;

enum ChildStatus { kSent = 0, kNoMemory = 1, kCannotSend = 2 };

// What the child sends first.
struct Head {
  std::uint64_t is_error;
  std::uint64_t size;  // Of the result or the error's message, which follows; bytes.
};

template <class Resource>
void LimitTo(rlim_t value, Resource resource) {
  rlimit limit;
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, value);
  setrlimit(resource, &limit);
}

// Added to what the process has: the memory that sanitizers reserve is larger than any limit.
void LimitMemory(std::uint64_t memory) {
  std::uint64_t all = 0, ignored = 0, data = 0;  // Pages.
  std::ifstream statm("/proc/self/statm");
  if (!(statm >> all >> ignored >> ignored >> ignored >> ignored >> data)) return;
  const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  LimitTo(all * page + memory, RLIMIT_AS);
  LimitTo(data * page + memory, RLIMIT_DATA);
}

// Nothing that this process does about signals and output is for its child.
// @return the pipe, beside the standard streams, which may have been closed when it was made.
int Isolate(pid_t parent, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kCannotSend);  // It ended before the line above.
  for (int number = 1; number < NSIG; ++number) std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int beside = fcntl(pipe, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  return beside;
}

bool Send(int pipe, const void* bytes, std::size_t size) {
  const char* rest = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t count = write(pipe, rest, size);
    if (count < 0) return false;
    rest += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

// Nothing that is thrown in the child may reach those who called for it in this process.
[[noreturn]] void Work(const std::function<std::string()>& work, const ChildLimits& limits, int pipe) noexcept {
  LimitTo(0, RLIMIT_CORE);
  LimitTo(limits.processor_time, RLIMIT_CPU);
  LimitMemory(limits.memory);
  Head head = {};
  std::string content;
  try {
    content = work();
  } catch (const std::bad_alloc&) {
    _exit(kNoMemory);
  } catch (const std::exception& error) {
    head.is_error = 1;
    content = error.what();
  }
  head.size = content.size();
  const bool is_sent = Send(pipe, &head, sizeof head) && Send(pipe, content.data(), content.size());
  _exit(is_sent ? kSent : kCannotSend);  // Without what this process does at its end.
}

class Child {
 public:
  Child(const std::function<std::string()>& work, const ChildLimits& limits) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ == 0) {
      const int pipe = Isolate(parent, ends[1]);
      Work(work, limits, pipe);
    }
    const int error = errno;
    pipe_ = ends[0];
    close(ends[1]);
    if (process_ > 0) return;
    close(pipe_);
    throw std::runtime_error(std::string("no process: ") + std::strerror(error));
  }
  ~Child() {
    End();
    close(pipe_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// All that it sends until it ends; false if it has not ended by then.
  bool ReceiveUntil(Clock::time_point deadline, std::string& received) {
    while (true) {
      // The pipe may outlive the child in a process that another thread has begun meanwhile.
      const bool has_ended = HasEnded();
      constexpr std::chrono::milliseconds kPatience(50);
      pollfd polled = {pipe_, POLLIN, 0};
      if (poll(&polled, 1, has_ended ? 0 : static_cast<int>(kPatience.count())) > 0) {
        std::array<char, 65536> bytes;
        const ssize_t count = read(pipe_, bytes.data(), bytes.size());
        if (count > 0) received.append(bytes.data(), static_cast<std::size_t>(count));
        if (count == 0) return EndsBy(deadline);
      } else if (has_ended) {
        return true;
      }
      if (Clock::now() > deadline) return false;
    }
  }

  /// As from waitpid(). @pre it has ended.
  int status() const { return status_; }

 private:
  bool HasEnded() {
    if (is_waited_for_) return true;
    const pid_t ended = waitpid(process_, &status_, WNOHANG);
    // Without a child, because this process ignores the ends of its children, all is known that will be.
    is_waited_for_ = ended == process_ || (ended < 0 && errno == ECHILD);
    return is_waited_for_;
  }

  bool EndsBy(Clock::time_point deadline) {
    while (!HasEnded()) {
      if (Clock::now() > deadline) return false;
      usleep(100);
    }
    return true;
  }

  void End() {
    if (is_waited_for_) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
  }

  pid_t process_;
  int pipe_;
  int status_ = 0;
  bool is_waited_for_ = false;
};

// What a child has to be said of that has ended without a result.
std::string EndOf(int status, const ChildLimits& limits) {
  if (WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGXCPU) {
      return "takes more than " + std::to_string(limits.processor_time) + " s of processor time";
    }
    return std::string("crashed (") + strsignal(WTERMSIG(status)) + ")";
  }
  if (WEXITSTATUS(status) != kNoMemory) return "crashed (status " + std::to_string(WEXITSTATUS(status)) + ")";
  return "takes more than " + std::to_string(limits.memory >> 20) + " MB of memory";
}

}  // namespace

std::string RunInChild(const std::string& name, const std::function<std::string()>& work, const ChildLimits& limits) {
  Child child(work, limits);
  std::string received;
  if (!child.ReceiveUntil(Clock::now() + std::chrono::seconds(limits.wall_time), received)) {
    throw std::runtime_error(name + " takes more than " + std::to_string(limits.wall_time) + " s");
  }
  Head head = {};
  if (received.size() >= sizeof head) std::memcpy(&head, received.data(), sizeof head);
  const bool is_complete = received.size() >= sizeof head && received.size() - sizeof head == head.size;
  if (child.status() != 0 || !is_complete) throw std::runtime_error(name + " " + EndOf(child.status(), limits));
  received.erase(0, sizeof head);
  if (head.is_error != 0) throw std::runtime_error(received);
  return received;
}

}  // namespace dgd_demos
