#include "bench/textbook/conic_block.h"

#include <algorithm>

namespace dgd_bench {

using Eigen::Vector3d;

void ConePart::Start(const Vector4& slack) {
  slack_ = slack;
  slack_determinant_ = ConeDeterminant(slack);
  multiplier_ = Reflected(slack) / slack_determinant_;
  multiplier_determinant_ = 1 / slack_determinant_;
}

void ConePart::ScaleMultiplier(double factor) {
  multiplier_ *= factor;
  multiplier_determinant_ *= factor * factor;
}

const Matrix4& ConePart::Linearize() {
  scaling_ = NesterovToddScaling(slack_, slack_determinant_, multiplier_, multiplier_determinant_);
  weight_ = scaling_.InverseSquared();
  correction_.setZero();
  return weight_;
}

void ConePart::FindStep(const Vector4& slack_step, StepReach& reach) {
  slack_step_ = slack_step;
  multiplier_step_ = correction_ - multiplier_ - weight_ * slack_step;
  reach.steps = std::min({reach.steps, StepsToConeBorder(slack_, slack_determinant_, slack_step_),
                          StepsToConeBorder(multiplier_, multiplier_determinant_, multiplier_step_)});
  reach.curvature += slack_step_.dot(multiplier_step_);
}

const Vector4& ConePart::Correct(double target) {
  // In scaled coordinates, where slack and multiplier are the same l, and their steps add up to -l: the product of the
  // steps, a and -a - l, divided by l is -(a o a) / l - a.
  const Vector4 scaled = scaling_.InverseTimes(slack_), scaled_step = scaling_.InverseTimes(slack_step_);
  Vector4 aim = ConeSquare(scaled_step);
  aim[0] += target;
  correction_ = scaling_.InverseTimes(ConeQuotient(aim, scaled, ConeDeterminant(scaled)) + scaled_step);
  return correction_;
}

void ConePart::Take(double length) {
  slack_ += length * slack_step_;
  multiplier_ += length * multiplier_step_;
  slack_determinant_ = ConeDeterminant(slack_);
  multiplier_determinant_ = ConeDeterminant(multiplier_);
}

void FacesPart::Start(const Vector4& point) {
  slacks_ = faces_ * point;
  multipliers_ = slacks_.inverse();
}

Vector4 FacesPart::Pull() const { return PullOf(multipliers_); }

Vector4 FacesPart::PullOf(const FaceArray& multipliers) const {
  Vector4 pull;
  for (int i = 0; i < 4; ++i) pull[i] = faces_.col(i).dot(multipliers.matrix());
  return pull;
}

Matrix4 FacesPart::Linearize() {
  inverse_slacks_ = slacks_.inverse();
  weights_ = multipliers_ * inverse_slacks_;
  is_corrected_ = false;
  Matrix4 sum;
  for (int i = 0; i < 4; ++i) {
    products_ = weights_ * faces_.col(i).array();
    for (int j = i; j < 4; ++j) sum(i, j) = sum(j, i) = faces_.col(j).dot(products_.matrix());
  }
  return sum;
}

void FacesPart::FindStep(const Vector4& step, StepReach& reach) {
  if (Size() == 0) return;
  slack_steps_ = faces_ * step;
  multiplier_steps_ = -multipliers_ - weights_ * slack_steps_;
  if (is_corrected_) multiplier_steps_ += corrections_;
  // The steps to the border are the inverse of the largest part of a slack or a multiplier that one step takes.
  const double rate =
      std::max(-(slack_steps_ * inverse_slacks_).minCoeff(), -(multiplier_steps_ / multipliers_).minCoeff());
  if (rate > 0) reach.steps = std::min(reach.steps, 1 / rate);
  products_ = slack_steps_ * multiplier_steps_;
  reach.curvature += products_.sum();
}

Vector4 FacesPart::Correct(double target) {
  is_corrected_ = true;
  corrections_ = (target - products_) * inverse_slacks_;
  return PullOf(corrections_);
}

void FacesPart::Take(double length) {
  slacks_ += length * slack_steps_;
  multipliers_ += length * multiplier_steps_;
}

void ConicBlock::Start(const Vector3d& y, double scale) {
  Vector4 core_point;
  core_point << y, scale;
  if (HasBall()) {
    // As deep inside the core as the rest of the way is inside the ball.
    core_point.head<3>() *= set_.core_inradius / set_.Inradius();
    Vector4 ball_slack;
    ball_slack << set_.radius * scale, y - core_point.head<3>();
    ball_.Start(ball_slack);
  }
  faces_.Start(core_point);
  if (set_.has_cone) cone_.Start(set_.cone * core_point);
}

void ConicBlock::ScaleMultipliers(double factor) {
  faces_.ScaleMultipliers(factor);
  if (set_.has_cone) cone_.ScaleMultiplier(factor);
  if (HasBall()) ball_.ScaleMultiplier(factor);
}

double ConicBlock::Complementarity() const {
  double sum = faces_.Complementarity();
  if (set_.has_cone) sum += cone_.Complementarity();
  if (HasBall()) sum += ball_.Complementarity();
  return sum;
}

Vector3d ConicBlock::Unknown(const Vector3d& core_point) const {
  return set_.core_variables == 1 ? Vector3d(0, 0, core_point.z()) : core_point;
}

ConicPull ConicBlock::Pull() const { return PullOf(faces_.Pull(), cone_.Multiplier(), ball_.Multiplier()); }

ConicPull ConicBlock::PullOf(const Vector4& of_faces, const Vector4& of_cone, const Vector4& of_ball) const {
  Vector4 of_core = of_faces;
  if (set_.has_cone) of_core += set_.cone.transpose() * of_cone;
  if (!HasBall()) return {of_core, Vector3d::Zero()};
  ConicPull pull;
  pull.of_point << of_ball.tail<3>(), of_core[3] + set_.radius * of_ball[0];
  pull.of_core = Unknown(of_core.head<3>() - of_ball.tail<3>());
  return pull;
}

Matrix4 ConicBlock::Linearize() {
  Matrix4 of_core = faces_.Linearize();
  if (set_.has_cone) of_core += set_.cone.transpose() * cone_.Linearize() * set_.cone;
  return HasBall() ? EliminateCorePoint(of_core, ball_.Linearize()) : of_core;
}

Matrix4 ConicBlock::EliminateCorePoint(const Matrix4& of_core, const Matrix4& of_ball) {
  const Eigen::Matrix3d offset_part = of_ball.bottomRightCorner<3, 3>();
  const Vector3d radius_part = set_.radius * of_ball.bottomLeftCorner<3, 1>();
  Eigen::Matrix3d own = of_core.topLeftCorner<3, 3>() + offset_part;
  core_coupling_ << -offset_part, of_core.topRightCorner<3, 1>() - radius_part;
  if (set_.core_variables == 1) {
    core_coupling_.topRows<2>().setZero();
    own = Vector3d(1, 1, own(2, 2)).asDiagonal();
  }
  core_matrix_.compute(own);
  Matrix4 matrix;
  matrix << offset_part, radius_part, radius_part.transpose(),
      of_core(3, 3) + set_.radius * set_.radius * of_ball(0, 0);
  matrix -= core_coupling_.transpose() * core_matrix_.solve(core_coupling_);
  core_right_.setZero();
  return matrix;
}

StepReach ConicBlock::FindStep(const Vector4& step) {
  StepReach reach;
  Vector4 core_step = step;
  if (HasBall()) {
    core_step.head<3>() = core_matrix_.solve(core_right_ - core_coupling_ * step);
    Vector4 ball_step;
    ball_step << set_.radius * step[3], step.head<3>() - core_step.head<3>();
    ball_.FindStep(ball_step, reach);
  }
  faces_.FindStep(core_step, reach);
  if (set_.has_cone) cone_.FindStep(set_.cone * core_step, reach);
  return reach;
}

Vector4 ConicBlock::Correct(double target) {
  const Vector4 of_faces = faces_.Correct(target);
  const ConicPull pull = PullOf(of_faces, set_.has_cone ? cone_.Correct(target) : Vector4::Zero(),
                                HasBall() ? ball_.Correct(target) : Vector4::Zero());
  if (!HasBall()) return pull.of_point;
  core_right_ = pull.of_core;
  return pull.of_point - core_coupling_.transpose() * core_matrix_.solve(core_right_);
}

void ConicBlock::Take(double length) {
  faces_.Take(length);
  if (set_.has_cone) cone_.Take(length);
  if (HasBall()) ball_.Take(length);
}

}  // namespace dgd_bench
