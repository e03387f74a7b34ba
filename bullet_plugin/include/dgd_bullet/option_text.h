// Options of the narrowphase as a line of text, for configuration files, environments and command lines.
#pragma once

#include <string_view>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Options from "friction_anchors=off,relative_tolerance=1e-6": names and values of dgd_bullet/options.h. All options
/// but count_pairs and pair_observer; switches are on or off, modes are named as their enumerators are
/// (geometry_mode=sharp). Of a name that comes twice, the last one counts; what is not named has its default.
/// @throws std::invalid_argument that names what is wrong. Ranges are checked when a narrowphase is made.
DGD_BULLET_EXPORT Options ParseOptions(std::string_view text);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
