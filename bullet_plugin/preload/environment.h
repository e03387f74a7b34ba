// Switches in the environment.
#pragma once

#include <cstdlib>
#include <cstring>

namespace dgd_preload {

/// Whether a variable is set to anything but nothing or 0.
inline bool IsOn(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' && std::strcmp(value, "0") != 0;
}

constexpr const char kOff[] = "DGD_BULLET_OFF";
constexpr const char kOptions[] = "DGD_BULLET_OPTIONS";
constexpr const char kStatistics[] = "DGD_BULLET_STATISTICS";
constexpr const char kAudit[] = "DGD_BULLET_AUDIT";

}  // namespace dgd_preload
