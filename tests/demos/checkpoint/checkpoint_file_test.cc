// Contract: a checkpoint is read by the run that wrote it and by no other; a damaged one is refused.
#include "checkpoint/checkpoint_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "checkpoint/continued_file.h"
#include "report/whole_file.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

const nlohmann::json kRun = {{"seed", 1}, {"world", "tower"}};

class CheckpointFileTest : public testing::Test {
 protected:
  CheckpointFileTest() : file_(folder_.path() / "a.checkpoint") {
    StateArchive archive;
    SerializeValues(archive);
    WriteCheckpoint(file_, kRun, archive);
  }

  void SerializeValues(StateArchive& archive) {
    archive.Serialize(number_);
    archive.Serialize(text_);
    archive.Serialize(list_, [&](int& element) { archive.Serialize(element); });
    archive.Serialize(vector_);
  }

  std::string Complaint(const nlohmann::json& run = kRun) {
    try {
      ReadCheckpoint(file_, run);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  TestFolder folder_;
  std::filesystem::path file_;
  double number_ = 0.1;
  std::string text_ = "a\n\0b";
  std::vector<int> list_ = {3, 4, 5};
  Eigen::Vector3d vector_{1, 2, 3};
};

TEST_F(CheckpointFileTest, Values_AreReadBack) {
  number_ = 0;
  text_.clear();
  list_.clear();
  vector_.setZero();
  std::optional<StateArchive> archive = ReadCheckpoint(file_, kRun);
  ASSERT_TRUE(archive);
  SerializeValues(*archive);
  archive->ExpectEnd();
  EXPECT_EQ(number_, 0.1);
  EXPECT_EQ(text_, "a\n\0b");
  EXPECT_EQ(list_, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(vector_, Eigen::Vector3d(1, 2, 3));
  EXPECT_THROW(archive->Serialize(number_), std::runtime_error) << "nothing is left";
}

TEST_F(CheckpointFileTest, FileThatIsNotThere_IsNoCheckpoint) {
  EXPECT_FALSE(ReadCheckpoint(folder_.path() / "b.checkpoint", kRun));
}

TEST_F(CheckpointFileTest, AnotherRun_IsNamed) {
  EXPECT_EQ(Complaint(), "");
  EXPECT_EQ(Complaint({{"seed", 2}, {"world", "tower"}}),
            file_.string() + ": is of a run with seed 1, not 2; without --resume, the run starts from the beginning");
  EXPECT_NE(Complaint({{"seed", 1}, {"world", "tower"}, {"margin", 3}}).find("margin null, not 3"), std::string::npos);
}

TEST_F(CheckpointFileTest, EveryDamage_IsRefused) {
  const std::string bytes = ReadWholeFile(file_);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] ^= 1;
    folder_.Write("a.checkpoint", damaged);
    EXPECT_NE(Complaint(), "") << "byte " << i;
    folder_.Write("a.checkpoint", bytes.substr(0, i));
    EXPECT_NE(Complaint(), "") << "cut at byte " << i;
  }
}

TEST_F(CheckpointFileTest, ListThatDoesNotFit_IsRefusedBeforeItIsMade) {
  StateArchive written;
  std::uint64_t count = std::uint64_t(1) << 60;
  written.Serialize(count);
  StateArchive archive(written.bytes(), "place");
  EXPECT_THROW(SerializeValues(archive), std::runtime_error);
}

TEST_F(CheckpointFileTest, ContinuedFile_IsCutBack) {
  const std::filesystem::path file = folder_.Write("rows.csv", "one\n");
  StateArchive written;
  EXPECT_EQ(SerializeContinuedFile(written, file), 4U);
  std::ofstream(file, std::ios::app) << "two\n";
  StateArchive archive(written.bytes(), "place");
  EXPECT_EQ(SerializeContinuedFile(archive, file), 4U);
  EXPECT_EQ(ReadWholeFile(file), "one\n");

  folder_.Write("rows.csv", "o");
  StateArchive again(written.bytes(), "place");
  EXPECT_THROW(SerializeContinuedFile(again, file), std::runtime_error) << "what is missing cannot be made up for";
}

TEST_F(CheckpointFileTest, ContinuedFile_MustEndAsItDid) {
  const std::string row(1000, 'x');
  std::string rows;
  for (int i = 0; i < 100; ++i) rows += row;
  const std::filesystem::path file = folder_.Write("rows.npy", "head 1\n" + rows);
  StateArchive written;
  SerializeContinuedFile(written, file, 7);
  folder_.Write("rows.npy", "head 2\n" + rows + row);
  StateArchive longer(written.bytes(), "place");
  EXPECT_EQ(SerializeContinuedFile(longer, file, 7), 7 + rows.size()) << "the head counts more rows now";

  rows[rows.size() - 60'000] = 'y';
  folder_.Write("rows.npy", "head 2\n" + rows + row);
  StateArchive another(written.bytes(), "place");
  EXPECT_THROW(SerializeContinuedFile(another, file, 7), std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(file), 7 + rows.size() + row.size()) << "a file that is refused stays whole";
}

TEST_F(CheckpointFileTest, PartsOfWritersThatDied_AreRemoved) {
  const std::filesystem::path part = folder_.Write("a.checkpoint.host.12.part", "half of it");
  const std::filesystem::path other = folder_.Write("b.checkpoint.host.12.part", "another file's");
  RemoveParts(file_);
  EXPECT_FALSE(std::filesystem::exists(part));
  EXPECT_TRUE(std::filesystem::exists(other));
  EXPECT_EQ(Complaint(), "");
}

}  // namespace
}  // namespace dgd_demos
