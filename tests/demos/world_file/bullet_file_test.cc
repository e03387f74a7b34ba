// Contract: whatever Bullet's importer would trust is refused in one sentence, with the file, the place and the value.
#include "world_file/bullet_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "scene/scene_error.h"
#include "world_file/imported_world.h"
#include "world_file/world_bytes.h"

namespace dgd_demos {
namespace {

using dgd_test::MakeFallingSphere;
using dgd_test::MakeWorld;
using dgd_test::PrecisionWord;
using dgd_test::WorldBytes;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The error is the sentence, or contains it.
void ExpectError(const WorldBytes& world, const std::string& part) {
  const auto error = world.Error();
  ASSERT_TRUE(error) << "loaded, where this was expected: " << part;
  EXPECT_NE(error->find(part), std::string::npos) << *error;
  EXPECT_TRUE(error->starts_with("world: ")) << *error;
}

class FallingSphereTest : public testing::Test {
 protected:
  std::unique_ptr<dgd_test::BulletWorld> original_ = MakeFallingSphere();
  WorldBytes world_{*original_};
  std::size_t body_ = world_.Chunk("RBDY");
  std::size_t shape_ = world_.Chunk("SHAP");
};

TEST_F(FallingSphereTest, Undamaged_IsRead) { EXPECT_FALSE(world_.Error()) << *world_.Error(); }

TEST_F(FallingSphereTest, Header) {
  const auto with = [&](std::size_t position, char letter) {
    WorldBytes damaged = world_;
    damaged.Put(position, letter);
    return damaged;
  };
  ExpectError(with(0, 'X'), "no world of Bullet's: it does not begin with BULLETf or BULLETd");
  ExpectError(with(6, PrecisionWord() == "Float" ? 'd' : 'f'), "it was written by a Bullet in ");
  ExpectError(with(7, '_'), "its pointers have 32 bits");
  ExpectError(with(7, '?'), "byte 7, for the size of pointers, is neither - nor _");
  ExpectError(with(8, 'V'), "its numbers are big-endian");
  ExpectError(with(9, 'x'), "version is no number of three digits");
  ExpectError(with(9, '1'), "Bullet 1.24 wrote it; Bullet 2.82 is the oldest that is read");
}

TEST_F(FallingSphereTest, OtherVersionWithTheSameStructures_IsRead) {
  world_.Put(9, '2');
  world_.Put(10, '8');
  world_.Put(11, '9');
  EXPECT_FALSE(world_.Error()) << *world_.Error();
}

TEST_F(FallingSphereTest, OtherVersionWithAnotherStructure_IsNamed) {
  world_.Put(9, '2');
  world_.Put(10, '8');
  world_.Put(11, '9');
  // "m_inverseMass" becomes another field of the same size.
  const std::string name = "m_inverseMass";
  const std::string text(reinterpret_cast<const char*>(world_.bytes().data()), world_.bytes().size());
  world_.Put(text.find(name) + name.size() - 1, 'z');
  ExpectError(world_, "Bullet 2.89, which wrote the file, has another btRigidBody" + PrecisionWord() +
                          "Data than the one that reads it");
}

TEST_F(FallingSphereTest, EndsOfTheFile) {
  WorldBytes empty = world_;
  empty.bytes().clear();
  ExpectError(empty, "it ends within the 12 bytes of a header");
  WorldBytes header = world_;
  header.bytes().resize(12);
  ExpectError(header, "it ends after chunk 0, without the DNA's");
  WorldBytes without_dna = world_;
  without_dna.bytes().resize(world_.DnaPosition());
  ExpectError(without_dna, "without the DNA's");
  WorldBytes longer = world_;
  longer.bytes().push_back(std::byte{0});
  ExpectError(longer, "1 bytes follow the last chunk");
}

TEST_F(FallingSphereTest, Chunks) {
  WorldBytes long_chunk = world_;
  long_chunk.Put(body_ + 4, std::int32_t{1 << 30});
  ExpectError(long_chunk, "(RBDY) has 1073741824 bytes, and the file ends after ");
  WorldBytes negative = world_;
  negative.Put(body_ + 4, std::int32_t{-8});
  ExpectError(negative, "(RBDY) has -8 bytes");
  WorldBytes structure = world_;
  structure.Put(body_ + 16, std::int32_t{3000});
  ExpectError(structure, "(RBDY) is of structure 3000, and the DNA has 88");
  WorldBytes count = world_;
  count.Put(body_ + 20, std::int32_t{2});
  ExpectError(count, "and 2 elements take ");
  WorldBytes other = world_;
  other.Put(body_ + 16, std::int32_t{0});
  ExpectError(other, "it is not of btRigidBody" + PrecisionWord() + "Data");
  WorldBytes twice = world_;
  twice.Put(body_ + 8, world_.PointerOf(shape_));
  ExpectError(twice, "is that of chunk ");
}

TEST_F(FallingSphereTest, UnknownChunk_IsRemarked) {
  auto bytes = world_.bytes();
  const std::byte* shape = bytes.data() + shape_;
  std::vector<std::byte> unknown(shape, shape + 24);
  std::memcpy(unknown.data(), "WHAT", 4);
  std::memset(unknown.data() + 4, 0, 12);
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(shape_), unknown.begin(), unknown.end());
  const CheckedWorld world = LoadWorldBytes("world", bytes);
  ASSERT_EQ(world.remarks.size(), 1u);
  EXPECT_EQ(world.remarks[0], "Left out: 1 x chunk of the unknown code WHAT.");
}

TEST_F(FallingSphereTest, NumbersThatAreNotFinite) {
  const std::vector<std::string> paths = {"m_collisionObjectData.m_worldTransform.m_origin",
                                          "m_linearVelocity",
                                          "m_angularVelocity",
                                          "m_inverseMass",
                                          "m_invInertiaLocal",
                                          "m_linearDamping",
                                          "m_gravity_acceleration",
                                          "m_collisionObjectData.m_friction"};
  for (const std::string& path : paths) {
    for (const double value : {kNaN, std::numeric_limits<double>::infinity()}) {
      WorldBytes damaged = world_;
      damaged.SetScalar(body_, path, value);
      const std::string field = path.substr(path.find('.') == std::string::npos ? 0 : path.find('.') + 1);
      ExpectError(damaged, field.substr(0, field.find('.')));
    }
  }
  WorldBytes negative = world_;
  negative.SetScalar(body_, "m_inverseMass", -1);
  ExpectError(negative, "m_inverseMass is -1, not a number from 0 to 1e15");
  WorldBytes radius = world_;
  radius.Set(shape_, "m_implicitShapeDimensions", -1.0F);
  ExpectError(radius, "m_implicitShapeDimensions is -1.000000 along an axis");
  WorldBytes scaling = world_;
  scaling.Set(shape_, "m_localScaling", 0.0F);
  ExpectError(scaling, "m_localScaling is 0, not a number above 0");
  WorldBytes margin = world_;
  margin.Set(shape_, "m_collisionMargin", static_cast<float>(kNaN));
  ExpectError(margin, "m_collisionMargin is nan");
  WorldBytes gravity = world_;
  gravity.SetScalar(world_.Chunk("DWLD"), "m_gravity", kNaN);
  ExpectError(gravity, "m_gravity is nan");
}

TEST_F(FallingSphereTest, PosesThatAreNone) {
  world_.SetScalar(body_, "m_collisionObjectData.m_worldTransform.m_basis", 2);
  ExpectError(world_, "m_worldTransform is no rotation");
}

TEST_F(FallingSphereTest, Settings) {
  const std::size_t settings = world_.Chunk("DWLD");
  WorldBytes iterations = world_;
  iterations.Set(settings, "m_solverInfo.m_numIterations", std::int32_t{1'000'000'000});
  ExpectError(iterations, "m_numIterations is 1000000000, not one of 0 to 10000");
  WorldBytes step = world_;
  step.SetScalar(settings, "m_solverInfo.m_timeStep", 0);
  ExpectError(step, "m_timeStep is 0, not a number above 0");
  WorldBytes state = world_;
  state.Set(body_, "m_collisionObjectData.m_activationState1", std::int32_t{17});
  ExpectError(state, "m_activationState1 is 17, not one of 1 to 6");
}

TEST_F(FallingSphereTest, Pointers) {
  const std::string path = "m_collisionObjectData.m_collisionShape";
  WorldBytes null = world_;
  null.Set(body_, path, std::uint64_t{0});
  ExpectError(null, "m_collisionShape names no chunk");
  WorldBytes nowhere = world_;
  nowhere.Set(body_, path, std::uint64_t{0xdeadbeef});
  ExpectError(nowhere, "m_collisionShape names no chunk");
  WorldBytes body = world_;
  body.Set(body_, path, world_.PointerOf(body_));
  ExpectError(body, "a shape is asked for by its pointer, and it is none");
  WorldBytes name = world_;
  name.Set(body_, "m_collisionObjectData.m_name", world_.PointerOf(shape_));
  ExpectError(name, "m_name names chunk 1, which is no string that ends");
}

TEST(WorldErrorTest, UnknownShape_IsRemarkedAndItsBodyLeftOut) {
  auto original = MakeFallingSphere();
  WorldBytes world(*original);
  world.Set(world.Chunk("SHAP"), "m_collisionShapeData.m_shapeType", std::int32_t{24});
  const CheckedWorld checked = LoadWorldBytes("world", world.bytes());
  EXPECT_TRUE(checked.bodies.empty());
  ASSERT_EQ(checked.remarks.size(), 1u);
  EXPECT_EQ(checked.remarks[0],
            "Bullet's importer does not make these shapes: 1 heightfield; without them, 1 body is left out.");
}

TEST(WorldErrorTest, ShapeOfOneTypeWithTheStructureOfAnother) {
  auto original = MakeFallingSphere();
  WorldBytes world(*original);
  world.Set(world.Chunk("SHAP"), "m_collisionShapeData.m_shapeType", std::int32_t{31});
  ExpectError(world, "it is not of btCompoundShapeData");
}

TEST(WorldErrorTest, Hull) {
  auto original = MakeWorld("hulls");
  WorldBytes world(*original);
  const std::size_t hull = world.Chunk("SHAP", "btConvexHullShapeData");
  WorldBytes too_many = world;
  too_many.Set(hull, "m_numUnscaledPoints", std::int32_t{21});
  ExpectError(too_many, "which has 20 elements where 21 are counted on");
  WorldBytes negative = world;
  negative.Set(hull, "m_numUnscaledPoints", std::int32_t{-1});
  ExpectError(negative, "m_numUnscaledPoints is -1, not one of 1 to 10000");
  const std::string points = "m_unscaledPoints" + PrecisionWord() + "Ptr";
  WorldBytes null = world;
  null.Set(hull, points, std::uint64_t{0});
  ExpectError(null, "m_unscaledPointsDoublePtr is null where there should be 20 of btVector3DoubleData");
  WorldBytes other = world;
  other.Set(hull, points, world.PointerOf(hull));
  ExpectError(other, "which is not of btVector3" + PrecisionWord() + "Data");
  WorldBytes point = world;
  point.SetScalar(world.Chunk("ARAY", "btVector3" + PrecisionWord() + "Data"), "m_floats", kNaN, 2);
  ExpectError(point, "[0].m_floats is nan");
}

TEST(WorldErrorTest, CompoundsThatContainThemselves) {
  auto original = MakeWorld("compounds");
  WorldBytes world(*original);
  const std::size_t children = world.Chunk("ARAY", "btCompoundShapeChildData");
  const std::size_t compound = world.Chunk("SHAP", "btCompoundShapeData");
  WorldBytes itself = world;
  itself.Set(children, "m_childShape", world.PointerOf(compound));
  ExpectError(itself, "it contains itself");
  WorldBytes more = world;
  more.Set(compound, "m_numChildShapes", std::int32_t{4});
  ExpectError(more, "which has 3 elements where 4 are counted on");
  WorldBytes turned = world;
  turned.Set(children, "m_transform", 3.0F);
  ExpectError(turned, "[0].m_transform is no rotation");
}

TEST(WorldErrorTest, CompoundsTooDeepOrTooMany) {
  // Doubled 20 times, a compound would be made a million times.
  for (const bool is_wide : {false, true}) {
    auto original = MakeFallingSphere();
    auto* inner = &original->Make<btCompoundShape>();
    inner->addChildShape(btTransform::getIdentity(), &original->Make<btSphereShape>(btScalar(0.1)));
    for (int depth = 0; depth < (is_wide ? 14 : 20); ++depth) {
      auto& outer = original->Make<btCompoundShape>();
      for (int i = 0; i < (is_wide ? 3 : 1); ++i) outer.addChildShape(btTransform::getIdentity(), inner);
      inner = &outer;
    }
    original->Add(*inner, 1, btVector3(5, 0, 0));
    ExpectError(WorldBytes(*original), is_wide ? "it has more than 100000 shapes" : "deep");
  }
}

TEST(WorldErrorTest, Mesh) {
  auto original = MakeWorld("terrain");
  WorldBytes world(*original);
  const std::size_t part = world.Chunk("ARAY", "btMeshPartData");
  WorldBytes index = world;
  index.Set(world.Chunk("ARAY", "btIntIndexData"), "m_value", std::int32_t{600}, 7);
  ExpectError(index, "[7].m_value is 600, and there are 600 vertices");
  WorldBytes below = world;
  below.Set(world.Chunk("ARAY", "btIntIndexData"), "m_value", std::int32_t{-1}, 7);
  ExpectError(below, "[7].m_value is -1, and there are 600 vertices");
  WorldBytes triangles = world;
  triangles.Set(part, "m_numTriangles", std::int32_t{201});
  ExpectError(triangles, "which has 600 elements where 603 are counted on");
  WorldBytes vertices = world;
  vertices.Set(part, "m_numVertices", std::int32_t{601});
  ExpectError(vertices, "which has 600 elements where 601 are counted on");
  WorldBytes parts = world;
  parts.Set(world.Chunk("SHAP", "btTriangleMeshShapeData"), "m_meshInterface.m_numMeshParts", std::int32_t{2});
  ExpectError(parts, "which has 1 elements where 2 are counted on");
  WorldBytes without = world;
  without.Set(part, "m_indices32", std::uint64_t{0});
  ExpectError(without, "it has no indices of vertices");
}

TEST(WorldErrorTest, Constraints) {
  auto original = MakeWorld("ragdoll");
  WorldBytes world(*original);
  const std::size_t joint = world.Chunk("CONS");
  const std::size_t point = world.Chunk(
      "CONS", PrecisionWord() == "Float" ? "btPoint2PointConstraintFloatData" : "btPoint2PointConstraintDoubleData2");
  WorldBytes shape = world;
  shape.Set(joint, "m_typeConstraintData.m_rbA", world.PointerOf(world.Chunk("SHAP")));
  ExpectError(shape, "which is no body");
  WorldBytes same = world;
  same.Set(joint, "m_typeConstraintData.m_rbB", world.PointerOf(world.Chunk("RBDY", "", 1)));
  ExpectError(same, "m_rbB is the same body as m_rbA");
  WorldBytes frame = world;
  frame.Set(joint, "m_rbAFrame", kNaN);
  ExpectError(frame, "m_rbAFrame is ");
  WorldBytes iterations = world;
  iterations.Set(joint, "m_typeConstraintData.m_overrideNumSolverIterations", std::int32_t{1 << 30});
  ExpectError(iterations, "m_overrideNumSolverIterations is 1073741824");
  WorldBytes type = world;
  type.Set(joint, "m_typeConstraintData.m_objectType", std::int32_t{7});
  ExpectError(type, "it is not of btSlider");

  // Without its body, the importer would read through null.
  world.Set(point, "m_typeConstraintData.m_rbA", std::uint64_t{0});
  const CheckedWorld checked = LoadWorldBytes("world", world.bytes());
  EXPECT_EQ(checked.constraints.size(), 5u);
  ASSERT_EQ(checked.remarks.size(), 1u);
  EXPECT_EQ(checked.remarks[0], "1 constraint is left out, which is to the world in a way that it does not make.");
}

TEST(WorldErrorTest, Multibodies) {
  auto original = MakeWorld("chain");
  WorldBytes world(*original);
  const std::size_t multibody = world.Chunk("MBDY"), collider = world.Chunk("MBLC", "", 1);
  const std::size_t links = world.Chunk("ARAY", "btMultiBodyLink" + PrecisionWord() + "Data");
  WorldBytes more = world;
  more.Set(multibody, "m_numLinks", std::int32_t{5});
  ExpectError(more, "which has 4 elements where 5 are counted on");
  WorldBytes parent = world;
  parent.Set(links, "m_parentIndex", std::int32_t{2}, 2);
  ExpectError(parent, "[2].m_parentIndex is 2, not one of -1 to 1");
  WorldBytes type = world;
  type.Set(links, "m_jointType", std::int32_t{9}, 2);
  ExpectError(type, "[2].m_jointType is 9, not one of 0 to 4");
  WorldBytes link = world;
  link.Set(collider, "m_link", std::int32_t{4});
  ExpectError(link, "m_link is 4, not one of -1 to 3");
  WorldBytes again = world;
  again.Set(collider, "m_link", std::int32_t{-1});
  ExpectError(again, "m_link is -1, which has a collider already");
  WorldBytes nowhere = world;
  nowhere.Set(collider, "m_multiBody", std::uint64_t{0});
  ExpectError(nowhere, "m_multiBody names no multibody");
  WorldBytes turn = world;
  turn.SetScalar(multibody, "m_baseWorldOrientation", 3);
  ExpectError(turn, "m_baseWorldOrientation is no rotation");

  world.Set(links, "m_jointType", std::int32_t{3});
  const CheckedWorld checked = LoadWorldBytes("world", world.bytes());
  EXPECT_EQ(checked.multibodies.size(), 1u);
  EXPECT_EQ(checked.colliders.size(), 5u);
  ASSERT_FALSE(checked.remarks.empty());
  EXPECT_EQ(checked.remarks[0], "1 multibody is left out for a planar joint, which Bullet's importer does not make.");
}

TEST(WorldErrorTest, FileThatIsNotThere) {
  try {
    LoadWorldFile("/nowhere/world.bullet");
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/world.bullet: No such file or directory");
  }
}

}  // namespace
}  // namespace dgd_demos
