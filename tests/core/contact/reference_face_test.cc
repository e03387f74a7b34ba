// The distance from the face that holds a contact: the same answer as SignedDistance() gives from_scratch, certified,
// and a refusal where the face holds it no longer.
#include "dgd/contact/reference_face.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "dgd/signed_distance_certificate.h"
#include "support/pairs/any_pair.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::ReferenceSide;
using dgd::Status;
using Eigen::Vector3d;

constexpr double kAngularTolerance = 1.47;

struct Count {
  int contacts = 0, on_face_1 = 0, on_face_2 = 0;
  int frames = 0, followed = 0, separated = 0, refused = 0;
};

/// The signed distance from scratch, and whose face holds it.
template <class S>
struct FromScratch {
  dgd::SignedDistanceResult<S> result;
  dgd::WarmStart<S> state;
  ReferenceSide holder = ReferenceSide::kNone;
};

template <class Set1, class Set2>
FromScratch<typename Set1::Scalar> MeasureFromScratch(const Set1& set_1, const dgd::PoseOf<Set1>& pose_1,
                                                      const Set2& set_2, const dgd::PoseOf<Set1>& pose_2) {
  using S = typename Set1::Scalar;
  FromScratch<S> from_scratch;
  const AnyPair<S, 3> pair(Erase(set_1), pose_1, Erase(set_2), pose_2);
  dgd::WarmStart<S> warm_start;
  dgd::Result<S> growth = pair.GrowthDistance({}, &warm_start);
  from_scratch.result = pair.SignedDistance(growth, &warm_start, {}, &from_scratch.state);
  growth.normal = from_scratch.result.normal;
  growth.witness_1 = from_scratch.result.witness_1;
  growth.witness_2 = from_scratch.result.witness_2;
  if (from_scratch.result.status == Status::kOptimal) {
    from_scratch.holder =
        dgd::ReferenceSideOf(dgd::FindFacingFaces(set_1, pose_1, set_2, pose_2, growth, S(kAngularTolerance)));
  }
  return from_scratch;
}

/// Set 2 is put on set 1 as it falls, and shaken.
template <class Set1, class Set2>
void Shake(Random& random, const Set1& set_1, const Set2& set_2, Count& count) {
  using S = typename Set1::Scalar;
  constexpr int kFrames = 20;
  constexpr double kLimit = 0.05;  // m
  constexpr bool kIsPolytope = dgd::MinkowskiDifference<Set1, Set2>::kIsPolytope;
  const double tolerance = sizeof(S) == sizeof(float) ? 2e-5 : kIsPolytope ? 1e-13 : 3e-8;
  const auto rounded = [](const dgd::Pose<double>& pose) -> dgd::Pose<S> {
    return {pose.rotation.cast<S>(), pose.translation.cast<S>()};
  };
  dgd::Settings<S> settings;
  settings.separation_limit = S(kLimit);
  settings.relative_tolerance = S(std::max(1e-8, 0.5 * tolerance));
  const double radius = double(set_1.radius + set_2.radius);
  dgd::Pose<double> pose_1{random.Rotation(), random.InCube()}, pose_2{random.Rotation(), pose_1.translation};
  const Vector3d up = random.UnitVector();
  const auto place = [&](double separation) {
    const auto from_scratch = MeasureFromScratch(set_1, rounded(pose_1), set_2, rounded(pose_2));
    pose_2.translation +=
        (separation - double(from_scratch.result.separation)) * from_scratch.result.normal.template cast<double>();
  };
  pose_2.translation += 2 * up;
  for (int i = 0; i < 3; ++i) place(-0.5 * radius);
  FromScratch<S> last = MeasureFromScratch(set_1, rounded(pose_1), set_2, rounded(pose_2));
  ++count.contacts;
  count.on_face_1 += last.holder == ReferenceSide::kSet1 ? 1 : 0;
  count.on_face_2 += last.holder == ReferenceSide::kSet2 ? 1 : 0;
  for (int frame = 0; frame < kFrames && last.holder != ReferenceSide::kNone; ++frame) {
    ++count.frames;
    pose_1.rotation = Eigen::AngleAxisd(0.01, random.UnitVector()) * pose_1.rotation;
    pose_2.rotation = Eigen::AngleAxisd(0.02, random.UnitVector()) * pose_2.rotation;
    pose_2.translation += 0.01 * random.InCube();
    const dgd::Pose<S> at_1 = rounded(pose_1), at_2 = rounded(pose_2);
    const FromScratch<S> from_scratch = MeasureFromScratch(set_1, at_1, set_2, at_2);
    dgd::WarmStart<S> state = last.state;
    dgd::FacingFaces<S> facing;
    const auto followed = dgd::UpdateOnReferenceFace(set_1, at_1, set_2, at_2, settings, S(kAngularTolerance),
                                                     last.holder, state, facing);
    switch (followed.status) {
      case Status::kOptimal: {
        ++count.followed;
        EXPECT_GT(double(followed.separation) + radius, 0);
        EXPECT_LE(double(followed.upper_bound), double(followed.separation) + tolerance);
        if (from_scratch.result.status == Status::kOptimal) {
          EXPECT_NEAR(double(followed.separation), double(from_scratch.result.separation), 2 * tolerance);
        }
        const auto certificate = dgd::Certify(set_1, at_1, set_2, at_2, followed);
        EXPECT_TRUE(certificate.Holds(tolerance, std::sqrt(tolerance)))
            << certificate.primal_infeasibility << ' ' << certificate.separation_error << ' '
            << certificate.connection_error << ' ' << certificate.neighbour_gain;
        break;
      }
      case Status::kSeparated:
        ++count.separated;
        EXPECT_GT(double(followed.separation), kLimit);
        EXPECT_LE(dgd::Certify(set_1, at_1, set_2, at_2, followed).separation_error, tolerance);
        EXPECT_EQ(state.size, 0);
        break;
      default:
        ++count.refused;
        EXPECT_EQ(followed.status, Status::kStalled);
        EXPECT_EQ(state.size, last.state.size);
        EXPECT_EQ(state.normal_1, last.state.normal_1);
    }
    if (followed.status == Status::kOptimal) {
      last.state = state;
    } else {
      last = from_scratch;
    }
    if (double(from_scratch.result.separation) > kLimit || double(from_scratch.result.separation) < -0.9 * radius)
      place(-0.5 * radius);
  }
}

