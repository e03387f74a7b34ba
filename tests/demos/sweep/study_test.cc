// Contract: a study is the list of its runs, the same on every machine; a slip in it, or in a scene of it, shows before
// the first run, with file, path and value.
#include "sweep/study.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "scene/scene_error.h"
#include "small_scenes.h"
#include "sweep/run_record.h"
#include "sweep/study_folder.h"
#include "sweep/study_report.h"

namespace dgd_demos {
namespace {

constexpr const char* kRandomGroup =
    R"({ "type": "random_polytopes", "count": 2, "vertices": { "min": 8, "max": 20 }, "diameter": 0.5,
         "region": { "min": [-1, -1, 1], "max": [1, 1, 4] }, "mass": 1 })";

class StudyTest : public testing::Test {
 protected:
  StudyTest() {
    std::string text = ValidSceneText();
    folder_.Write("box.json", text);
    const std::size_t start = text.find("{ \"type\"");
    text.replace(start, text.find("}\n  ]") + 1 - start, kRandomGroup);
    folder_.Write("random.json", text);
  }

  Study Load(const std::string& text) const { return LoadStudy(folder_.Write("study.json", text), "float"); }
  std::string ErrorOf(const std::string& text) const {
    try {
      Load(text);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no error";
  }

  TestFolder folder_;
};

TEST_F(StudyTest, Grid_HasAllCombinationsInOrder) {
  const Study study = Load(R"({ "about": "a", "worlds": ["box.json", "random.json"], "seeds": [4, 7],
      "narrowphases": ["builtin", "dgd:patch_size=2"], "vary": { "/time_step": [0.002, 0.004], "/margin": [0.01] },
      "duration": 0.1, "oracle_every": 3 })");
  ASSERT_EQ(study.runs.size(), 4U + 8U) << "a scene without random bodies has one seed";
  EXPECT_EQ(study.varied, (std::vector<std::string>{"/margin", "/time_step"}));
  const RunSpec& run = study.runs[9];
  EXPECT_EQ(run.number, 9);
  EXPECT_EQ(run.world, "random.json");
  EXPECT_EQ(run.changes, (SceneChanges{{"/margin", 0.01}, {"/time_step", 0.004}}));
  EXPECT_EQ(run.seed, 4U);
  EXPECT_EQ(run.narrowphase, "dgd:patch_size=2");
  EXPECT_EQ(run.precision, "float");
  EXPECT_EQ(run.duration, 0.1);
  EXPECT_EQ(run.oracle_every, 3);
  EXPECT_EQ(RunSpec::FromJson(run.ToJson()).ToJson(), run.ToJson());
}

TEST_F(StudyTest, List_HasItsEntries) {
  const Study study = Load(R"({ "about": "a", "worlds": ["box.json"], "narrowphases": ["dgd"],
      "precisions": ["float", "double"], "vary": [ { "/bodies/0/friction": 0.1 }, { "/time_step": 0.001 } ] })");
  ASSERT_EQ(study.runs.size(), 4U);
  EXPECT_EQ(study.runs[1].precision, "double");
  EXPECT_EQ(study.runs[2].changes, (SceneChanges{{"/time_step", 0.001}}));
}

TEST_F(StudyTest, Slips_AreNamed) {
  const auto with = [](const std::string& more) { return R"({ "about": "a", "worlds": ["box.json"], )" + more + "}"; };
  for (const auto& [more, complaint] : std::vector<std::pair<std::string, std::string>>{
           {R"("sedes": [1])", "/sedes: is not a known key"},
           {R"("seeds": [])", "/seeds: must hold at least one seed"},
           {R"("seeds": { "from": 5, "to": 4 })", "/seeds/to: must be from 5"},
           {R"("seeds": [1.5])", "/seeds/0: must be an integer, not 1.5"},
           {R"("precisions": ["half"])", "/precisions/0: must be float or double, not half"},
           {R"("narrowphases": ["dgd", "dgd"])", "/narrowphases/0: is there twice"},
           {R"("vary": { "/bodies/7/mass": [1] })", "box.json: /bodies/7/mass: is not in the scene"},
           {R"("vary": { "/bodies/9": [1] })", "box.json: /bodies/9: is not in the scene"},
           {R"("vary": { "mass": [1] })", "box.json: mass: is no JSON path"},
           {R"("vary": { "": [1] })", "is the whole scene"},
           {R"("vary": { "/time_step": [] })", "must hold at least one value"},
           {R"("seeds": [1, 2, 1])", "/seeds/0: is there twice"},
           {R"("vary": { "/time_step": [0.004, 0.0040] })", "/vary/~1time_step/0: is there twice"},
           {R"("time_step": 0.004, "vary": { "/time_step": [0.002] })", "/time_step: is varied as well"},
           {R"("vary": 3)", "/vary: must be an object"},
           {R"("duration": 0)", "/duration: must be above 0"},
           {R"("oracle_every": 0)", "/oracle_every: must be from 1"}}) {
    EXPECT_NE(ErrorOf(with(more)).find(complaint), std::string::npos) << more << " gives: " << ErrorOf(with(more));
  }
  EXPECT_NE(ErrorOf(R"({ "worlds": ["box.json"] })").find("study.json: /about: is missing"), std::string::npos);
  EXPECT_NE(ErrorOf(R"({ "about": "a", "worlds": ["nowhere.json"] })").find("nowhere.json"), std::string::npos);
  EXPECT_NE(ErrorOf(R"({ "about": "a", "worlds": ["box.json", "nowhere"] })")
                .find("study.json: /worlds/1: \"nowhere\": there is no such scene; `headless_sim list`"),
            std::string::npos);
  EXPECT_NE(ErrorOf(R"({ "about": "a", "worlds": [] })").find("/worlds: must hold"), std::string::npos);
}

