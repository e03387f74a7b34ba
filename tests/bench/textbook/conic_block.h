// One set's part in the interior-point method: its constraints' slacks and multipliers, and their share of each step.
#pragma once

#include <Eigen/Cholesky>
#include <limits>

#include "bench/textbook/conic_set.h"
#include "bench/textbook/second_order_cone.h"

namespace dgd_bench {

/// How far a step leads.
struct StepReach {
  double steps = std::numeric_limits<double>::infinity();  ///< To the border, of slacks and of multipliers.
  double curvature = 0;                                    ///< The products of their steps.
};

/// A second-order cone's slack s and multiplier z.
class ConePart {
 public:
  /// s o z = e.
  void Start(const Vector4& slack);
  void ScaleMultiplier(double factor);

  const Vector4& Multiplier() const { return multiplier_; }
  double Complementarity() const { return slack_.dot(multiplier_); }

  /// Takes the scaling here. @return W^-2.
  const Matrix4& Linearize();
  /// The multiplier's step to the slack's: dz = d - z - W^-2 ds.
  void FindStep(const Vector4& slack_step, StepReach& reach);
  /// After a FindStep() with d = 0, the predictor's. @return the d that aims at s o z = target e and makes up for the
  /// predictor's product ds o dz.
  const Vector4& Correct(double target);
  void Take(double length);

 private:
  Vector4 slack_, multiplier_;
  double slack_determinant_ = 0, multiplier_determinant_ = 0;
  NesterovToddScaling scaling_;
  Matrix4 weight_;
  Vector4 slack_step_, multiplier_step_, correction_;
};

/// The same for linear inequalities.
class FacesPart {
 public:
  explicit FacesPart(const Eigen::MatrixX4d& faces) : faces_(faces) {}

  void Start(const Vector4& point);
  void ScaleMultipliers(double factor) { multipliers_ *= factor; }

  int Size() const { return static_cast<int>(faces_.rows()); }
  Vector4 Pull() const;
  double Complementarity() const { return (slacks_ * multipliers_).sum(); }

  Matrix4 Linearize();
  void FindStep(const Vector4& step, StepReach& reach);
  Vector4 Correct(double target);
  void Take(double length);

 private:
  using FaceArray = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMostConicFaces, 1>;

  /// C^T of these.
  Vector4 PullOf(const FaceArray& multipliers) const;

  const Eigen::MatrixX4d& faces_;
  FaceArray slacks_, multipliers_, inverse_slacks_, weights_, slack_steps_, multiplier_steps_, corrections_;
  FaceArray products_;  // Of the last two steps; while there are none, scratch.
  bool is_corrected_ = false;
};

/// C^T z, by which the multipliers pull.
struct ConicPull {
  Vector4 of_point;         ///< On y and the scale.
  Eigen::Vector3d of_core;  ///< On the core's point; vanishes at the optimum.
};

/// All constraints of a set. Its variables are the point's offset y from its centre, in its frame, and the scale; and,
/// with a radius, the offset u of the core's point, which is kept here. The slacks are linear in them, C v. Newton's
/// step is the solution of
///   C^T W^-2 C dv = C^T d - objective,
/// with d = 0 for the predictor. The objective, the scale, and what other sets add are not known here: a step is asked
/// for by its part of y and the scale.
class ConicBlock {
 public:
  /// The set outlives this.
  explicit ConicBlock(const ConicSet& set) : set_(set), faces_(set.faces) {}

  /// At a point well inside the set so scaled. The multipliers are central there: s o z = e.
  void Start(const Eigen::Vector3d& y, double scale);
  void ScaleMultipliers(double factor);

  /// As many as there are faces and cones: what the complementarity is, at s o z = e.
  int Degree() const { return faces_.Size() + (set_.has_cone ? 1 : 0) + (HasBall() ? 1 : 0); }
  double Complementarity() const;
  ConicPull Pull() const;

  /// Takes the scaling here. @return C^T W^-2 C of y and the scale, the core's point eliminated.
  Matrix4 Linearize();
  /// The slacks' and multipliers' steps to one of y and the scale.
  StepReach FindStep(const Vector4& step);
  /// After FindStep() of the predictor. @return C^T d of y and the scale, the core's point eliminated.
  Vector4 Correct(double target);
  void Take(double length);

 private:
  using Coupling = Eigen::Matrix<double, 3, 4>;

  bool HasBall() const { return set_.core_variables > 0; }
  /// The same of any multipliers, or what takes their place; the faces' part as they pull.
  ConicPull PullOf(const Vector4& of_faces, const Vector4& of_cone, const Vector4& of_ball) const;
  /// Without the coordinates of the core's point that are known to be 0.
  Eigen::Vector3d Unknown(const Eigen::Vector3d& core_point) const;
  Matrix4 EliminateCorePoint(const Matrix4& of_core, const Matrix4& of_ball);

  const ConicSet& set_;
  FacesPart faces_;
  ConePart cone_;
  ConePart ball_;                            // The slack (radius * scale, y - u).
  Eigen::LLT<Eigen::Matrix3d> core_matrix_;  // Of u.
  Coupling core_coupling_;                   // Of u with y and the scale.
  Eigen::Vector3d core_right_;
};

}  // namespace dgd_bench
