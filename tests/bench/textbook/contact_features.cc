#include "bench/textbook/contact_features.h"

#include "bench/textbook/ray_basis.h"

namespace dgd_bench {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kMaxIterations = 100;

/// Relative gap below which Newton's steps are tried and derivatives evaluated. By measurement on support functions
/// over hulls (the class dsf of bench/pair_class.h): 0.1 and 1 are no faster; without a limit 1 % fewer evaluations,
/// but all with derivatives.
constexpr double kNear = 0.3;

/// How far off the ray the point may be at which the basis meets it, as a part of its height. Without this limit, 1 %
/// of the answers were off by more than 1e-9 of the sets' extent.
constexpr double kRounding = 1e-12;

/// The ray from 0 along p against C = (C1 - p1) - (C2 - p2), as the dual problem: with the normal (u, 1) in a frame
/// whose last axis is along p, the lowest height g(u) = s_C(u, 1) at which a supporting plane meets the ray. g is
/// convex and twice differentiable; its gradient is the part across the ray of the support point, its Hessian that
/// point's derivative.
class ContactFeatureQuery {
 public:
  ContactFeatureQuery(const DifferentiableSupportFunction& set_1, const dgd::Pose<double>& pose_1,
                      const DifferentiableSupportFunction& set_2, const dgd::Pose<double>& pose_2)
      : set_1_(set_1),
        set_2_(set_2),
        pose_1_(pose_1),
        pose_2_(pose_2),
        center_1_(pose_1 * set_1.Center()),
        center_2_(pose_2 * set_2.Center()),
        p_(center_2_ - center_1_),
        frame_(dgd::FrameAlong<double>(Vector3d(p_.normalized()))),
        inradius_1_(set_1.Inradius()),
        inradius_2_(set_2.Inradius()),
        basis_(p_, InitialFacet<3>(p_, inradius_1_, inradius_2_)) {}

  /// Newton's step from the lowest plane; from the same plane not twice: after a step that led no lower, and far from
  /// the minimum, where it would lead anywhere, the cutting plane instead.
  void Step() {
    const bool is_near = upper_ <= (1 + kNear) * lower_;
    Vector2d u = Vector2d::Zero();
    if (has_newton_step_) {
      u = best_u_ - best_hessian_.inverse() * best_gradient_;
    } else if (has_plane_) {
      const Vector3d normal = frame_.transpose() * basis_.Normal();
      u = normal.head<2>() / normal.z();
    }
    Evaluate(u, is_near);
  }

  bool HasConverged(double tolerance) const { return upper_ / lower_ - 1 < tolerance; }

  dgd::Result<double> MakeResult(bool is_optimal, int iterations) const {
    dgd::Result<double> result;
    result.status = is_optimal ? dgd::Status::kOptimal : dgd::Status::kIterationLimit;
    result.iterations = iterations;
    result.lower_bound = 1 / upper_;
    result.upper_bound = 1 / lower_;
    result.normal = (frame_ * best_u_.homogeneous()).normalized();
    result.separation = (1 - upper_) * result.normal.dot(p_);
    result.witness_1 = center_1_ + witness_1_;
    result.witness_2 = center_2_ + witness_2_;
    return result;
  }

