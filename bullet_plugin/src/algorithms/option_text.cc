#include "dgd_bullet/option_text.h"

#include <charconv>
#include <stdexcept>
#include <string>
#include <system_error>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

template <bool Options::*kMember>
bool SetSwitch(std::string_view value, Options& options) {
  options.*kMember = value == "on";
  return value == "on" || value == "off";
}

template <auto kMember>
bool SetNumber(std::string_view value, Options& options) {
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), options.*kMember);
  return error == std::errc() && end == value.data() + value.size();
}

bool SetGeometryMode(std::string_view value, Options& options) {
  options.geometry_mode = value == "sharp" ? GeometryMode::kSharp : GeometryMode::kBullet;
  return value == "sharp" || value == "bullet";
}

bool SetOnFirstFallback(std::string_view value, Options& options) {
  options.on_first_fallback = value == "on" ? PrintToStandardError : nullptr;
  return value == "on" || value == "off";
}

struct Option {
  std::string_view name, values;
  bool (*set)(std::string_view value, Options& options);  ///< Returns false for a value that is none.
};

constexpr std::string_view kSwitch = "on or off", kNumber = "a number", kInteger = "an integer";

/// All options but count_pairs, which is a switch of its own, and pair_observer, which is an object.
constexpr Option kOptions[] = {
    {"relative_tolerance", kNumber, SetNumber<&Options::relative_tolerance>},
    {"max_iterations", kInteger, SetNumber<&Options::max_iterations>},
    {"contact_patch", kSwitch, SetSwitch<&Options::contact_patch>},
    {"patch_size", kInteger, SetNumber<&Options::patch_size>},
    {"contact_distance", kNumber, SetNumber<&Options::contact_distance>},
    {"geometry_mode", "bullet or sharp", SetGeometryMode},
    {"speculative_contacts", kSwitch, SetSwitch<&Options::speculative_contacts>},
    {"friction_anchors", kSwitch, SetSwitch<&Options::friction_anchors>},
    {"order_points_by_impulse", kSwitch, SetSwitch<&Options::order_points_by_impulse>},
    {"keep_resting_contacts", kSwitch, SetSwitch<&Options::keep_resting_contacts>},
    {"warm_start", kSwitch, SetSwitch<&Options::warm_start>},
    {"keep_empty_manifolds", kSwitch, SetSwitch<&Options::keep_empty_manifolds>},
    {"on_first_fallback", kSwitch, SetOnFirstFallback},
};

const Option& OptionOf(std::string_view name) {
  std::string names;
  for (const Option& option : kOptions) {
    if (option.name == name) return option;
    names.append(names.empty() ? "" : ", ").append(option.name);
  }
  throw std::invalid_argument("there is no option '" + std::string(name) + "', but " + names);
}

void SetOption(std::string_view setting, Options& options) {
  const std::size_t equals = setting.find('=');
  const Option& option = OptionOf(setting.substr(0, equals));
  const std::string_view value = equals == setting.npos ? "" : setting.substr(equals + 1);
  if (option.set(value, options)) return;
  throw std::invalid_argument("option " + std::string(option.name) + " must be " + std::string(option.values) +
                              ", not '" + std::string(value) + "'");
}

}  // namespace

Options ParseOptions(std::string_view text) {
  Options options;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    SetOption(text.substr(0, comma), options);
    text.remove_prefix(comma == text.npos ? text.size() : comma + 1);
  }
  return options;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
