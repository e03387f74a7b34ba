// What the stub calls in a backend: C functions, found by name. The stub is compiled without Bullet, whose pointers are
// void here.
#pragma once

namespace dgd_preload {

/// The two tables of a dispatcher, each with a getter of btDefaultCollisionConfiguration.
enum Table { kContacts, kClosestPoints, kTables };

/// Prepares the backend, as the environment says; called once or more.
/// @return null, or why Bullet's own narrowphase must be used, to follow a colon in a sentence.
using Start = const char*();
constexpr const char kStartName[] = "dgd_bullet_preload_start";

/// @param configuration  The btDefaultCollisionConfiguration whose getter was called.
/// @param original       What that getter returns.
/// @return the btCollisionAlgorithmCreateFunc* to use: ours, or `original` where the types are left to Bullet. It lives
/// until the process ends.
using ChooseCreateFunc = void*(const void* configuration, Table table, int type_0, int type_1, void* original);
constexpr const char kChooseCreateFuncName[] = "dgd_bullet_preload_choose_create_func";

}  // namespace dgd_preload
