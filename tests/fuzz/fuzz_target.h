// A fuzz target: libFuzzer's entry, which the replaying main() calls as well, and how a target says what it found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string_view>

/// Asks for what the bytes say, and ends the process if an answer is not what was promised.
/// @return 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace dgd_fuzz {

/// Ends the process, as a sanitizer would.
/// @param what  Is wrong, and with which input.
[[noreturn]] inline void Fail(std::string_view what) {
  std::cerr << "fuzz target: " << what << std::endl;
  std::abort();
}

}  // namespace dgd_fuzz
