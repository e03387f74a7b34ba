#include "sweep/study.h"

#include <algorithm>
#include <set>
#include <variant>

#include "run/run_options.h"
#include "scene/json_reader.h"
#include "scene_options.h"
#include "sweep/variations.h"
#include "world_file/bullet_file.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

constexpr int kMaxSeed = 1'000'000'000;
constexpr int kMaxSeeds = 100'000;
constexpr Range kTimeStep = {0, kMaxTimeStep, /*low_is_allowed=*/false};  // s
constexpr std::size_t kMaxRuns = 1'000'000;

// What all worlds of a study have in common.
struct Plan {
  std::vector<std::string> precisions;
  std::vector<std::uint64_t> seeds = {1};
  std::vector<Variation> variations;
  std::optional<double> duration, time_step;  // s
  int oracle_every = 1;                       // Steps.
};

// [1, 2, 5], or { "from": 1, "to": 20 }.
std::vector<std::uint64_t> ReadSeeds(const JsonReader& seeds) {
  std::vector<std::uint64_t> list;
  if (seeds.IsArray()) {
    for (std::size_t i = 0; i < seeds.Size(); ++i) list.push_back(std::uint64_t(seeds.At(i).Integer(0, kMaxSeed)));
    if (list.empty()) seeds.Fail("must hold at least one seed");
    seeds.ExpectDistinct();  // A seed that is there twice would count as two samples of a median.
    return list;
  }
  seeds.AllowOnly({"from", "to"});
  const int from = seeds.At("from").Integer(0, kMaxSeed);
  const int to = seeds.At("to").Integer(from, std::min(kMaxSeed, from + kMaxSeeds));
  for (int seed = from; seed <= to; ++seed) list.push_back(std::uint64_t(seed));
  return list;
}

std::vector<std::string> ReadTexts(const JsonReader& array) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < array.Size(); ++i) {
    texts.push_back(array.At(i).Text());
  }
  array.ExpectDistinct();
  if (texts.empty()) array.Fail("must hold at least one entry");
  return texts;
}

std::vector<std::string> ReadPrecisions(const JsonReader& array) {
  std::vector<std::string> precisions = ReadTexts(array);
  for (std::size_t i = 0; i < precisions.size(); ++i) {
    if (precisions[i] != "float" && precisions[i] != "double") {
      array.At(i).Fail("must be float or double, not " + precisions[i]);
    }
  }
  return precisions;
}

Plan ReadPlan(const JsonReader& root, const std::string& own_precision) {
  Plan plan;
  plan.precisions = {own_precision};
  if (root.Has("precisions")) plan.precisions = ReadPrecisions(root.At("precisions"));
  if (root.Has("seeds")) plan.seeds = ReadSeeds(root.At("seeds"));
  if (root.Has("vary")) {
    plan.variations = ReadVariations(root.At("vary"), kMaxRuns);
  } else {
    plan.variations.push_back({{}, {}, root});
  }
  if (root.Has("time_step")) plan.time_step = root.At("time_step").Number(kTimeStep);
  if (root.Has("duration")) plan.duration = root.At("duration").Number({0, kMaxDuration, /*low_is_allowed=*/false});
  if (root.Has("oracle_every")) plan.oracle_every = root.At("oracle_every").Integer(1, kMaxOracleEvery);
  return plan;
}

// JSON paths in alphabetical order.
std::vector<std::string> VariedPaths(const std::vector<Variation>& variations) {
  std::set<std::string> paths;
  for (const Variation& variation : variations) {
    for (const auto& [path, value] : variation.changes) paths.insert(path);
  }
  return {paths.begin(), paths.end()};
}

std::filesystem::path FileOf(const JsonReader& world, const std::filesystem::path& folder) {
  const std::filesystem::path name = world.Text();
  if (!IsSceneName(name)) return folder / name;
  const std::filesystem::path file = WorldFileNamed(name);
  if (file == name) world.Fail(world.Dump() + ": " + kNoSuchScene);
  return file;
}

// The runs of a study, world by world. Each world is read, so that a slip shows before the first run.
class RunList {
 public:
  RunList(const JsonReader& root, const Plan& plan, Study& study) : root_(root), plan_(plan), study_(study) {}

  void Add(const JsonReader& world);

 private:
  void CheckTimes(const JsonReader& world, double own_duration, double own_time_step) const;
  void CheckWorldFile(const std::filesystem::path& file, const JsonReader& world) const;
  bool HasRandomBodies(const std::filesystem::path& file, const JsonReader& world, const Variation& variation) const;

  const JsonReader& root_;
  const Plan& plan_;
  Study& study_;
};

