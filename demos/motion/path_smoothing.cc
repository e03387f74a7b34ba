#include "motion/path_smoothing.h"

#include <dgd/any_set.h>

#include <algorithm>
#include <vector>

#include "motion/joint_gradient.h"
#include "motion/plane_cache.h"

namespace dgd_demos {
namespace {

constexpr int kMargins = 12;                // Tried one after the other, each larger than the last.
constexpr int kStepsPerMargin = 40;         // Of the whole band.
constexpr int kStepsPerMeasurement = 5;     // Of the clearance, which takes longer than a step.
constexpr double kMostPush = 0.05;          // Of one configuration in one step, rad.
constexpr double kPushShare = 0.5;          // Of the way to the margin, to first order.
constexpr double kTension = 0.4;            // Of the way to the middle of the neighbours.
constexpr double kLeastSensitivity = 1e-3;  // Squared, (m/rad)^2: below, no joint moves the pair apart.
constexpr int kMostTightening = 20;         // Steps of tension alone, to get back to the allowed length.

class ElasticBand {
 public:
  ElasticBand(const CollisionModel& model, const JointPath& path, const SmoothingOptions& options)
      : model_(model),
        options_(options),
        most_length_(options.most_lengthening * Length(path)),
        band_(Subdivide(path, options.waypoint_step)),
        planes_(band_.size(), PlaneCache(model)),
        measuring_planes_(model),
        best_(path),
        best_clearance_(LeastSignedDistance(model, path, options.check_step, measuring_planes_)) {}

  const JointPath& best() const { return best_; }
  double best_clearance() const { return best_clearance_; }
  double ClearanceAtEnds() {
    return std::min(LeastSignedDistance(model_, {band_.front()}, options_.check_step, measuring_planes_),
                    LeastSignedDistance(model_, {band_.back()}, options_.check_step, measuring_planes_));
  }

  /// Moves all configurations but the ends once.
  void Move(double margin) {
    for (std::size_t i = 1; i + 1 < band_.size(); ++i) {
      const Configuration push = Push(i, margin);
      MoveTo(i, band_[i] + push + kTension * (Middle(i) - band_[i]));
    }
    for (int i = 0; i < kMostTightening && Length(band_) > most_length_; ++i) {
      for (std::size_t k = 1; k + 1 < band_.size(); ++k) MoveTo(k, Middle(k));
    }
  }

  /// Remembers the band if it is the best so far.
  void Measure() {
    if (Length(band_) > most_length_) return;
    const double clearance = LeastSignedDistance(model_, band_, options_.check_step, measuring_planes_);
    if (clearance <= best_clearance_) return;
    best_ = band_;
    best_clearance_ = clearance;
  }

 private:
  Configuration Middle(std::size_t i) const { return (band_[i - 1] + band_[i + 1]) / 2; }

  void MoveTo(std::size_t i, const Configuration& configuration) {
    band_[i] = configuration;
    for (std::size_t joint = 0; joint < model_.arm().joints.size(); ++joint) {
      double& angle = band_[i][static_cast<Eigen::Index>(joint)];
      angle = std::clamp(angle, model_.arm().joints[joint].lower, model_.arm().joints[joint].upper);
    }
  }

  // Away from all pairs nearer than the margin, by the share of the way there that each still has to go.
  Configuration Push(std::size_t i, double margin) {
    Configuration push = Configuration::Zero(band_[i].size());
    model_.ComputePoses(band_[i], poses_);
    bool has_link_poses = false;
    for (std::size_t pair = 0; pair < model_.pairs().size(); ++pair) {
      if (planes_[i].Separates(pair, poses_, margin)) continue;
      const auto [first, second] = model_.pairs()[pair];
      const dgd::AnySet &set_1 = model_.parts()[first].body.set(), &set_2 = model_.parts()[second].body.set();
      const dgd::Result<double> result = dgd::GrowthDistance(set_1, poses_[first], set_2, poses_[second]);
      planes_[i].Store(pair, poses_, result.normal);
      if (result.separation >= margin) continue;
      const dgd::Gradient<double> gradient =
          dgd::GrowthDistanceGradient(set_1, poses_[first], set_2, poses_[second], result);
      const double per_metre = gradient.pose_2.linear.norm();
      if (!(per_metre > 0)) continue;  // No gradient, as of coincident centres.
      if (!has_link_poses) ComputeLinkPoses(model_.arm(), band_[i], link_poses_);
      has_link_poses = true;
      // Divided by what the growth distance changes by per metre along the normal, it is in metres per radian: of the
      // separation along the normal, which is what the margin is in.
      const Configuration slope = JointGradient(model_, link_poses_, poses_, {first, second}, gradient) / per_metre;
      push += kPushShare * (margin - result.separation) / std::max(slope.squaredNorm(), kLeastSensitivity) * slope;
    }
    const double length = push.norm();
    return length > kMostPush ? Configuration(push * (kMostPush / length)) : push;
  }

  const CollisionModel& model_;
  const SmoothingOptions options_;
  const double most_length_;
  JointPath band_;
  std::vector<PlaneCache> planes_;  // Of each configuration, which moves little from step to step.
  PlaneCache measuring_planes_;
  JointPath best_;
  double best_clearance_;
  CollisionModel::Poses poses_;
  std::vector<Pose> link_poses_;
};

}  // namespace

JointPath Smooth(const CollisionModel& model, const JointPath& path, const SmoothingOptions& options,
                 const Progress& progress) {
  ElasticBand band(model, path, options);
  const double start_clearance = band.best_clearance();
  // Start and goal stay where they are, so the least clearance cannot exceed theirs. The margin goes beyond that, since
  // a band under tension ends below its margin.
  constexpr double kBeyond = 1.5;
  constexpr double kEnough = 0.999;  // Of the clearance at start and goal.
  const double clearance_at_ends = band.ClearanceAtEnds();
  const double largest_margin = kBeyond * clearance_at_ends;
  for (int i = 0; i < kMargins; ++i) {
    const double share = static_cast<double>(i + 1) / kMargins;
    const double margin = start_clearance + share * (largest_margin - start_clearance);
    for (int step = 0; step < kStepsPerMargin; ++step) {
      if (progress) progress((i + static_cast<double>(step) / kStepsPerMargin) / kMargins);
      band.Move(margin);
      if (step % kStepsPerMeasurement == kStepsPerMeasurement - 1) band.Measure();
    }
    if (band.best_clearance() >= kEnough * clearance_at_ends) break;
  }
  return band.best();
}

}  // namespace dgd_demos
