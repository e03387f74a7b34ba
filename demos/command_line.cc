#include "command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <type_traits>

#include "seed_option.h"

namespace dgd_demos {
namespace {

/// The check without CLI11's own description of the choices or limits in --help.
template <class Check>
CLI::Validator Silent(Check check) {
  return check.description("");
}

// CLI's own check of a range lets NaN pass, and what is empty where a value is optional.
template <class Number>
CLI::Validator Within(const Limits<Number>& limits) {
  return CLI::Validator(
      [limits](std::string& text) {
        constexpr const char* kWanted = std::is_integral_v<Number> ? "whole number" : "number";
        Number value{};
        if (!CLI::detail::lexical_cast(text, value) || value != value) return "'" + text + "' is no " + kWanted;
        if (!std::isfinite(static_cast<double>(value))) return "must be finite, not " + text;
        std::ostringstream complaint;
        if (value < limits.least || value > limits.most) {
          complaint << "must be from " << limits.least << " to " << limits.most << ", not " << text;
        }
        return complaint.str();
      },
      "");
}

template <class Value>
constexpr bool kIsList = false;
template <class Entry>
constexpr bool kIsList<std::vector<Entry>> = true;

}  // namespace

struct CommandLine::Parser {
  CLI::App app;

  /// An option that is given several times has its last value, as in most programs; a list has all of them.
  template <class Value>
  CLI::Option& Add(const std::string& name, const std::string& kind, Value& value, const std::string& help) {
    CLI::Option& option = *app.add_option(name, value, help)->type_name(kind);
    if constexpr (!kIsList<Value>) option.take_last();
    return option;
  }

  /// A value that may be empty: --help shows no default then.
  template <class Value>
  CLI::Option& AddText(const std::string& name, const std::string& kind, Value& value, const std::string& help) {
    CLI::Option& option = Add(name, kind, value, help);
    if (!value.empty()) option.capture_default_str();
    return option;
  }
};

CommandLine::CommandLine(const std::string& program, const std::string& description, const std::string& footer)
    : parser_(new Parser{CLI::App(description, program)}) {
  constexpr std::size_t kColumnOfHelp = 34;
  parser_->app.footer(footer);
  parser_->app.get_formatter()->column_width(kColumnOfHelp);
}

CommandLine::~CommandLine() = default;

template <class Number>
void CommandLine::AddNumber(const std::string& name, const std::string& kind, Number& value,
                            const Limits<std::type_identity_t<Number>>& limits, const std::string& help) {
  parser_->Add(name, kind, value, help).check(Within(limits))->capture_default_str();
}

template void CommandLine::AddNumber(const std::string&, const std::string&, int&, const Limits<int>&,
                                     const std::string&);
template void CommandLine::AddNumber(const std::string&, const std::string&, double&, const Limits<double>&,
                                     const std::string&);

void CommandLine::AddNumbers(const std::string& name, const std::string& kind, std::vector<double>& values,
                             const Limits<double>& limits, const std::string& help) {
  CLI::Option& option = parser_->Add(name, kind, values, help);
  option.delimiter(',')->check(Within(limits));
  if (!values.empty()) option.capture_default_str();
}

void CommandLine::AddNumber(const std::string& name, const std::string& kind, std::optional<double>& value,
                            const Limits<double>& limits, const std::string& help) {
  parser_->Add(name, kind, value, help).check(Within(limits));
}

void CommandLine::AddIndex(const std::string& name, std::optional<int>& index, const std::string& help) {
  parser_->Add(name, "INDEX", index, help).check(Within(Limits<int>{0, std::numeric_limits<int>::max()}));
}

void CommandLine::AddSeed(std::uint64_t& seed, const std::string& help) { AddSeedOption(parser_->app, seed, help); }

void CommandLine::AddText(const std::string& name, const std::string& kind, std::string& text,
                          const std::string& help) {
  parser_->AddText(name, kind, text, help);
}

void CommandLine::AddPath(const std::string& name, const std::string& kind, std::filesystem::path& path,
                          const std::string& help) {
  parser_->AddText(name, kind, path, help);
}

void CommandLine::AddArgument(const std::string& name, const std::string& kind, std::filesystem::path& path,
                              const std::string& help) {
  parser_->Add(name, kind, path, help).required();
}

void CommandLine::AddChoice(const std::string& name, const std::string& kind, std::string& choice,
                            const std::vector<std::string>& choices, const std::string& help) {
  parser_->AddText(name, kind, choice, help).check(Silent(CLI::IsMember(choices)));
}

void CommandLine::AddWords(const std::string& name, const std::string& kind, std::vector<std::string>& words,
                           const std::string& help) {
  parser_->AddText(name, kind, words, help).delimiter(',');
}

void CommandLine::AddChoices(const std::string& name, const std::string& kind, std::vector<std::string>& words,
                             const std::vector<std::string>& choices, const std::string& help) {
  parser_->AddText(name, kind, words, help).delimiter(',')->check(Silent(CLI::IsMember(choices)));
}

void CommandLine::AddFlag(const std::string& name, bool& flag, const std::string& help) {
  parser_->app.add_flag(name, flag, help);
}

std::optional<int> CommandLine::Parse(int argc, const char* const* argv) try {
  parser_->app.parse(argc, argv);
  return std::nullopt;
} catch (const CLI::ParseError& end) {
  // CLI11's own statuses distinguish kinds of mistakes; ours only reports that there was one.
  constexpr int kBadInput = 2;
  return parser_->app.exit(end, std::cout, std::cerr) == 0 ? 0 : kBadInput;
}

}  // namespace dgd_demos
