#include "sweep/study.h"

#include <algorithm>
#include <set>
#include <variant>

#include "scene/json_reader.h"
#include "scene/scene_error.h"
#include "scene_options.h"
#include "world_file/bullet_file.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

constexpr int kMaxSeed = 1'000'000'000;
constexpr int kMaxSeeds = 100'000;
constexpr Range kTimeStep = {0, kMaxTimeStep, /*low_is_allowed=*/false};  // s
constexpr std::size_t kMaxRuns = 1'000'000;

// What is there twice would count as two samples of a median.
template <class Value>
void FailAtRepetition(const std::vector<Value>& values, const JsonReader& array) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::ranges::count(values, values[i]) > 1) array.At(i).Fail("is there twice, " + array.At(i).Dump());
  }
}

// [1, 2, 5], or { "from": 1, "to": 20 }.
std::vector<std::uint64_t> ReadSeeds(const JsonReader& seeds) {
  std::vector<std::uint64_t> list;
  if (seeds.IsArray()) {
    for (std::size_t i = 0; i < seeds.Size(); ++i) list.push_back(std::uint64_t(seeds.At(i).Integer(0, kMaxSeed)));
    if (list.empty()) seeds.Fail("must hold at least one seed");
    FailAtRepetition(list, seeds);
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
  FailAtRepetition(texts, array);
  if (texts.empty()) array.Fail("must hold at least one entry");
  return texts;
}

// An object of lists is a grid, all combinations of their entries; an array of objects is a list of combinations.
std::vector<SceneChanges> ReadVariations(const JsonReader& vary, const json& document) {
  if (vary.IsArray()) {
    std::vector<SceneChanges> list;
    for (std::size_t i = 0; i < vary.Size(); ++i) {
      SceneChanges& changes = list.emplace_back();
      for (const std::string& path : vary.At(i).Keys()) changes.emplace_back(path, document[i].at(path));
    }
    if (list.empty()) vary.Fail("must hold at least one entry");
    FailAtRepetition(list, vary);
    return list;
  }
  std::vector<SceneChanges> grid(1);
  for (const std::string& path : vary.Keys()) {
    const JsonReader values = vary.At(path);
    if (values.Size() == 0) values.Fail("must hold at least one value");
    FailAtRepetition(document.at(path).get<std::vector<json>>(), values);
    std::vector<SceneChanges> finer;
    for (const SceneChanges& coarse : grid) {
      for (const json& value : document.at(path)) {
        finer.push_back(coarse);
        finer.back().emplace_back(path, value);
        if (finer.size() > kMaxRuns) vary.Fail("has more than " + std::to_string(kMaxRuns) + " combinations");
      }
    }
    grid = std::move(finer);
  }
  return grid;
}

// Reads the world, so that what is wrong with it shows.
bool HasRandomBodies(const std::filesystem::path& world, const SceneChanges& changes) {
  if (IsWorldFile(world)) {
    if (!changes.empty()) {
      throw SceneError(world.string() + ": " + changes.front().first + ": is of scenes, and this is a world file");
    }
    ReadBulletFile(world);
    return false;
  }
  return std::ranges::any_of(LoadScene(world, changes).bodies,
                             [](const BodyGroup& group) { return std::holds_alternative<RandomPolytopes>(group); });
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

  std::vector<std::string> precisions = {own_precision};
  if (root.Has("narrowphases")) study.narrowphases = ReadTexts(root.At("narrowphases"));
  if (root.Has("precisions")) {
    precisions = ReadTexts(root.At("precisions"));
    for (std::size_t i = 0; i < precisions.size(); ++i) {
      if (precisions[i] != "float" && precisions[i] != "double") {
        root.At("precisions").At(i).Fail("must be float or double, not " + precisions[i]);
      }
    }
  }
  std::vector<std::uint64_t> seeds = {1};
  if (root.Has("seeds")) seeds = ReadSeeds(root.At("seeds"));
  std::vector<SceneChanges> variations(1);
  if (root.Has("vary")) variations = ReadVariations(root.At("vary"), study.document.at("vary"));
  std::optional<double> duration, time_step;
  if (root.Has("time_step")) time_step = root.At("time_step").Number(kTimeStep);
  if (root.Has("duration")) duration = root.At("duration").Number({0, kMaxDuration, /*low_is_allowed=*/false});
  int oracle_every = 1;
  if (root.Has("oracle_every")) oracle_every = root.At("oracle_every").Integer(1, kMaxOracleEvery);

  std::set<std::string> varied;
  for (const SceneChanges& changes : variations) {
    for (const auto& [path, value] : changes) varied.insert(path);
  }
  study.varied.assign(varied.begin(), varied.end());
  for (const char* key : {"duration", "time_step"}) {
    if (root.Has(key) && varied.contains(std::string("/") + key)) root.At(key).Fail("is varied as well; leave one out");
  }

  const std::vector<std::string> worlds = ReadTexts(root.At("worlds"));
  for (const std::string& world : worlds) {
    const std::filesystem::path path = file.parent_path() / world;
    for (const SceneChanges& changes : variations) {
      // Seeds differ in random bodies alone.
      const std::size_t runs_of_it = HasRandomBodies(path, changes) ? seeds.size() : 1;
      for (std::size_t s = 0; s < runs_of_it; ++s) {
        for (const std::string& narrowphase : study.narrowphases) {
          for (const std::string& precision : precisions) {
            const int number = static_cast<int>(study.runs.size());
            study.runs.push_back({number, world, path.string(), changes, seeds[s], narrowphase, precision, duration,
                                  time_step, oracle_every});
          }
        }
      }
      if (study.runs.size() > kMaxRuns) root.Fail("has more than " + std::to_string(kMaxRuns) + " runs");
    }
  }
  return study;
}

}  // namespace dgd_demos
