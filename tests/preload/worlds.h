// Worlds of a Bullet app that is written without dgd_bullet.
#pragma once

extern "C" {

/// Lets bodies of several shapes fall onto the ground, and prints their last poses as hexadecimal floats.
/// @param arrangement  "one" world; three in "sequence", each with a configuration of its own in the same place;
///                     two "together", stepped in turns; or RunHeap() for "heap".
/// @return an exit status: 0 if all bodies are at rest where they must be, 1 if not, 2 for another arrangement.
int RunWorlds(const char* arrangement);
}
