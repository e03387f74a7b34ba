#include "support/lp_oracle.h"

#include <glpk.h>

#include <Eigen/LU>
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace dgd_test {
namespace {

using Real = long double;
using Column = Eigen::Matrix<Real, 4, 1>;
using Basis = Eigen::Matrix<Real, 4, 4>;
using Problem = std::unique_ptr<glp_prob, decltype(&glp_delete_prob)>;

/// min <cost, x>, columns * x = right_hand_side, x >= 0.
struct StandardForm {
  std::vector<Column> columns;
  std::vector<Real> costs;
  Column right_hand_side;
};

// With z1 = sum of lambda_i v_i / alpha and the lambda_i summing to alpha, and z2 likewise, the problem is linear:
//   min sum lambda_i   s.t.   sum lambda_i (v_i - p1) - sum mu_j (w_j - p2) = p2 - p1,   sum lambda_i = sum mu_j.
// Lengths are relative to `size`, and the weights to |p2 - p1| / size, since GLPK's tolerances are absolute.
StandardForm MakeStandardForm(std::span<const Eigen::Vector3d> vertices_1, const Eigen::Vector3d& center_1,
                              std::span<const Eigen::Vector3d> vertices_2, const Eigen::Vector3d& center_2,
                              double size) {
  StandardForm form;
  const auto add = [&](const Eigen::Vector3d& vertex, const Eigen::Vector3d& center, int sign) {
    const Eigen::Matrix<Real, 3, 1> offset = (vertex - center).cast<Real>() * (Real(sign) / Real(size));
    form.columns.emplace_back(offset.x(), offset.y(), offset.z(), sign);
    form.costs.push_back(sign > 0 ? 1 : 0);
  };
  for (const Eigen::Vector3d& vertex : vertices_1) add(vertex, center_1, 1);
  for (const Eigen::Vector3d& vertex : vertices_2) add(vertex, center_2, -1);
  const Eigen::Matrix<Real, 3, 1> direction = (center_2 - center_1).cast<Real>().normalized();
  form.right_hand_side << direction, 0;
  return form;
}

/// The columns of the optimal basis, by GLPK; a row's own variable counts as -1 - row.
std::vector<int> SolveByGlpk(const StandardForm& form) {
  const Problem problem(glp_create_prob(), &glp_delete_prob);
  glp_set_obj_dir(problem.get(), GLP_MIN);
  glp_add_rows(problem.get(), 4);
  for (int row = 0; row < 4; ++row) {
    const double value = static_cast<double>(form.right_hand_side[row]);
    glp_set_row_bnds(problem.get(), row + 1, GLP_FX, value, value);
  }
  const int count = static_cast<int>(form.columns.size());
  glp_add_cols(problem.get(), count);
  for (int i = 0; i < count; ++i) {
    const Column& column = form.columns[static_cast<std::size_t>(i)];
    // GLPK counts from 1 and ignores element 0.
    const int rows[] = {0, 1, 2, 3, 4};
    const double values[] = {0, static_cast<double>(column[0]), static_cast<double>(column[1]),
                             static_cast<double>(column[2]), static_cast<double>(column[3])};
    glp_set_mat_col(problem.get(), i + 1, 4, rows, values);
    glp_set_col_bnds(problem.get(), i + 1, GLP_LO, 0, 0);
    glp_set_obj_coef(problem.get(), i + 1, static_cast<double>(form.costs[static_cast<std::size_t>(i)]));
  }
  glp_smcp settings;
  glp_init_smcp(&settings);
  settings.msg_lev = GLP_MSG_OFF;
  settings.tol_bnd = 1e-13;
  settings.tol_dj = 1e-13;
  const int error = glp_simplex(problem.get(), &settings);
  if (error != 0 || glp_get_status(problem.get()) != GLP_OPT) {
    throw std::runtime_error("GLPK: error " + std::to_string(error) + ", status " +
                             std::to_string(glp_get_status(problem.get())));
  }
  std::vector<int> basic;
  for (int row = 0; row < 4; ++row) {
    if (glp_get_row_stat(problem.get(), row + 1) == GLP_BS) basic.push_back(-1 - row);
  }
  for (int i = 0; i < count; ++i) {
    if (glp_get_col_stat(problem.get(), i + 1) == GLP_BS) basic.push_back(i);
  }
  return basic;
}

/// The optimal value from its basis; throws unless the basis is optimal to the last digits.
Real ValueOfBasis(const StandardForm& form, const std::vector<int>& basic) {
  if (basic.size() != 4) throw std::runtime_error("GLPK: a basis of " + std::to_string(basic.size()));
  Basis basis;
  Column costs;
  for (int i = 0; i < 4; ++i) {
    const int column = basic[static_cast<std::size_t>(i)];
    basis.col(i) = column < 0 ? Column(Column::Unit(-1 - column)) : form.columns[static_cast<std::size_t>(column)];
    costs[i] = column < 0 ? 0 : form.costs[static_cast<std::size_t>(column)];
  }
  const Eigen::FullPivLU<Basis> factors(basis);
  const Column values = factors.solve(form.right_hand_side);
  const Column prices = factors.inverse().transpose() * costs;
  Real worst = 0, largest = 1;
  for (int i = 0; i < 4; ++i) {
    largest = std::max(largest, std::abs(values[i]));
    // A row's own variable is fixed at zero.
    worst = std::max(worst, basic[static_cast<std::size_t>(i)] < 0 ? std::abs(values[i]) : -values[i]);
  }
  for (std::size_t i = 0; i < form.columns.size(); ++i) {
    worst = std::max(worst, (prices.dot(form.columns[i]) - form.costs[i]) * largest);
  }
  if (!(worst <= 1e-12L * largest)) {
    throw std::runtime_error("GLPK: its basis is not optimal, by " + std::to_string(static_cast<double>(worst)));
  }
  return costs.dot(values);
}

}  // namespace

double GrowthDistanceByLp(std::span<const Eigen::Vector3d> vertices_1, const Eigen::Vector3d& center_1,
                          std::span<const Eigen::Vector3d> vertices_2, const Eigen::Vector3d& center_2) {
  double size = 0;
  for (const Eigen::Vector3d& vertex : vertices_1) size = std::max(size, (vertex - center_1).norm());
  for (const Eigen::Vector3d& vertex : vertices_2) size = std::max(size, (vertex - center_2).norm());
  const StandardForm form = MakeStandardForm(vertices_1, center_1, vertices_2, center_2, size);
  const Real scaled = ValueOfBasis(form, SolveByGlpk(form));
  return static_cast<double>(scaled * (center_2 - center_1).cast<Real>().norm() / Real(size));
}

}  // namespace dgd_test
