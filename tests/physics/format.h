// snprintf() into a string, for the lines of reports.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace dgd_physics {

/// What is longer than a line of a report is cut off.
template <class... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 512> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace dgd_physics
