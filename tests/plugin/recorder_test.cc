// What the recorder writes are the pairs that Bullet processes, and what is read of a damaged file is a true part of
// it.
#include "dgd_bullet/recorder.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "dgd_bullet/record_file.h"
#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "support/reference_set.h"

namespace dgd_test {
namespace {

using dgd_bullet::Record;
using dgd_bullet::RecordedPair;
using dgd_bullet::RecordedPose;
using dgd_bullet::RecordedShape;

constexpr std::size_t kHeaderSize = 56;  // By the format's description.

/// As plain numbers with a support height of their own.
ReferenceSet SetOf(const RecordedShape& shape) {
  const auto& numbers = shape.numbers;
  ReferenceSet set{.type = static_cast<CoreType>(shape.core), .radius = shape.radius};  // In the same order.
  if (shape.core == RecordedShape::Core::kTriangle || shape.core == RecordedShape::Core::kHull) {
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      set.points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
  } else {
    std::ranges::copy(numbers, set.size.begin());
  }
  return set;
}

ReferencePose PoseOf(const RecordedPose& pose) {
  ReferencePose reference;
  for (int row = 0; row < 3; ++row) {
    const auto r = static_cast<std::size_t>(row);
    for (std::size_t column = 0; column < 3; ++column) {
      reference.rotation(row, int(column)) = pose.rotation[3 * r + column];
    }
    reference.translation[row] = pose.translation[r];
  }
  return reference;
}

class RecorderTest : public testing::Test {
 protected:
  RecorderTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("dgd_recorder_test." + std::to_string(getpid()) + "." +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directory(folder_);
  }
  ~RecorderTest() override {
    std::filesystem::current_path(std::filesystem::temp_directory_path());
    std::filesystem::remove_all(folder_);
  }

  std::string Bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static Record ReadBytes(const std::string& bytes) {
    std::istringstream file(bytes);
    return dgd_bullet::ReadRecord(file, "bytes");
  }

  /// Two boxes and a ball, of which the ball falls, for some steps.
  void RecordFall(int steps) {
    dgd_bullet::Options options;
    std::filesystem::current_path(folder_);

    dgd_bullet::Recorder recorder("pairs.rec");  // dgd_bullet/recorder.h
    options.pair_observer = &recorder;           // ... and recorder.NextStep() after each step.

    TestWorld world(Route::kConfiguration, options);
    auto& box = world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
    auto& ball = world.Make<btSphereShape>(btScalar(0.3));
    world.Add(box, 0, Vec(0, 0, 0));
    world.Add(box, 1, Vec(0, 0, 1.001));
    world.Add(ball, 1, Vec(0.6, 0, 0.9));
    for (int step = 0; step < steps; ++step) {
      world.Simulate(TestWorld::kTimeStep);
      recorder.NextStep();
    }
    recorder.Close();
  }

