// What the stages of the pipeline pass on. Free of Bullet, like posed_shape.h.
#pragma once

#include "dgd/query_types.h"

namespace dgd_bullet {

/// Two shapes' contact, or the plane between them: `status`, `normal` (unit, from A to B, world), `separation` along it
/// (metres, negative for overlap), and a witness point on either shape (world). The bounds are the growth distance's,
/// and unknown where another stage has found the contact.
using Contact = dgd::Result<double>;

}  // namespace dgd_bullet