 private:
  void Evaluate(const Vector2d& u, bool with_derivative) {
    const Vector3d normal = frame_ * u.homogeneous();
    const Vector3d local_1 = pose_1_.rotation.transpose() * normal, local_2 = pose_2_.rotation.transpose() * -normal;
    Vector3d on_1, on_2;
    Matrix3d derivative;
    if (with_derivative) {
      const dgd::CurvedPoint<double> curved_1 = set_1_.CurvedSupport(local_1), curved_2 = set_2_.CurvedSupport(local_2);
      on_1 = curved_1.point;
      on_2 = curved_2.point;
      const Matrix3d to_1 = pose_1_.rotation.transpose() * frame_, to_2 = pose_2_.rotation.transpose() * frame_;
      derivative = to_1.transpose() * curved_1.derivative * to_1 + to_2.transpose() * curved_2.derivative * to_2;
    } else {
      on_1 = set_1_.Support(local_1);
      on_2 = set_2_.Support(local_2);
    }
    on_1 = pose_1_ * on_1 - center_1_;
    on_2 = pose_2_ * on_2 - center_2_;
    const Vector3d z = on_1 - on_2;
    basis_.Insert({z, on_1});
    RaiseLower(on_1, on_2);

    const double upper = normal.dot(z) / p_.norm();
    has_newton_step_ = false;
    if (!(upper < upper_)) return;
    upper_ = upper;
    best_u_ = u;
    has_plane_ = true;
    if (!with_derivative) return;
    has_newton_step_ = true;
    best_gradient_ = (frame_.transpose() * z).head<2>();
    best_hessian_ = derivative.topLeftCorner<2, 2>();
  }

  /// By the basis, or by the new point and the ball of the inradius: what is off the ray of the one is made up for by
  /// the other. That is the bound which a small gradient proves.
  void RaiseLower(const Vector3d& on_1, const Vector3d& on_2) {
    if (basis_.Lower() > lower_) TakeBasis();
    const double inradius = inradius_1_ + inradius_2_;
    const Vector3d z = on_1 - on_2;
    const double along = z.dot(p_) / p_.squaredNorm();
    const Vector3d across = z - along * p_;
    const double weight = inradius / (inradius + across.norm());
    if (!(weight * along > lower_)) return;
    lower_ = weight * along;
    witness_1_ = weight * (on_1 - inradius_1_ / inradius * across);
    witness_2_ = weight * (on_2 + inradius_2_ / inradius * across);
  }

  /// Unless it is a sliver, whose weights are all rounding.
  void TakeBasis() {
    const RayFacet<3>& facet = basis_.Facet();
    const Vector3d witness_1 = basis_.Lower() * (facet.of_1 * basis_.Weights());
    const Vector3d witness_2 = basis_.Lower() * ((facet.of_1 - facet.of_c) * basis_.Weights());
    const Vector3d on_ray = basis_.Lower() * p_;
    if (!((witness_1 - witness_2 - on_ray).norm() <= kRounding * on_ray.norm())) return;
    lower_ = basis_.Lower();
    witness_1_ = witness_1;
    witness_2_ = witness_2;
  }

  const DifferentiableSupportFunction& set_1_;
  const DifferentiableSupportFunction& set_2_;
  const dgd::Pose<double>& pose_1_;
  const dgd::Pose<double>& pose_2_;
  const Vector3d center_1_, center_2_, p_;
  const Matrix3d frame_;
  const double inradius_1_, inradius_2_;

  RayBasis<3> basis_;
  double lower_ = 0, upper_ = std::numeric_limits<double>::infinity();    // Of the ray's length in C over |p|.
  Vector3d witness_1_ = Vector3d::Zero(), witness_2_ = Vector3d::Zero();  // About the centres, of the lower.

  // The lowest plane.
  bool has_plane_ = false, has_newton_step_ = false;
  Vector2d best_u_ = Vector2d::Zero(), best_gradient_ = Vector2d::Zero();
  Matrix2d best_hessian_ = Matrix2d::Zero();
};

}  // namespace

dgd::Result<double> ContactFeatureGrowthDistance(const DifferentiableSupportFunction& set_1,
                                                 const dgd::Pose<double>& pose_1,
                                                 const DifferentiableSupportFunction& set_2,
                                                 const dgd::Pose<double>& pose_2, double tolerance) {
  ContactFeatureQuery query(set_1, pose_1, set_2, pose_2);
  int iterations = 0;
  do {
    query.Step();
    ++iterations;
  } while (!query.HasConverged(tolerance) && iterations < kMaxIterations);
  return query.MakeResult(query.HasConverged(tolerance), iterations);
}

}  // namespace dgd_bench