template <class S>
void ShakeAllTypes(int rounds) {
  Random random(TestSeed());
  Count count;
  for (int i = 0; i < rounds && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("round " + std::to_string(i));
    std::vector<Vector3d> points;
    for (int p = 0; p < 14; ++p) points.push_back(0.5 * random.UnitVector());
    const dgd::Polytope<S> hull_core(points);
    const S radius = S(random.Uniform(0.02, 0.1));
    const dgd::RoundedSet hull{dgd::CoreReference(hull_core), radius};
    const dgd::RoundedSet box{dgd::Box<S>(dgd::Vector3<S>(S(0.3), S(0.2), S(0.4))), radius};
    const dgd::RoundedSet plate{dgd::Box<S>(dgd::Vector3<S>(S(5), S(5), S(0.5))), radius};
    const dgd::RoundedSet cylinder{dgd::Cylinder<S>(S(0.3), S(0.2)), radius};
    const dgd::RoundedSet cone{dgd::Cone<S>(S(0.3), S(0.6)), radius};
    const auto capsule = dgd::Capsule(S(0.1), S(0.3));
    const auto sphere = dgd::Sphere(S(0.2));
    Shake(random, box, box, count);
    Shake(random, box, hull, count);
    Shake(random, hull, hull, count);
    Shake(random, plate, hull, count);
    Shake(random, cylinder, plate, count);
    Shake(random, plate, cone, count);
    Shake(random, capsule, plate, count);
    Shake(random, hull, sphere, count);
    Shake(random, box, cylinder, count);
  }
  std::printf("%d contacts, %d on a face of set 1 and %d of set 2; %d frames: %d followed, %d separated, %d refused\n",
              count.contacts, count.on_face_1, count.on_face_2, count.frames, count.followed, count.separated,
              count.refused);
  EXPECT_GT(count.on_face_1, 0.1 * count.contacts);
  EXPECT_GT(count.on_face_2, 0.1 * count.contacts);
  EXPECT_GT(count.followed, 0.6 * count.frames);
  EXPECT_GT(count.separated, 0);
  EXPECT_GT(count.refused, 0);
}

TEST(HeldFace, SetsShakenOnFaces_AsAnewInDouble) { ShakeAllTypes<double>(TestCount(400, 40)); }
TEST(HeldFace, SetsShakenOnFaces_AsAnewInFloat) { ShakeAllTypes<float>(TestCount(200, 20)); }

