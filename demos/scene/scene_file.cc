#include "scene/scene_file.h"

#include <algorithm>
#include <string>
#include <utility>

#include "scene/json_reader.h"
#include "scene/random_polytope.h"
#include "scene/read_shape.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// What a scene may ask for. Wide enough for anything sensible, narrow enough to catch slips: degrees for radians,
// milliseconds for seconds, a lost decimal point.
constexpr Range kSize = {0, 1e3, /*low_is_allowed=*/false};     // m
constexpr Range kCoordinate = {-1e4, 1e4};                      // m
constexpr Range kMass = {0, 1e6, /*low_is_allowed=*/false};     // kg
constexpr Range kMassOrStatic = {0, 1e6};                       // kg
constexpr Range kInertia = {0, 1e9, /*low_is_allowed=*/false};  // kg m^2
constexpr Range kFriction = {0, 10};
constexpr Range kRestitution = {0, 1};
constexpr Range kDamping = {0, 1};                                        // Of 1, in a second.
constexpr Range kAcceleration = {-1e3, 1e3};                              // m/s^2
constexpr Range kVelocity = {-1e3, 1e3};                                  // m/s
constexpr Range kAngularVelocity = {-1e3, 1e3};                           // rad/s
constexpr Range kTimeStep = {0, kMaxTimeStep, /*low_is_allowed=*/false};  // s
constexpr Range kMargin = {0, 1};                                         // m
constexpr int kMaxCount = 10'000;
constexpr int kMaxSolverIterations = 10'000;

// Bullet's own, where the file says nothing.
constexpr double kDefaultFriction = 0.5;
constexpr double kDefaultRestitution = 0;

double NumberOr(const JsonReader& object, const std::string& key, const Range& range, double otherwise) {
  return object.Has(key) ? object.At(key).Number(range) : otherwise;
}

Ground ReadGround(const JsonReader& ground) {
  ground.AllowOnly({"half_extents", "friction"});
  return {ground.At("half_extents").Vector(kSize), NumberOr(ground, "friction", kFriction, kDefaultFriction)};
}

SolverSettings ReadSolver(const JsonReader& solver) {
  solver.AllowOnly({"iterations", "friction_directions"});
  SolverSettings settings;
  if (solver.Has("iterations")) settings.iterations = solver.At("iterations").Integer(1, kMaxSolverIterations);
  if (solver.Has("friction_directions")) {
    settings.friction_directions = solver.At("friction_directions").Integer(1, 2);
  }
  return settings;
}

// One number for all three axes, or three numbers.
std::optional<Vector3d> ReadInertia(const JsonReader& body) {
  if (!body.Has("inertia")) return std::nullopt;
  const JsonReader inertia = body.At("inertia");
  if (inertia.IsArray()) return inertia.Vector(kInertia);
  return Vector3d::Constant(inertia.Number(kInertia));
}

BodyProperties ReadProperties(const JsonReader& body, const Range& mass) {
  return {body.At("mass").Number(mass), ReadInertia(body), NumberOr(body, "friction", kFriction, kDefaultFriction),
          NumberOr(body, "restitution", kRestitution, kDefaultRestitution), NumberOr(body, "damping", kDamping, 0)};
}

Motion ReadMotion(const JsonReader& body, bool is_static) {
  Motion motion;
  const auto read = [&](const char* key, const Range& range, Vector3d& target) {
    if (!body.Has(key)) return;
    target = body.At(key).Vector(range);
    if (is_static) body.At(key).Fail("a body of mass 0 does not move, but this is " + body.At(key).Dump());
  };
  read("velocity", kVelocity, motion.velocity);
  read("angular_velocity", kAngularVelocity, motion.angular_velocity);
  return motion;
}

