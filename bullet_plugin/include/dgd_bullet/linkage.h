// What a linker sees of this library: a namespace for each precision of Bullet, and the names that a shared library
// exports.
#pragma once

/// Bullet's types have the same names in float and in double; ours have not, so that what was compiled for one
/// precision does not link with the library of the other: the undefined symbol is dgd_bullet::float64::Register.
/// The namespace is inline, and an app never writes it. Only what does not depend on Bullet (the record file) is
/// outside of it.
#ifdef BT_USE_DOUBLE_PRECISION
#define DGD_BULLET_PRECISION float64
#else
#define DGD_BULLET_PRECISION float32
#endif

/// Marks what apps use; a shared library hides everything else.
#define DGD_BULLET_EXPORT [[gnu::visibility("default")]]