// Refuses a duration below the time step or of too many of them, where the study has one and the world the other.
void RunList::CheckTimes(const JsonReader& world, double own_duration, double own_time_step) const {
  const json duration = plan_.duration.value_or(own_duration), time_step = plan_.time_step.value_or(own_time_step);
  if (own_time_step > 0 && duration.get<double>() / time_step.get<double>() > kMaxSteps) {
    root_.At(plan_.time_step ? "time_step" : "duration")
        .Fail("makes too many steps of " + world.Text() + ": " + duration.dump() + " s of " + time_step.dump() + " s");
  }
  if (duration >= time_step) return;
  if (plan_.duration) {
    root_.At("duration")
        .Fail("must be at least a time step of " + world.Text() + ", " + time_step.dump() + " s, and is " +
              duration.dump());
  }
  root_.At("time_step")
      .Fail("must be at most the duration of " + world.Text() + ", " + duration.dump() + " s, and is " +
            time_step.dump());
}

void RunList::CheckWorldFile(const std::filesystem::path& file, const JsonReader& world) const {
  const std::string written_in = NameOf(ReadBulletFile(file).precision);
  for (const Variation& variation : plan_.variations) {
    if (variation.changes.empty()) continue;
    variation.places.front().Fail("is a value of scenes, and " + world.Text() + " is a world file");
  }
  for (const std::string& precision : plan_.precisions) {
    if (precision == written_in) continue;
    world.Fail(world.Text() + " was written by a Bullet in " + written_in + " and cannot run in " + precision +
               "; \"precisions\" must be [\"" + written_in + "\"]");
  }
  CheckTimes(world, kMaxDuration, 0);  // The file's own time step is for Bullet's importer to read.
}

bool RunList::HasRandomBodies(const std::filesystem::path& file, const JsonReader& world,
                              const Variation& variation) const {
  const Scene scene = LoadVariedScene(file, variation);
  CheckTimes(world, scene.duration, scene.time_step);
  return std::ranges::any_of(scene.bodies,
                             [](const BodyGroup& group) { return std::holds_alternative<RandomPolytopes>(group); });
}

void RunList::Add(const JsonReader& world) {
  const std::filesystem::path file = FileOf(world, std::filesystem::path(study_.file).parent_path());
  const bool is_scene = !IsWorldFile(file);
  if (!is_scene) CheckWorldFile(file, world);
  for (const Variation& variation : plan_.variations) {
    // Seeds differ in random bodies alone.
    const bool has_seeds = is_scene && HasRandomBodies(file, world, variation);
    for (std::size_t s = 0; s < (has_seeds ? plan_.seeds.size() : 1); ++s) {
      for (const std::string& narrowphase : study_.narrowphases) {
        for (const std::string& precision : plan_.precisions) {
          const int number = static_cast<int>(study_.runs.size());
          study_.runs.push_back({number, world.Text(), file.string(), variation.changes, plan_.seeds[s], narrowphase,
                                 precision, plan_.duration, plan_.time_step, plan_.oracle_every});
        }
      }
    }
    if (study_.runs.size() > kMaxRuns) root_.Fail("has more than " + std::to_string(kMaxRuns) + " runs");
  }
}

}  // namespace

json RunSpec::ToJson() const {
  json changed = json::array();
  for (const auto& [path, value] : changes) changed.push_back({path, value});
  json object = {{"number", number},       {"world", world},
                 {"file", file},           {"changes", changed},
                 {"seed", seed},           {"narrowphase", narrowphase},
                 {"precision", precision}, {"oracle_every", oracle_every}};
  if (duration) object["duration"] = *duration;
  if (time_step) object["time_step"] = *time_step;
  return object;
}

RunSpec RunSpec::FromJson(const json& object) {
  RunSpec spec{object.at("number"), object.at("world"),       object.at("file"),      {},
               object.at("seed"),   object.at("narrowphase"), object.at("precision"), std::nullopt,
               std::nullopt,        object.at("oracle_every")};
  for (const json& change : object.at("changes")) spec.changes.emplace_back(change.at(0), change.at(1));
  if (object.contains("duration")) spec.duration = object.at("duration").get<double>();
  if (object.contains("time_step")) spec.time_step = object.at("time_step").get<double>();
  return spec;
}

Study LoadStudy(const std::filesystem::path& file, const std::string& own_precision) {
  Study study{file.string(), ParseJsonFile(file), {"builtin", "dgd"}, {}, {}};
  const JsonReader root(study.file, study.document);
  root.AllowOnly(
      {"about", "worlds", "narrowphases", "precisions", "seeds", "vary", "duration", "time_step", "oracle_every"});
  root.At("about").Text();
  if (root.Has("narrowphases")) study.narrowphases = ReadTexts(root.At("narrowphases"));
  const Plan plan = ReadPlan(root, own_precision);
  study.varied = VariedPaths(plan.variations);
  for (const std::string key : {"duration", "time_step"}) {
    if (root.Has(key) && std::ranges::count(study.varied, "/" + key) > 0) {
      root.At(key).Fail("is varied as well; leave one out");
    }
  }
  const JsonReader worlds = root.At("worlds");
  ReadTexts(worlds);
  RunList runs(root, plan, study);
  for (std::size_t i = 0; i < worlds.Size(); ++i) runs.Add(worlds.At(i));
  return study;
}

}  // namespace dgd_demos
