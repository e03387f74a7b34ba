// A program run as its users run it, for tests of its exit status and what it says.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace dgd_test {

struct Outcome {
  int status;
  std::string output;  // Both streams.
};

inline Outcome RunProgram(const std::string& program, const std::string& arguments) {
  std::FILE* pipe = popen((program + " " + arguments + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> text;
  while (std::fgets(text.data(), static_cast<int>(text.size()), pipe) != nullptr) output += text.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

inline int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace dgd_test