// The study's place comes first, then what the scene says of the value.
TEST_F(StudyTest, SlipOfAVariedValue_NamesStudyPlaceAndScene) {
  const std::string study = (folder_.path() / "study.json").string(), box = (folder_.path() / "box.json").string();
  for (const auto& [vary, place, complaint] : std::vector<std::tuple<std::string, std::string, std::string>>{
           {R"({ "/time_step": [0.004, -1] })", "/vary/~1time_step/1", "/time_step: must be above 0"},
           {R"({ "/timestep": [0.1] })", "/vary/~1timestep/0", "/timestep: is not a known key"},
           {R"({ "/margin": [0.01], "/time_step": [0.002, -1] })", "/vary/~1time_step/1",
            "/time_step: must be above 0"},
           {R"([ { "/margin": 0.01 }, { "/margin": 0.01, "/bodies/9": 1 } ])", "/vary/1/~1bodies~19",
            "/bodies/9: is not in the scene"},
           {R"({ "/margin": [-1], "/time_step": [-1] })", "/vary", "/time_step: must be above 0"}}) {
    const std::string error = ErrorOf(R"({ "about": "a", "worlds": ["box.json"], "vary": )" + vary + "}");
    EXPECT_EQ(error.find(study + ": " + place + ": " + box + ": " + complaint), 0U) << error;
  }
  folder_.Write("bad.json", "{}");
  const std::string error = ErrorOf(R"({ "about": "a", "worlds": ["bad.json"], "vary": { "/margin": [0.01] } })");
  EXPECT_EQ(error.find((folder_.path() / "bad.json").string() + ": /"), 0U) << "not of the study's: " << error;
}

TEST_F(StudyTest, DurationBelowATimeStepOrOfTooMany_IsRefused) {
  const auto with = [](const std::string& more) { return R"({ "about": "a", "worlds": ["box.json"], )" + more + "}"; };
  const std::string refused = "study.json: /duration: must be at least a time step of box.json, ";
  for (const auto& [more, complaint] : std::vector<std::pair<std::string, std::string>>{
           {R"("duration": 0.003)", refused + "0.004 s, and is 0.003"},
           {R"("duration": 3600, "time_step": 1e-6)",
            "study.json: /time_step: makes too many steps of box.json: 3600.0 s of 1e-06 s"},
           {R"("duration": 0.01, "time_step": 0.02)", refused + "0.02 s, and is 0.01"},
           {R"("duration": 0.01, "vary": { "/time_step": [0.005, 0.02] })", refused + "0.02 s, and is 0.01"},
           {R"("time_step": 0.02, "vary": [ { "/duration": 0.01, "/snapshots": [] } ])",
            "study.json: /time_step: must be at most the duration of box.json, 0.01 s, and is 0.02"}}) {
    EXPECT_NE(ErrorOf(with(more)).find(complaint), std::string::npos) << more << " gives: " << ErrorOf(with(more));
  }
  EXPECT_EQ(ErrorOf(with(R"("duration": 0.004)")), "no error");
}

RunRecord ExampleRecord(int number) {
  RunRecord record{number, RunRecord::Status::kDone, "", "Release", {}};
  for (std::size_t i = 0; i < Figures().size(); ++i) record.figures.push_back(0.1 * static_cast<double>(i + 1));
  return record;
}