RandomPolytopes ReadRandomPolytopes(const JsonReader& group) {
  group.AllowOnly(
      {"type", "mass", "inertia", "friction", "restitution", "damping", "count", "vertices", "diameter", "region"});
  RandomPolytopes polytopes;
  polytopes.properties = ReadProperties(group, kMass);
  polytopes.count = group.At("count").Integer(1, kMaxCount);

  const JsonReader vertices = group.At("vertices");
  vertices.AllowOnly({"min", "max"});
  polytopes.min_vertices = vertices.At("min").Integer(kMinPolytopeVertices, kMaxPolytopeVertices);
  polytopes.max_vertices = vertices.At("max").Integer(polytopes.min_vertices, kMaxPolytopeVertices);

  polytopes.diameter = group.At("diameter").Number(kSize);
  const JsonReader region = group.At("region");
  region.AllowOnly({"min", "max"});
  polytopes.region_min = region.At("min").Vector(kCoordinate);
  polytopes.region_max = region.At("max").Vector(kCoordinate);
  if ((polytopes.region_max - polytopes.region_min).minCoeff() < 0) {
    region.Fail("max must not be below min, as in " + region.Dump());
  }
  return polytopes;
}

SingleBody ReadSingleBody(const JsonReader& body, const std::string& type, const std::filesystem::path& folder) {
  // First: it knows which keys are allowed.
  const Shape shape = ReadShape(
      body, folder,
      {"mass", "inertia", "friction", "restitution", "damping", "position", "rotation", "velocity", "angular_velocity"},
      "random_polytopes, ");
  const BodyProperties properties = ReadProperties(body, kMassOrStatic);
  return {properties, type, shape, ReadPose(body), ReadMotion(body, properties.mass == 0)};
}

BodyGroup ReadBodyGroup(const JsonReader& group, const std::filesystem::path& folder) {
  const std::string type = group.At("type").Text();
  if (type == "random_polytopes") return ReadRandomPolytopes(group);
  return ReadSingleBody(group, type, folder);
}

std::vector<double> ReadSnapshots(const JsonReader& times, double duration) {
  std::vector<double> snapshots;
  for (std::size_t i = 0; i < times.Size(); ++i) {
    const double earliest = snapshots.empty() ? 0 : snapshots.back();
    snapshots.push_back(times.At(i).Number({earliest, duration}));
  }
  return snapshots;
}

// A value may be new where its object is there; elsewhere it must have been there before.
void Change(nlohmann::json& document, const std::string& path, const nlohmann::json& value, const std::string& file) {
  using Pointer = nlohmann::json::json_pointer;
  const auto fail = [&](const char* what) {
    throw SceneError(file + ": " + path + ": " + what + ", and cannot be changed to " + value.dump());
  };
  Pointer pointer;
  try {
    pointer = Pointer(path);
  } catch (const nlohmann::json::exception&) {
    fail("is no JSON path, as /bodies/0/friction is");
  }
  if (pointer.empty()) fail("is the whole scene");
  const bool is_new = !document.contains(pointer);
  if (is_new && !(document.contains(pointer.parent_pointer()) && document.at(pointer.parent_pointer()).is_object())) {
    fail("is not in the scene");
  }
  document[pointer] = value;
}

}  // namespace

Scene LoadScene(const std::filesystem::path& file, const SceneChanges& changes) {
  nlohmann::json document = ParseJsonFile(file);
  for (const auto& [path, value] : changes) Change(document, path, value, file.string());
  Scene scene;
  scene.file = file.string();
  const JsonReader root(scene.file, document);
  if (root.Has("arms")) root.At("arms").Fail("is of a scene for plan_motion, in which arms move and nothing falls");
  root.AllowOnly(
      {"about", "gravity", "time_step", "duration", "margin", "ground", "sleeping", "solver", "bodies", "snapshots"});

  scene.about = root.At("about").Text();
  scene.gravity = root.At("gravity").Vector(kAcceleration);
  scene.time_step = root.At("time_step").Number(kTimeStep);
  scene.duration = root.At("duration").Number({scene.time_step, kMaxDuration});
  scene.margin = root.At("margin").Number(kMargin);
  scene.ground = ReadGround(root.At("ground"));
  if (root.Has("solver")) scene.solver = ReadSolver(root.At("solver"));
  if (root.Has("sleeping")) scene.sleeping = root.At("sleeping").Boolean();

  const JsonReader bodies = root.At("bodies");
  for (std::size_t i = 0; i < bodies.Size(); ++i) {
    scene.bodies.push_back(ReadBodyGroup(bodies.At(i), file.parent_path()));
  }
  if (scene.bodies.empty()) bodies.Fail("must hold at least one body, not " + bodies.Dump());
  if (root.Has("snapshots")) scene.snapshots = ReadSnapshots(root.At("snapshots"), scene.duration);
  return scene;
}

}  // namespace dgd_demos
