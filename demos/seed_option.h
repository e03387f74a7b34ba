// The option --seed of every program: a whole 64-bit number, or a clear error.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

namespace dgd_demos {

/// Adds --seed to the program's options. CLI11 itself wraps a negative number around and cuts off a large one.
inline void AddSeedOption(CLI::App& app, std::uint64_t& seed, const std::string& description) {
  const auto check = [](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_seed = error == std::errc() && end == text.data() + text.size();
    return is_seed ? "" : "must be an integer from 0 to 18446744073709551615, not " + text;
  };
  app.add_option("--seed", seed, description)->type_name("N")->check(CLI::Validator(check, ""))->capture_default_str();
}

}  // namespace dgd_demos
