// A heap of many shapes, with all that an app sees of its contacts.
#pragma once

/// Lets balls, capsules, cones, hulls, boxes and compounds fall onto a plane, a mesh and each other. Prints their last
/// poses, and what callbacks and queries of contacts saw, as hexadecimal floats.
/// @return whether no body fell through the ground.
bool RunHeap();