  const std::filesystem::path folder_;
  const std::string path_ = (folder_ / "pairs.rec").string();
};

TEST_F(RecorderTest, EveryShape_IsRecordedAsBulletSeesIt) {
  Random random(7);
  const std::vector<ZooShape> zoo = MakeShapeZoo(0.7);
  dgd_bullet::Recorder recorder(path_);
  struct Asked {
    std::shared_ptr<btConvexShape> shape;
    btTransform pose;
  };
  std::vector<Asked> asked;
  std::uint64_t left_out = 0;
  btSphereShape ball(btScalar(0.25));
  const btTransform ball_pose = At(3, 0, 0);  // Wrappers hold references.
  for (const ZooShape& entry : zoo) {
    const btTransform pose = MakeTransform(random.Rotation(), Vector(1, -2, 0.5));
    btCollisionObject first, second;
    const btCollisionObjectWrapper body_0(nullptr, entry.shape.get(), &first, pose, -1, -1);
    const btCollisionObjectWrapper body_1(nullptr, &ball, &second, ball_pose, -1, -1);
    const std::uint64_t before = recorder.pair_count();
    recorder.OnPair(body_0, body_1);
    if (recorder.pair_count() > before) {
      asked.push_back({entry.shape, pose});
    } else {
      ++left_out;
    }
  }
  recorder.Close();

  const Record record = dgd_bullet::ReadRecord(path_);
  EXPECT_FALSE(record.problem) << *record.problem;
  EXPECT_EQ(record.real_bytes, int(sizeof(btScalar)));
  EXPECT_EQ(record.left_out, left_out);
  EXPECT_GE(asked.size(), 15U);
  EXPECT_GE(left_out, 2U) << "multi-spheres and users' shapes";
  ASSERT_EQ(record.pairs.size(), asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const RecordedPair& pair = record.pairs[i];
    const ReferenceSet set = SetOf(record.shapes.at(pair.shape_1));
    const ReferencePose pose = PoseOf(pair.pose_1);
    const PosedConvex convex{*asked[i].shape, asked[i].pose};
    for (int k = 0; k < 50; ++k) {
      const Vector direction = random.UnitVector();
      const double tolerance = 20 * double(std::numeric_limits<btScalar>::epsilon());
      EXPECT_NEAR(Height(set, pose, direction), convex.SupportValue(direction), tolerance) << asked[i].shape->getName();
    }
    EXPECT_EQ(record.shapes.at(pair.shape_2).core, RecordedShape::Core::kPoint);
    EXPECT_EQ(record.shapes.at(pair.shape_2).radius, double(btScalar(0.25)));
    EXPECT_EQ(pair.pose_2.translation, (std::array{3.0, 0.0, 0.0}));
  }
}

TEST_F(RecorderTest, PairsOfAWorld_HaveTheirStepsAndKeepTheirNumbers) {
  constexpr int kSteps = 5;
  RecordFall(kSteps);
  const Record record = dgd_bullet::ReadRecord(path_);
  EXPECT_FALSE(record.problem) << *record.problem;
  EXPECT_EQ(record.shapes.size(), 2U) << "each once, however many bodies and steps share it";
  ASSERT_EQ(record.pairs.size(), 3U * kSteps);
  double last_height = 1;
  for (std::size_t i = 0; i < record.pairs.size(); ++i) {
    const RecordedPair& pair = record.pairs[i];
    EXPECT_EQ(pair.step, i / 3);
    EXPECT_EQ(pair.body_pair, record.pairs[i % 3].body_pair);
    const bool ball_is_first = record.shapes[pair.shape_1].core == RecordedShape::Core::kPoint;
    const bool has_ball = ball_is_first || record.shapes[pair.shape_2].core == RecordedShape::Core::kPoint;
    if (!has_ball || pair.body_pair != record.pairs[2].body_pair) continue;
    const double height = (ball_is_first ? pair.pose_1 : pair.pose_2).translation[2];
    EXPECT_LT(height, last_height) << "it falls";
    last_height = height;
  }
}

TEST_F(RecorderTest, TruncatedAnywhere_GivesWhatWasBefore) {
  RecordFall(3);
  const std::string bytes = Bytes();
  const Record whole = ReadBytes(bytes);
  std::size_t most_pairs = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Record part;
    try {
      part = ReadBytes(bytes.substr(0, size));
    } catch (const std::runtime_error& error) {
      EXPECT_LT(size, kHeaderSize) << error.what();  // Not a record yet.
      EXPECT_NE(std::string(error.what()).find("bytes: "), std::string::npos) << error.what();
      continue;
    }
    ASSERT_TRUE(part.problem) << size;
    ASSERT_LT(part.pairs.size(), whole.pairs.size() + (size + 1 == bytes.size()));
    most_pairs = std::max(most_pairs, part.pairs.size());
  }
  EXPECT_EQ(most_pairs, 6U) << "all steps but the last";
}

TEST_F(RecorderTest, AnyChangedByte_IsNoticed) {
  RecordFall(2);
  const std::string bytes = Bytes();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    try {
      const Record part = ReadBytes(damaged);
      ASSERT_TRUE(part.problem) << i;
      EXPECT_NE(part.problem->find("damaged from byte "), std::string::npos) << *part.problem;
    } catch (const std::runtime_error&) {
      ASSERT_LT(i, kHeaderSize) << "only a header makes the whole file unreadable";
    }
  }
}

TEST_F(RecorderTest, NotClosed_IsReadToItsEndAndSaysSo) {
  RecordFall(2);
  std::string bytes = Bytes();
  {
    const dgd_bullet::Recorder never_used(path_);
    const std::string header = Bytes();  // As a program that was killed leaves it.
    bytes.replace(0, header.size(), header);
  }
  const Record record = ReadBytes(bytes);
  EXPECT_EQ(record.pairs.size(), 6U);
  ASSERT_TRUE(record.problem);
  EXPECT_NE(record.problem->find("not closed"), std::string::npos) << *record.problem;
}

TEST_F(RecorderTest, WhatIsNoShape_IsLeftOut) {
  dgd_bullet::Recorder recorder(path_);
  btConvexHullShape without_points;
  btSphereShape ball{std::numeric_limits<btScalar>::quiet_NaN()};
  btCollisionObject object;
  const btTransform pose = At(0, 0, 0);
  const btCollisionObjectWrapper no_hull(nullptr, &without_points, &object, pose, -1, -1);
  const btCollisionObjectWrapper no_ball(nullptr, &ball, &object, pose, -1, -1);
  recorder.OnPair(no_hull, no_hull);
  recorder.OnPair(no_ball, no_ball);
  recorder.Close();
  EXPECT_EQ(recorder.pair_count(), 0U);
  EXPECT_EQ(dgd_bullet::ReadRecord(path_).left_out, 2U);
}

TEST_F(RecorderTest, WhatCannotBeWrittenOrRead_IsNamed) {
  const auto message_of = [](const auto& act) -> std::string {
    try {
      act();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(message_of([] { dgd_bullet::Recorder("/no/such/folder/a.rec"); }),
            "/no/such/folder/a.rec: cannot be written");
  EXPECT_EQ(message_of([] { dgd_bullet::ReadRecord("/no/such.rec"); }), "/no/such.rec: cannot be opened");
  EXPECT_EQ(message_of([] { ReadBytes("{\"a scene\": 1}, and no record at all, though of some length"); }),
            "bytes: not a record");
  EXPECT_EQ(message_of([] {
              dgd_bullet::Recorder recorder("/dev/full");
              recorder.Close();
            }),
            "/dev/full: cannot be written");
}

}  // namespace
}  // namespace dgd_test
