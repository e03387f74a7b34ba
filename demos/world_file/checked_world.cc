#include "world_file/checked_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "scene/scene_error.h"
#include "world_file/shape_check.h"

namespace dgd_demos {
namespace {

constexpr int kMostIterations = 10'000;  // Iterations of the solver; Bullet's default is 10.
constexpr int kMostLinks = 1000;
constexpr double kLongestStep = 1;  // s

/// Which bodies Bullet's importer needs to make a constraint: without them, it reads through null.
enum class Needs { kA, kB, kBoth };

/// Bullet's numbers of constraints (btTypedConstraintType), and what it writes them as.
struct ConstraintKind {
  int type;
  std::string_view in_float, in_double;
  Needs needs;
  std::string_view base;  // What has "m_typeConstraintData", if not the structure itself.
};

constexpr std::array kConstraintKinds = {
    ConstraintKind{3, "btPoint2PointConstraintFloatData", "btPoint2PointConstraintDoubleData2", Needs::kA, ""},
    ConstraintKind{4, "btHingeConstraintFloatData", "btHingeConstraintDoubleData2", Needs::kA, ""},
    ConstraintKind{5, "btConeTwistConstraintData", "btConeTwistConstraintDoubleData", Needs::kA, ""},
    ConstraintKind{6, "btGeneric6DofConstraintData", "btGeneric6DofConstraintDoubleData2", Needs::kB, ""},
    ConstraintKind{7, "btSliderConstraintData", "btSliderConstraintDoubleData", Needs::kB, ""},
    ConstraintKind{9, "btGeneric6DofSpringConstraintData", "btGeneric6DofSpringConstraintDoubleData2", Needs::kBoth,
                   "m_6dofData"},
    ConstraintKind{10, "btGearConstraintFloatData", "btGearConstraintDoubleData", Needs::kBoth, ""},
    ConstraintKind{12, "btGeneric6DofSpring2ConstraintData", "btGeneric6DofSpring2ConstraintDoubleData2", Needs::kBoth,
                   ""},
};

/// "2 soft bodies", "1 constraint".
std::string Counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

class Checker {
 public:
  Checker(const BulletFile& file, Precision precision, const Dna& reference_dna)
      : file_(file), precision_(precision), blocks_(file, reference_dna), shapes_(blocks_) {}

  CheckedWorld Run();

 private:
  template <class Check>
  void ForEach(std::string_view code, const Check& check) {
    for (Block& block : blocks_.all()) {
      if (block.chunk->code == code) check(block);
    }
  }
  /// "btRigidBodyFloatData" of "btRigidBody", or that in double.
  std::string InPrecision(std::string_view name) const {
    return std::string(name) + (precision_ == Precision::kFloat ? "FloatData" : "DoubleData");
  }

  void CheckWorldInfo(Block& block);
  void CheckBody(Block& block);
  void CheckObject(Block& block);
  // Checks what rigid bodies, static objects and links have in common. False if the shape is not restored.
  bool CheckCommon(const Record& object);
  void CheckConstraint(Block& block);
  bool LinkConstrainedBodies(const Record& base, const ConstraintKind& kind);
  void CheckMultibody(Block& block);
  bool CheckLink(const Record& link, int index);
  void CheckCollider(Block& block);
  void AddRemarks();
  void Remark(const std::string& sentence) { world_.remarks.push_back(sentence); }

