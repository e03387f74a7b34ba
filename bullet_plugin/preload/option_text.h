// Options of the narrowphase as a line of text, for environments and command lines.
#pragma once

#include <string_view>

#include "dgd_bullet/options.h"

namespace dgd_preload {

/// Options from "friction_anchors=off,relative_tolerance=1e-6": names and values of dgd_bullet/options.h; switches are
/// on or off, modes are named as their enumerators are (normal_mode=growth). Of a name that comes twice, the last one
/// counts. Throws std::invalid_argument that names what is wrong. Ranges are checked when a narrowphase is made.
dgd_bullet::Options ParseOptions(std::string_view text);

}  // namespace dgd_preload