// A box on a larger one, which is turned upside down.
TEST(HeldFace, BoxOnBox_AsLongAsItLiesOnIt) {
  const dgd::RoundedSet plate{dgd::Box<double>({1, 1, 0.1}), 0.05}, box{dgd::Box<double>({0.2, 0.2, 0.2}), 0.05};
  const auto turned = [](double angle) -> Eigen::Matrix3d {
    // As an engine in float has it: not quite orthogonal.
    return Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix().cast<float>().cast<double>();
  };
  dgd::WarmStart<double> state;
  state.normal_1 = Vector3d(0, 0, 1);
  dgd::FacingFaces<double> facing;
  const auto follow = [&](const Vector3d& place, double angle, ReferenceSide holder) {
    const Eigen::Matrix3d rotation = turned(angle);
    return dgd::UpdateOnReferenceFace(plate, {rotation, Vector3d::Zero()}, box, {rotation, rotation * place}, {},
                                      kAngularTolerance, holder, state, facing);
  };
  for (int degrees = 0; degrees <= 180; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto result = follow({0.5, 0.3, 0.39}, angle, ReferenceSide::kSet1);
    ASSERT_EQ(result.status, Status::kOptimal) << degrees;
    EXPECT_NEAR(result.separation, -0.01, 1e-7);
    EXPECT_LT((result.normal - turned(angle) * Vector3d::UnitZ()).norm(), 1e-6);
    EXPECT_EQ(facing.overlap.size, 4);
    EXPECT_EQ(follow({0.5, 0.3, 0.39}, angle, ReferenceSide::kSet2).status, Status::kOptimal);
  }
  // Beside the plate: its face is no longer above anything.
  EXPECT_EQ(follow({1.5, 0.3, 0.39}, 0, ReferenceSide::kSet1).status, Status::kStalled);
  // The cores overlap: which way out is the shortest, the face does not know.
  EXPECT_EQ(follow({0.5, 0.3, 0.25}, 0, ReferenceSide::kSet1).status, Status::kStalled);
}

TEST(HeldFace, NoFaceOrBadInput_IsRefused) {
  const dgd::RoundedSet box{dgd::Box<double>(Vector3d(1, 1, 1)), 0.1};
  const auto sphere = dgd::Sphere(0.5);
  dgd::WarmStart<double> state;
  state.normal_1 = Vector3d(0, 0, 1);
  dgd::FacingFaces<double> facing;
  dgd::Pose<double> pose;
  pose.translation = Vector3d(0, 0, 1.59);
  const auto follow = [&](ReferenceSide holder) {
    return dgd::UpdateOnReferenceFace(box, {}, sphere, pose, {}, kAngularTolerance, holder, state, facing).status;
  };
  // A ball has no face, but is on one.
  EXPECT_EQ(follow(ReferenceSide::kSet2), Status::kStalled);
  EXPECT_EQ(follow(ReferenceSide::kSet1), Status::kOptimal);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    pose.translation.z() = bad;
    EXPECT_EQ(follow(ReferenceSide::kSet1), Status::kStalled);
  }
}

// A body whose pose was lost while it lay on a face: fuzz_plugin_world found a facet of number -1 looked up.
TEST(HeldFace, RotationThatIsNone_IsRefused) {
  const dgd::Polytope<double> cube(std::vector<Vector3d>{
      {-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, -1}, {1, -1, 1}, {1, 1, -1}, {1, 1, 1}});
  const dgd::RoundedSet hull{dgd::CoreReference(cube), 0.1};
  dgd::FacingFaces<double> facing;
  for (const ReferenceSide holder : {ReferenceSide::kSet1, ReferenceSide::kSet2}) {
    for (const bool is_first : {true, false}) {
      dgd::WarmStart<double> state;
      state.normal_1 = Vector3d(0, 0, 1);
      dgd::Pose<double> bad;
      bad.translation = Vector3d(0, 0, is_first ? -2.15 : 2.15);
      const auto follow = [&] {
        return is_first ? dgd::UpdateOnReferenceFace(hull, bad, hull, {}, {}, kAngularTolerance, holder, state, facing)
                              .status
                        : dgd::UpdateOnReferenceFace(hull, {}, hull, bad, {}, kAngularTolerance, holder, state, facing)
                              .status;
      };
      ASSERT_EQ(follow(), Status::kOptimal);
      bad.rotation.fill(std::numeric_limits<double>::quiet_NaN());
      EXPECT_EQ(follow(), Status::kStalled);
    }
  }
}

}  // namespace
}  // namespace dgd_test
