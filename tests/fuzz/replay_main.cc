// A fuzz target without a fuzzer: asks for each file of a corpus, and for each as it is after a few changes of bytes,
// in any build and by any compiler. Usage: fuzz_TARGET [--changes N] FILE_OR_FOLDER...
//
// The changes are the same on every machine. An input is written to fuzz_TARGET.crash in the current folder before it
// is asked for, and stays there if the process ends.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"
#include "support/random.h"

namespace dgd_fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::filesystem::path> FilesOf(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

Bytes Read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    std::cerr << file << " cannot be read\n";
    std::exit(2);
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

void Ask(const Bytes& bytes, const std::filesystem::path& crash_file) {
  {
    std::ofstream(crash_file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

/// One byte set, one bit turned, a piece left out, or a piece of another file put in.
Bytes Changed(const Bytes& bytes, const Bytes& other, dgd_test::Random& random) {
  Bytes changed = bytes;
  const auto place_in = [&](const Bytes& any) { return random.Below(static_cast<int>(any.size())); };
  if (changed.empty() || other.empty()) return changed;
  switch (random.Below(4)) {
    case 0:
      changed[static_cast<std::size_t>(place_in(changed))] = static_cast<std::uint8_t>(random.Below(256));
      break;
    case 1:
      changed[static_cast<std::size_t>(place_in(changed))] ^= static_cast<std::uint8_t>(1 << random.Below(8));
      break;
    case 2:
      changed.erase(changed.begin() + place_in(changed));
      break;
    default:
      changed.resize(static_cast<std::size_t>(place_in(changed)));
      changed.insert(changed.end(), other.begin() + place_in(other), other.end());
  }
  return changed;
}

int Replay(const std::vector<std::filesystem::path>& files, int changes, const std::filesystem::path& crash_file) {
  std::vector<Bytes> inputs;
  for (const auto& file : files) inputs.push_back(Read(file));
  dgd_test::Random random(dgd_test::TestSeed());
  for (const Bytes& input : inputs) {
    Ask(input, crash_file);
    Bytes changed = input;
    for (int i = 0; i < changes; ++i) {
      // On and on from what has been changed, and from the start again now and then.
      if (random.Below(4) == 0) changed = input;
      changed =
          Changed(changed, inputs[static_cast<std::size_t>(random.Below(static_cast<int>(inputs.size())))], random);
      Ask(changed, crash_file);
    }
  }
  std::filesystem::remove(crash_file);
  std::cout << inputs.size() << " inputs, each with " << changes << " changes\n";
  return inputs.empty() ? 2 : 0;
}

}  // namespace
}  // namespace dgd_fuzz

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  int changes = 0;
  if (arguments.size() > 1 && arguments[0] == "--changes") {
    changes = std::atoi(arguments[1].c_str());
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  std::vector<std::filesystem::path> files;
  for (const std::string& argument : arguments) {
    const auto of_argument = dgd_fuzz::FilesOf(argument);
    files.insert(files.end(), of_argument.begin(), of_argument.end());
  }
  return dgd_fuzz::Replay(files, changes, std::filesystem::path(argv[0]).filename().concat(".crash"));
}
