#include "motion/clearance.h"

#include <dgd/any_set.h>
#include <dgd/certificate.h>

#include <algorithm>

namespace dgd_demos {
namespace {

constexpr double kTolerance = 1e-9;  // Relative, of the growth distance.
// Of a certificate. The witness points of curved sets are as exact as the square root of the tolerance.
constexpr double kCertificateLength = 1e-6;  // m
constexpr double kCertificateGap = 1e-6;     // Relative.

dgd::Result<double> SolveGrowthDistance(const ConvexBody& first, const dgd::Pose<double>& pose_1,
                                        const ConvexBody& second, const dgd::Pose<double>& pose_2) {
  return dgd::GrowthDistance(first.set(), pose_1, second.set(), pose_2, {.relative_tolerance = kTolerance});
}

bool IsProvenApart(const ConvexBody& first, const dgd::Pose<double>& pose_1, const ConvexBody& second,
                   const dgd::Pose<double>& pose_2) {
  const dgd::Result<double> result = SolveGrowthDistance(first, pose_1, second, pose_2);
  return first.set().Visit([&]<class Set1>(const Set1& set_1) {
    return second.set().Visit([&]<class Set2>(const Set2& set_2) {
      if constexpr (dgd::CertifiableCore<typename Set1::Core> && dgd::CertifiableCore<typename Set2::Core>) {
        const dgd::Certificate certificate = dgd::Certify(set_1, pose_1, set_2, pose_2, result);
        return certificate.Holds(kCertificateLength, kCertificateGap) && certificate.proven_lower_bound > 1;
      } else {
        return false;  // A core of a user's own, which no scene file makes.
      }
    });
  });
}

// Calls visit(state, poses, place) for states at most `step` apart, until it returns false.
template <class Visit>
void ForEachState(const CollisionModel& model, const JointPath& path, double step, const Progress& progress,
                  const Visit& visit) {
  const JointPath states = Subdivide(path, step);
  CollisionModel::Poses poses;
  double place = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i > 0) place += (states[i] - states[i - 1]).norm();
    if (progress) progress(static_cast<double>(i) / static_cast<double>(states.size()));
    model.ComputePoses(states[i], poses);
    if (!visit(states[i], poses, place)) return;
  }
}

}  // namespace

Clearance MeasureClearance(const CollisionModel& model, const JointPath& path, double step, const Progress& progress) {
  Clearance clearance;
  ForEachState(model, path, step, progress, [&](const Configuration& state, const auto& poses, double place) {
    for (std::size_t i = 0; i < model.pairs().size(); ++i) {
      const auto [first, second] = model.pairs()[i];
      const ConvexBody &body_1 = model.parts()[first].body, &body_2 = model.parts()[second].body;
      const dgd::Result<double> growth = SolveGrowthDistance(body_1, poses[first], body_2, poses[second]);
      if (growth.GrowthDistance() < clearance.growth_distance.value) {
        clearance.growth_distance = {growth.GrowthDistance(), i, place, state};
      }
      // The separation along any normal is a lower bound of the signed distance: most pairs end here.
      if (growth.separation >= clearance.signed_distance.value) continue;
      const dgd::SignedDistanceResult<double> distance =
          dgd::SignedDistance(body_1.set(), poses[first], body_2.set(), poses[second], growth);
      if (distance.separation < clearance.signed_distance.value) {
        clearance.signed_distance = {distance.separation, i, place, state};
      }
    }
    return true;
  });
  return clearance;
}

double LeastSignedDistance(const CollisionModel& model, const JointPath& path, double step, PlaneCache& planes) {
  double least = std::numeric_limits<double>::infinity();
  ForEachState(model, path, step, {}, [&](const Configuration&, const auto& poses, double) {
    for (std::size_t i = 0; i < model.pairs().size(); ++i) {
      if (planes.Separates(i, poses, least)) continue;
      const auto [first, second] = model.pairs()[i];
      const ConvexBody &body_1 = model.parts()[first].body, &body_2 = model.parts()[second].body;
      const dgd::Result<double> growth = SolveGrowthDistance(body_1, poses[first], body_2, poses[second]);
      planes.Store(i, poses, growth.normal);
      if (growth.separation >= least) continue;
      const dgd::SignedDistanceResult<double> distance =
          dgd::SignedDistance(body_1.set(), poses[first], body_2.set(), poses[second], growth);
      planes.Store(i, poses, distance.normal);
      least = std::min(least, distance.separation);
    }
    return true;
  });
  return least;
}

std::optional<UnprovenState> FindUnprovenState(const CollisionModel& model, const JointPath& path, double step,
                                               const Progress& progress) {
  std::optional<UnprovenState> unproven;
  ForEachState(model, path, step, progress, [&](const Configuration& state, const auto& poses, double place) {
    for (std::size_t i = 0; i < model.pairs().size(); ++i) {
      const auto [first, second] = model.pairs()[i];
      if (IsProvenApart(model.parts()[first].body, poses[first], model.parts()[second].body, poses[second])) continue;
      unproven = {i, place, state};
      return false;
    }
    return true;
  });
  return unproven;
}

}  // namespace dgd_demos