TEST_F(StudyTest, Record_ReadsBackToTheBit) {
  RunRecord record = ExampleRecord(12);
  record.status = RunRecord::Status::kLost;
  record.message = "a \"quoted\", broken\nsentence \xff";
  record.figures[0] = 1.0 / 3;
  record.figures[3] = kNone;
  record.figures[4] = kNever;
  const std::string line = ToLine(record);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const RunRecord read = ParseRunRecord(line);
  EXPECT_EQ(read.number, 12);
  EXPECT_EQ(read.status, record.status);
  EXPECT_EQ(read.figures[0], record.figures[0]);
  EXPECT_TRUE(std::isnan(read.figures[3]));
  EXPECT_EQ(read.figures[4], kNever);
  EXPECT_EQ(ToLine(read), ToLine(ParseRunRecord(ToLine(read))));
  for (const char* damaged : {"", "{", "[]", "{\"run\": 1}", "null"}) {
    EXPECT_THROW(ParseRunRecord(damaged), std::runtime_error) << damaged;
  }
}

TEST_F(StudyTest, Folder_KeepsRecordsAndKnowsItsStudy) {
  const std::string text = R"({ "about": "a", "worlds": ["box.json"] })";
  const Study study = Load(text);
  const std::filesystem::path out = folder_.path() / "out";
  {
    const StudyFolder folder(out, study);
    EXPECT_TRUE(folder.ReadRecords().empty());
    folder.Write(ExampleRecord(1));
    folder_.Write("out/runs/000000.json.part", "{\"run\"");  // Of one that died.
  }
  const StudyFolder again(out, study);
  EXPECT_EQ(again.ReadRecords().size(), 1U);
  EXPECT_TRUE(again.ReadRecords().contains(1));
  EXPECT_THROW(StudyFolder(out, LoadStudy(folder_.path() / "study.json", "double")), std::runtime_error);
  EXPECT_THROW(StudyFolder(out, Load(R"({ "about": "b", "worlds": ["box.json"] })")), std::runtime_error);

  folder_.Write("out/runs/000000.json", "{\"run\"");
  EXPECT_THROW(again.ReadRecords(), std::runtime_error) << "damaged, and not taken for whole";
  std::string changed = ValidSceneText();
  changed.insert(changed.find("\"about\": \"") + 10, "another ");
  folder_.Write("box.json", changed);
  EXPECT_THROW(StudyFolder(out, Load(text)), std::runtime_error) << "its world has changed";
}

TEST_F(StudyTest, CsvAndTables_HaveWhatIsDoneInTheStudysOrder) {
  const Study study = Load(R"({ "about": "a", "worlds": ["random.json"], "seeds": [1, 2, 3],
      "narrowphases": ["builtin", "dgd:patch_size=2,warm_start=off"] })");
  std::map<int, RunRecord> records;
  for (const int number : {5, 0, 2, 1}) records.emplace(number, ExampleRecord(number));
  records[2].figures[1] = 0.5;
  records[3] = {3, RunRecord::Status::kFailed, "ended, by signal 11", "", {}};
  const std::string csv = StudyCsv(study, records);
  EXPECT_EQ(csv.substr(0, csv.find(",deepest")), "run,world,seed,narrowphase,precision,build_type,status,message");
  EXPECT_NE(csv.find("\n0,random.json,1,builtin,float,Release,done,,0.1"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n3,random.json,2,\"dgd:patch_size=2,warm_start=off\",float,,failed,\"ended, by signal 11\",,,"),
            std::string::npos)
      << csv;
  EXPECT_LT(csv.find("\n2,"), csv.find("\n5,"));

  const std::string tables = StudyTables(study, records);
  EXPECT_NE(tables.find("random.json, Bullet in float, median of 2 runs, 1 run not done yet\n"), std::string::npos)
      << tables;
  EXPECT_NE(tables.find("[1] dgd:patch_size=2,warm_start=off\n"), std::string::npos) << tables;
  EXPECT_NE(tables.find("run 3, seed 2, dgd:patch_size=2,warm_start=off: failed: ended, by signal 11\n"),
            std::string::npos);
  EXPECT_NE(tables.find("IQR"), std::string::npos);
  EXPECT_NE(tables.find("35.000      15.000"), std::string::npos) << "median and IQR of 0.2 and 0.5 m\n" << tables;
}

}  // namespace
}  // namespace dgd_demos
