// The command line of a program: its options, what --help says of them, and complaints.
//
// CLI11 does the work in one file. A program that included it would take longer to compile for it than for all else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace dgd_demos {

/// Range of a number, ends included.
template <class Number>
struct Limits {
  Number least, most;
};

/// For values that are checked together with others.
inline constexpr Limits<double> kAnyNumber = {std::numeric_limits<double>::lowest(),
                                              std::numeric_limits<double>::max()};

/// Options are added with the place of their value, which is the default, and must be there until after Parse(). What
/// --help calls a value's kind is `kind`: "N", "FILE".
class CommandLine {
 public:
  /// @param description, footer  What --help says before the options and after them.
  CommandLine(const std::string& program, const std::string& description, const std::string& footer);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// An int or a double.
  template <class Number>
  void AddNumber(const std::string& name, const std::string& kind, Number& value,
                 const Limits<std::type_identity_t<Number>>& limits, const std::string& help);
  /// Some numbers, with commas or spaces between them.
  void AddNumbers(const std::string& name, const std::string& kind, std::vector<double>& values,
                  const Limits<double>& limits, const std::string& help);
  /// A number, or nothing if the option is not given.
  void AddNumber(const std::string& name, const std::string& kind, std::optional<double>& value,
                 const Limits<double>& limits, const std::string& help);
  /// The index of a case, from 0, or nothing.
  void AddIndex(const std::string& name, std::optional<int>& index, const std::string& help);
  /// --seed: a whole 64-bit number.
  void AddSeed(std::uint64_t& seed, const std::string& help);

  void AddText(const std::string& name, const std::string& kind, std::string& text, const std::string& help);
  void AddPath(const std::string& name, const std::string& kind, std::filesystem::path& path, const std::string& help);
  /// A path without a name of its own, which must be there.
  void AddArgument(const std::string& name, const std::string& kind, std::filesystem::path& path,
                   const std::string& help);
  /// One of the choices.
  void AddChoice(const std::string& name, const std::string& kind, std::string& choice,
                 const std::vector<std::string>& choices, const std::string& help);
  /// Some words, with commas or spaces between them: any, or some of the choices.
  void AddWords(const std::string& name, const std::string& kind, std::vector<std::string>& words,
                const std::string& help);
  void AddChoices(const std::string& name, const std::string& kind, std::vector<std::string>& words,
                  const std::vector<std::string>& choices, const std::string& help);
  void AddFlag(const std::string& name, bool& flag, const std::string& help);

  /// Reads the options, prints --help, or reports a mistake on standard error.
  /// @return nothing; or the program is to end with this exit status, as all programs name them: 0 (kSuccess) after
  ///         --help, 2 (kBadInput) after a complaint.
  std::optional<int> Parse(int argc, const char* const* argv);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace dgd_demos
