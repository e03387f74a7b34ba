// The sentence in which a program reports an exception.
#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace dgd_demos {

/// The message of an exception; for one of std::filesystem, whose own is for programmers, path and reason.
inline std::string MessageOf(const std::exception& error) {
  const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
  if (of_file == nullptr || of_file->path1().empty()) return error.what();
  return of_file->path1().string() + ": " + of_file->code().message();
}

}  // namespace dgd_demos
