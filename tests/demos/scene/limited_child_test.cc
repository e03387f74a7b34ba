// Contract: work in a child returns what it returns, or throws a sentence about its end; no child is left.
#include "scene/limited_child.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

extern "C" void __asan_init() __attribute__((weak));  // There is one if the program is sanitized.

namespace dgd_demos {
namespace {

constexpr ChildLimits kLimits = {1, 30, 100 << 20};

// What it returns, or what is wrong with it.
std::string RunWork(const std::function<std::string()>& work, const ChildLimits& limits = kLimits) {
  std::string result;
  try {
    result = RunInChild("it", work, limits);
  } catch (const std::runtime_error& error) {
    result = std::string("error: ") + error.what();
  }
  return result;
}

bool HasChild() { return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD; }

TEST(LimitedChildTest, Result_IsWhatTheWorkReturns) {
  EXPECT_EQ(RunWork([] { return std::string(); }), "");
  EXPECT_EQ(RunWork([] { return std::string("a\0b", 3); }), std::string("a\0b", 3));
  const std::string much(10'000'000, 'x');
  EXPECT_TRUE(RunWork([&] { return much; }) == much) << "more than a pipe holds";
  EXPECT_EQ(RunWork([]() -> std::string { throw std::invalid_argument("it is odd"); }), "error: it is odd");
  EXPECT_FALSE(HasChild());
}

TEST(LimitedChildTest, ChildThatFails_HasASentence) {
  volatile bool always = true;
  EXPECT_EQ(RunWork([]() -> std::string { std::abort(); }), "error: it crashed (Aborted)");
  EXPECT_EQ(RunWork([]() -> std::string { throw 1; }), "error: it crashed (Aborted)");
  EXPECT_EQ(RunWork([]() -> std::string { _exit(7); }), "error: it crashed (status 7)");
  EXPECT_EQ(RunWork([&]() -> std::string {
              while (always) {
              }
              return "";
            }),
            "error: it takes more than 1 s of processor time");
  EXPECT_EQ(RunWork(
                [&]() -> std::string {
                  while (always) pause();
                  return "";
                },
                {1, 1, 100 << 20}),
            "error: it takes more than 1 s");
  EXPECT_FALSE(HasChild());
}

TEST(LimitedChildTest, ChildThatGrows_HasASentence) {
  const auto grow = []() -> std::string {
    std::vector<std::string> memory;
    for (int i = 0; i < 1000; ++i) memory.emplace_back(1 << 20, char('a' + i % 2));
    return memory.back();
  };
  const std::string result = RunWork(grow, {1, 5, 100 << 20});
  if (__asan_init != nullptr) {
    EXPECT_TRUE(result.starts_with("error: it ")) << "the sanitizer ends it, or hangs: " << result;
  } else {
    EXPECT_EQ(result, "error: it takes more than 100 MB of memory");
  }
}

// As under some daemons.
TEST(LimitedChildTest, WithoutStandardStreams_TheResultIsTheSame) {
  const std::string result = RunWork([] {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) close(stream);
    return RunWork([] {
      std::fputs("noise", stdout);
      std::fflush(stdout);
      return std::string("result");
    });
  });
  EXPECT_EQ(result, "result");
}

// Others use the heap while the child is made, and have children of their own.
TEST(LimitedChildTest, Threads_DoNotDisturbIt) {
  if (__asan_init != nullptr) GTEST_SKIP() << "the sanitizer's heap may be locked in a child";
  const auto repeat = [](char letter) {
    for (int i = 0; i < 50; ++i) {
      const std::string much(100'000, letter);
      EXPECT_TRUE(RunWork([&] { return std::string(much.begin(), much.end()); }) == much);
      std::vector<std::string> heap;
      for (int k = 0; k < 1000; ++k) heap.emplace_back(static_cast<std::size_t>(100 + k), letter);
    }
  };
  std::vector<std::thread> threads;
  for (const char letter : {'a', 'b', 'c', 'd'}) threads.emplace_back(repeat, letter);
  for (std::thread& thread : threads) thread.join();
  EXPECT_FALSE(HasChild());
}

}  // namespace
}  // namespace dgd_demos
