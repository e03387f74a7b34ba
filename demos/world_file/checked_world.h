// The door for .bullet files: the structures of a file that Bullet's importer reads.
//
// The importer trusts a file wholly: offsets, counts, pointers, and the DNA, by which it converts structures that
// differ from its own. So its reader is not used at all. Every structure that it would take is checked here and copied
// into memory of our own, with all pointers null but those that were checked, and the importer converts these copies.
// Chunks that it does not take never reach it.
//
// Structures must be described by the file's DNA as by that of the Bullet that reads: then no conversion is needed, the
// checks are for one layout, and files by other versions pass if their structures are the same. To convert a foreign
// layout would be to trust its description.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "world_file/bullet_file.h"
#include "world_file/dna.h"

namespace dgd_demos {

/// A world file that Bullet's importer can take without harm. The addresses are of structures as Bullet declares them,
/// in memory that this owns.
struct CheckedWorld {
  std::string name;  ///< Name of the file in messages.
  Precision precision;
  int version;  ///< 324 is Bullet 3.24.

  std::vector<void*> shapes;       ///< bt...ShapeData
  std::vector<void*> worlds;       ///< btDynamicsWorld{Float,Double}Data: one, or none.
  std::vector<void*> bodies;       ///< btRigidBody{Float,Double}Data
  std::vector<void*> objects;      ///< btCollisionObject{Float,Double}Data
  std::vector<void*> constraints;  ///< Constraints of all kinds; each begins with btTypedConstraint{Float,Double}Data.
  std::vector<void*> multibodies;  ///< btMultiBody{Float,Double}Data
  std::vector<void*> colliders;    ///< btMultiBodyLinkCollider{Float,Double}Data

  std::vector<std::string> remarks;  ///< Sentences about parts that cannot be restored, one for each kind.

  std::vector<std::unique_ptr<std::byte[]>> memory;  ///< Memory that the addresses point into.
};

/// @param precision      Precision of the Bullet that is to read the file.
/// @param reference_dna  DNA of that Bullet.
/// @throws SceneError in one sentence: file, chunk with its place and structure, field and value.
CheckedWorld CheckWorld(const BulletFile& file, Precision precision, const Dna& reference_dna);

}  // namespace dgd_demos
