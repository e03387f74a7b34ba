// Contract: results of another run are not replaced without a word, and nothing is written through a link.
#include "report/output_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "checkpoint/continued_file.h"
#include "report/whole_file.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

class OutputFolderTest : public testing::Test {
 protected:
  // What is wrong with it; empty if it is granted.
  std::string Claim(int seed, bool replaces_others = false) {
    testing::internal::CaptureStderr();
    std::string complaint;
    try {
      ClaimFolder(
          {Path("out"), "run.json", {{"--seed", seed}}, [](const std::string& name) { return name == "a.csv"; }},
          replaces_others);
    } catch (const std::runtime_error& error) {
      complaint = error.what();
    }
    words_ = testing::internal::GetCapturedStderr();
    return complaint;
  }
  std::filesystem::path Path(const std::string& name) const { return folder_.path() / name; }
  void Write(const std::string& name) const { folder_.Write("out/" + name, name); }
  bool Exists(const std::string& name) const { return std::filesystem::exists(Path("out/" + name)); }

  TestFolder folder_;
  std::string words_;
};

TEST_F(OutputFolderTest, SameRun_HasItAgain) {
  EXPECT_EQ(Claim(1), "");
  Write("a.csv");
  EXPECT_EQ(Claim(1), "");
  EXPECT_EQ(words_, "");
  EXPECT_TRUE(Exists("a.csv"));
}

TEST_F(OutputFolderTest, AnotherRun_IsNamedAndReplacedOnRequest) {
  Claim(1);
  Write("a.csv");
  Write("notes.csv");
  const std::string had = Path("out").string() + ": ha";
  EXPECT_EQ(Claim(2), had +
                          "s the results of another run, with --seed 1, not 2; choose another folder with --out, or "
                          "replace what is there with --overwrite");
  EXPECT_TRUE(Exists("a.csv"));
  EXPECT_EQ(Claim(2, true), "");
  EXPECT_EQ(words_, had + "d the results of another run, with --seed 1, not 2; replaced\n");
  EXPECT_FALSE(Exists("a.csv")) << "it is not of this run";
  EXPECT_TRUE(Exists("notes.csv")) << "the user's";
  EXPECT_EQ(Claim(2), "");
}

TEST_F(OutputFolderTest, FilesWithoutALabel_AreAnothers) {
  std::filesystem::create_directory(Path("out"));
  Write("notes.csv");
  EXPECT_EQ(Claim(1), "") << "in nobody's way";
  std::filesystem::remove(Path("out/run.json"));
  std::filesystem::create_symlink("nowhere", Path("out/a.csv"));
  EXPECT_NE(Claim(1).find(": has a.csv, and no run.json; "), std::string::npos);
  EXPECT_EQ(Claim(1, true), "");
  EXPECT_FALSE(std::filesystem::is_symlink(Path("out/a.csv")));

  for (const std::string label : {"", "{", "[]", "\"a\""}) {
    folder_.Write("out/run.json", label);
    EXPECT_NE(Claim(1).find(": has a run.json that is damaged; "), std::string::npos) << label;
  }
  folder_.Write("out/run.json", std::string(100'000, '['));
  EXPECT_NE(Claim(1), "");
}

TEST_F(OutputFolderTest, CreatedFile_TakesThePlaceOfAFileAndOfNothingElse) {
  const std::filesystem::path file = folder_.Write("a.csv", "old");
  std::filesystem::create_hard_link(file, Path("kept.csv"));
  std::FILE* stream = CreateFile(file);
  ASSERT_NE(stream, nullptr);
  std::fputs("new", stream);
  std::fclose(stream);
  EXPECT_EQ(ReadFile(file), "new");
  EXPECT_EQ(ReadFile(Path("kept.csv")), "old");

  std::filesystem::create_symlink(Path("kept.csv"), Path("link.csv"));
  std::filesystem::create_symlink("nowhere", Path("dangling.csv"));
  ASSERT_EQ(mkfifo(Path("pipe.csv").c_str(), 0600), 0);
  for (const char* name : {"link.csv", "dangling.csv", "pipe.csv"}) {
    EXPECT_THROW(CreateFile(Path(name)), std::runtime_error) << name;
    EXPECT_EQ(OpenFile(Path(name), OpenMode::kContinue), nullptr) << name;
  }
  EXPECT_EQ(CreateFile(folder_.path()), nullptr);
  EXPECT_EQ(errno, EISDIR);
  WriteWholeFile(Path("link.csv"), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(Path("link.csv")));
  EXPECT_EQ(ReadFile(Path("kept.csv")), "old");
}

}  // namespace
}  // namespace dgd_demos