  const BulletFile& file_;
  Precision precision_;
  Blocks blocks_;
  ShapeCheck shapes_;
  CheckedWorld world_ = {};
  std::set<const Block*> restored_;    // Bodies and objects that constraints may have.
  std::set<const Block*> missing_;     // ... and those that cannot be restored.
  std::map<const Block*, int> links_;  // Number of links of each restored multibody.
  std::set<std::pair<const Block*, int>> has_collider_;
  int damped_bodies_ = 0;
  int missing_multibodies_ = 0, missing_colliders_ = 0;
  std::map<std::string, int> missing_constraints_;
};

void Checker::CheckWorldInfo(Block& block) {
  const Record world = blocks_.Single(block, InPrecision("btDynamicsWorld"));
  if (!world_.worlds.empty()) world.Fail("it is the second of a world's settings");
  world.Numbers("m_gravity", Limit::kFinite);
  const Record solver = world.Inner("m_solverInfo");
  constexpr std::array kNumbers = {"m_tau",
                                   "m_damping",
                                   "m_friction",
                                   "m_restitution",
                                   "m_maxErrorReduction",
                                   "m_sor",
                                   "m_erp",
                                   "m_erp2",
                                   "m_globalCfm",
                                   "m_splitImpulsePenetrationThreshold",
                                   "m_splitImpulseTurnErp",
                                   "m_linearSlop",
                                   "m_warmstartingFactor",
                                   "m_maxGyroscopicForce"};
  for (const char* path : kNumbers) solver.Numbers(path, Limit::kFinite);
  solver.Numbers("m_singleAxisRollingFrictionThreshold", Limit::kNumber);  // 1e30: never.
  const double step = solver.Numbers("m_timeStep", Limit::kPositive).at(0);
  if (step > kLongestStep) solver.Fail("m_timeStep", "is " + std::to_string(step) + " s");
  solver.Integer("m_numIterations", 0, kMostIterations);
  world_.worlds.push_back(world.address());
}

bool Checker::CheckCommon(const Record& object) {
  object.CheckPose("m_worldTransform");
  constexpr std::array kNotNegative = {"m_friction",         "m_rollingFriction",      "m_contactDamping",
                                       "m_contactStiffness", "m_ccdSweptSphereRadius", "m_ccdMotionThreshold",
                                       "m_deactivationTime"};
  for (const char* path : kNotNegative) {
    // Stiffness is 1e30 by default, which is to say: rigid.
    const bool may_be_endless = std::string_view(path) == "m_contactStiffness";
    object.Numbers(path, may_be_endless ? Limit::kNumber : Limit::kNotNegative);
  }
  object.Numbers("m_restitution", Limit::kFinite);
  object.Numbers("m_anisotropicFriction", Limit::kFinite);
  object.Numbers("m_contactProcessingThreshold", Limit::kNumber);
  object.Integer("m_activationState1", 1, 6);
  object.LinkName("m_name");
  Block* shape = object.Target("m_collisionShape");
  if (shape == nullptr) object.Fail("m_collisionShape", "names no chunk");
  if (!shapes_.IsRestored(*shape)) return false;
  object.Link("m_collisionShape", shape);
  return true;
}

void Checker::CheckBody(Block& block) {
  const Record body = blocks_.Single(block, InPrecision("btRigidBody"));
  const bool is_restored = CheckCommon(body.Inner("m_collisionObjectData"));
  for (const char* path : {"m_inverseMass", "m_invInertiaLocal"}) body.Numbers(path, Limit::kNotNegative);
  constexpr std::array kFinite = {"m_linearVelocity",       "m_angularVelocity", "m_angularFactor", "m_linearFactor",
                                  "m_gravity_acceleration", "m_totalForce",      "m_totalTorque"};
  for (const char* path : kFinite) body.Numbers(path, Limit::kFinite);
  constexpr std::array kNotNegative = {"m_linearDamping",
                                       "m_angularDamping",
                                       "m_additionalDampingFactor",
                                       "m_additionalLinearDampingThresholdSqr",
                                       "m_additionalAngularDampingThresholdSqr",
                                       "m_additionalAngularDampingFactor",
                                       "m_linearSleepingThreshold",
                                       "m_angularSleepingThreshold"};
  for (const char* path : kNotNegative) body.Numbers(path, Limit::kNotNegative);
  (is_restored ? restored_ : missing_).insert(&block);
  if (!is_restored) return;
  world_.bodies.push_back(body.address());
  if (body.Integer("m_additionalDamping") != 0) ++damped_bodies_;
}

void Checker::CheckObject(Block& block) {
  const Record object = blocks_.Single(block, InPrecision("btCollisionObject"));
  const bool is_restored = CheckCommon(object);
  (is_restored ? restored_ : missing_).insert(&block);
  if (is_restored) world_.objects.push_back(object.address());
}

void Checker::CheckConstraint(Block& block) {
  const std::int32_t type = blocks_.Kind(block, InPrecision("btTypedConstraint"), "m_objectType");
  const auto kind = std::ranges::find(kConstraintKinds, type, &ConstraintKind::type);
  if (kind == kConstraintKinds.end()) {
    ++missing_constraints_["is of a type that it does not make"];
    return;
  }
  const Record constraint = blocks_.Single(block, precision_ == Precision::kFloat ? kind->in_float : kind->in_double);
  const Record inner = kind->base.empty() ? constraint : constraint.Inner(kind->base);
  const Record typed = inner.Inner("m_typeConstraintData");
  if (typed.address() != constraint.address()) constraint.Fail("it does not begin as all constraints do");
  for (const Dna::Field& field : block.structure->fields) {
    if (field.name != "m_typeConstraintData") constraint.Numbers(field.name, Limit::kNumber);
  }
  for (const char* frame : {"m_rbAFrame", "m_rbBFrame"}) {
    const auto& fields = file_.dna.Find(inner.structure())->fields;
    if (std::ranges::find(fields, frame, &Dna::Field::name) != fields.end()) inner.CheckPose(frame);
  }
  for (const char* pivot : {"m_pivotInA", "m_pivotInB", "m_axisInA", "m_axisInB"}) {
    const auto& fields = block.structure->fields;
    if (std::ranges::find(fields, pivot, &Dna::Field::name) != fields.end()) constraint.Numbers(pivot, Limit::kFinite);
  }
  if (kind->type == 12) constraint.Integer("m_rotateOrder", 0, 5);
  for (const char* path : {"m_dbgDrawSize", "m_breakingImpulseThreshold"}) typed.Numbers(path, Limit::kNumber);
  typed.Integer("m_overrideNumSolverIterations", -1, kMostIterations);
  typed.LinkName("m_name");
  if (LinkConstrainedBodies(typed, *kind)) world_.constraints.push_back(constraint.address());
}

// A body that is in no chunk is Bullet's own fixed one, which it does not write.
bool Checker::LinkConstrainedBodies(const Record& base, const ConstraintKind& kind) {
  std::array<Block*, 2> bodies{};
  const std::array<const char*, 2> paths = {"m_rbA", "m_rbB"};
  for (std::size_t i = 0; i < 2; ++i) {
    bodies[i] = base.Target(paths[i]);
    if (bodies[i] == nullptr) continue;
    if (missing_.contains(bodies[i])) {
      ++missing_constraints_["has a body that is not restored"];
      return false;
    }
    if (!restored_.contains(bodies[i])) {
      base.Fail(paths[i], "names chunk " + std::to_string(bodies[i]->index) + ", which is no body");
    }
  }
  if (bodies[0] != nullptr && bodies[0] == bodies[1]) base.Fail("m_rbB", "is the same body as m_rbA");
  const bool has_a = bodies[0] != nullptr, has_b = bodies[1] != nullptr;
  const bool is_possible = kind.needs == Needs::kA ? has_a : kind.needs == Needs::kB ? has_b : has_a && has_b;
  if (!is_possible) {
    ++missing_constraints_["is to the world in a way that it does not make"];
    return false;
  }
  for (std::size_t i = 0; i < 2; ++i) base.Link(paths[i], bodies[i]);
  return true;
}

void Checker::CheckMultibody(Block& block) {
  const Record multibody = blocks_.Single(block, InPrecision("btMultiBody"));
  constexpr std::array kFinite = {"m_baseWorldPosition", "m_baseLinearVelocity", "m_baseAngularVelocity"};
  for (const char* path : kFinite) multibody.Numbers(path, Limit::kFinite);
  multibody.CheckQuaternion("m_baseWorldOrientation");
  multibody.Numbers("m_baseInertia", Limit::kNotNegative);
  multibody.Numbers("m_baseMass", Limit::kNotNegative);
  multibody.LinkName("m_baseName");
  const int count = multibody.Integer("m_numLinks", 0, kMostLinks);
  bool is_restored = true;
  if (count > 0) {
    Block& links = multibody.Array("m_links", InPrecision("btMultiBodyLink"), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      const Record link(blocks_, links, static_cast<std::size_t>(i));
      if (!CheckLink(link, i)) is_restored = false;
    }
  }
  if (!is_restored) {
    ++missing_multibodies_;
    return;
  }
  links_[&block] = count;
  world_.multibodies.push_back(multibody.address());
}

bool Checker::CheckLink(const Record& link, int index) {
  link.CheckQuaternion("m_zeroRotParentToThis");
  constexpr std::array kFinite = {"m_parentComToThisPivotOffset", "m_thisPivotToThisComOffset"};
  for (const char* path : kFinite) link.Numbers(path, Limit::kFinite);
  for (const char* path : {"m_linkInertia", "m_linkMass", "m_jointDamping", "m_jointFriction"}) {
    link.Numbers(path, Limit::kNotNegative);
  }
  constexpr std::array kLimits = {"m_jointLowerLimit", "m_jointUpperLimit", "m_jointMaxForce", "m_jointMaxVelocity"};
  for (const char* path : kLimits) link.Numbers(path, Limit::kNumber);
  link.Integer("m_parentIndex", -1, index - 1);
  for (const char* path : {"m_linkName", "m_jointName"}) link.LinkName(path);

  // Revolute, prismatic, spherical, planar and fixed. Bullet writes as much of the axes and of the positions as the
  // joint has, and leaves the rest as it finds it.
  const int type = link.Integer("m_jointType", 0, 4);
  constexpr int kPlanar = 3, kSpherical = 2, kFixed = 4;
  if (type == kPlanar) return false;
  constexpr double kGreatestCoordinate = 1e6;  // rad, m; and of velocities.
  const auto check_first = [&](const char* path, std::size_t count) {
    const std::vector<double> numbers = link.Numbers(path);
    for (std::size_t i = 0; i < count; ++i) {
      if (!(std::abs(numbers[i]) <= kGreatestCoordinate)) link.Fail(path, "is " + std::to_string(numbers[i]));
    }
  };
  const std::size_t freedoms = type == kFixed ? 0 : type == kSpherical ? 3 : 1;
  check_first("m_jointPos", type == kSpherical ? 4 : freedoms);
  check_first("m_jointVel", freedoms);
  check_first("m_jointAxisTop", 3 * freedoms);
  check_first("m_jointAxisBottom", 3 * freedoms);
  return true;
}

void Checker::CheckCollider(Block& block) {
  const Record collider = blocks_.Single(block, InPrecision("btMultiBodyLinkCollider"));
  const bool has_shape = CheckCommon(collider.Inner("m_colObjData"));
  Block* multibody = collider.Target("m_multiBody");
  if (multibody == nullptr || multibody->chunk->code != "MBDY") collider.Fail("m_multiBody", "names no multibody");
  const auto links = links_.find(multibody);
  if (!has_shape || links == links_.end()) {
    ++missing_colliders_;
    return;
  }
  const int link = collider.Integer("m_link", -1, links->second - 1);
  if (!has_collider_.insert({multibody, link}).second) {
    collider.Fail("m_link", "is " + std::to_string(link) + ", which has a collider already");
  }
  collider.Link("m_multiBody", multibody);
  world_.colliders.push_back(collider.address());
}

void Checker::AddRemarks() {
  std::string kinds;
  for (const auto& [kind, count] : shapes_.MissingShapes()) {
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  }
  if (!kinds.empty()) {
    Remark("Bullet's importer does not make these shapes: " + kinds + "; without them, " +
           Counted(static_cast<int>(missing_.size()) + missing_colliders_, "body is", "bodies are") + " left out.");
  }
  for (const auto& [reason, count] : missing_constraints_) {
    Remark(Counted(count, "constraint is", "constraints are") + " left out, which " + reason + ".");
  }
  if (missing_multibodies_ > 0) {
    Remark(Counted(missing_multibodies_, "multibody is", "multibodies are") +
           " left out for a planar joint, which Bullet's importer does not make.");
  }
  if (!world_.multibodies.empty()) {
    Remark("Motors and limits of a multibody's joints are not in such files.");
  }
  if (damped_bodies_ > 0) {
    Remark("The additional damping of " + Counted(damped_bodies_, "body is", "bodies are") +
           " left out, which Bullet takes at construction only.");
  }
  if (shapes_.info_maps() > 0) {
    Remark("The angles of internal edges of " + Counted(shapes_.info_maps(), "mesh is", "meshes are") + " left out.");
  }
  std::map<std::string, int> ignored;
  for (const Block& block : blocks_.all()) {
    constexpr std::array<std::string_view, 10> kUsed = {"SHAP", "DWLD", "RBDY", "COBJ", "CONS",
                                                        "MBDY", "MBLC", "ARAY", "QBVH", "TMAP"};
    if (std::ranges::find(kUsed, block.chunk->code) == kUsed.end()) ++ignored[block.chunk->code];
  }
  for (const auto& [code, count] : ignored) {
    const std::string what = code == "SBDY"                     ? "soft body"
                             : code == "CONT"                   ? "contact manifold"
                             : code == "SBMT" || code == "SBND" ? "part of soft bodies"
                                                                : "chunk of the unknown code " + code;
    Remark("Left out: " + std::to_string(count) + " x " + what + ".");
  }
}

CheckedWorld Checker::Run() {
  if (file_.precision != precision_) {
    throw SceneError(file_.name + ": it was written by a Bullet in " + NameOf(file_.precision) +
                     " precision; this program's Bullet is in " + NameOf(precision_) + ", and the one whose name " +
                     (file_.precision == Precision::kDouble ? "ends" : "does not end") + " in _float64 reads it");
  }
  world_.name = file_.name;
  world_.precision = file_.precision;
  world_.version = file_.version;
  ForEach("DWLD", [&](Block& block) { CheckWorldInfo(block); });
  ForEach("SHAP", [&](Block& block) {
    if (shapes_.IsRestored(block)) world_.shapes.push_back(block.memory.get());
  });
  ForEach("RBDY", [&](Block& block) { CheckBody(block); });
  ForEach("COBJ", [&](Block& block) { CheckObject(block); });
  ForEach("CONS", [&](Block& block) { CheckConstraint(block); });
  ForEach("MBDY", [&](Block& block) { CheckMultibody(block); });
  ForEach("MBLC", [&](Block& block) { CheckCollider(block); });
  AddRemarks();
  for (Block& block : blocks_.all()) world_.memory.push_back(std::move(block.memory));
  return std::move(world_);
}

}  // namespace

CheckedWorld CheckWorld(const BulletFile& file, Precision precision, const Dna& reference_dna) {
  return Checker(file, precision, reference_dna).Run();
}

}  // namespace dgd_demos
