#include "soak/soak_state.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "soak/soak_case.h"

namespace dgd_soak {
namespace {

using dgd_test::Tally;

constexpr const char* kFirstLine = "dgd_soak state, version 1";

[[noreturn]] void Refuse(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

}  // namespace

SoakState::SoakState(std::string options)
    : case_options(std::move(options)), in_double(AllTypePairs().size()), in_float(AllTypePairs().size()) {}

void SoakState::Merge(const SoakState& next) {
  done += next.done;
  for (std::size_t i = 0; i < in_double.size(); ++i) {
    if (next.in_double[i].pairs > 0) in_double[i].Merge(next.in_double[i]);
    if (next.in_float[i].pairs > 0) in_float[i].Merge(next.in_float[i]);
  }
  for (const std::int64_t failure : next.failures) {
    if (failures.size() < kMaxFailures) failures.push_back(failure);
  }
}

void Save(const SoakState& state, const std::filesystem::path& file) {
  std::filesystem::path unfinished = file;
  unfinished += ".new";
  std::ofstream out(unfinished);
  out << kFirstLine << '\n' << state.case_options << '\n' << AllTypePairs().size() << ' ' << state.done << '\n';
  out << state.failures.size();
  for (const std::int64_t failure : state.failures) out << ' ' << failure;
  out << '\n';
  for (const auto* tallies : {&state.in_double, &state.in_float}) {
    for (const Tally& tally : *tallies) Write(out, tally);
  }
  out << "end\n" << std::flush;
  if (!out) Refuse(unfinished, std::string("cannot be written: ") + std::strerror(errno));
  out.close();
  std::filesystem::rename(unfinished, file);
}

SoakState Load(const std::filesystem::path& file, const std::string& case_options) {
  std::ifstream in(file);
  std::string first_line, options;
  std::getline(in, first_line);
  std::getline(in, options);
  if (!in || first_line != kFirstLine) Refuse(file, "not a state of dgd_soak");
  if (options != case_options) Refuse(file, "a state of \"" + options + "\", not of \"" + case_options + "\"");

  SoakState state(case_options);
  std::size_t type_pairs = 0, failures = 0;
  in >> type_pairs >> state.done >> failures;
  if (!in || failures > SoakState::kMaxFailures) Refuse(file, "damaged");
  if (type_pairs != AllTypePairs().size()) Refuse(file, "of a dgd_soak with other types of sets");
  state.failures.resize(failures);
  for (std::int64_t& failure : state.failures) in >> failure;
  for (auto* tallies : {&state.in_double, &state.in_float}) {
    for (Tally& tally : *tallies) Read(in, tally);
  }
  std::string end;
  in >> end;
  if (end != "end") Refuse(file, "damaged");
  return state;
}

}  // namespace dgd_soak
