#include "support/pairs/set_numbers.h"

#include <limits>
#include <sstream>

namespace dgd_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// By way of memory: where it casts there and back two at a time, g++ 12 drops both casts, from -O2 on.
double RoundedToFloat(double number) {
  const volatile float rounded = static_cast<float>(number);
  return static_cast<double>(rounded);
}

template <class Matrix>
void RoundToFloat(Matrix& matrix) {
  for (double& number : matrix.reshaped()) number = RoundedToFloat(number);
}

void RoundToFloat(SetNumbers& set) {
  RoundToFloat(set.lengths);
  RoundToFloat(set.stretch);
  for (Vector3d& point : set.points) RoundToFloat(point);
  set.radius = RoundedToFloat(set.radius);
}

void RoundToFloat(PoseNumbers& pose) {
  RoundToFloat(pose.rotation);
  RoundToFloat(pose.translation);
}

std::string Row(const Vector3d& v) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "{" << v.x() << ", " << v.y() << ", " << v.z() << "}";
  return out.str();
}

std::string Rows(const Matrix3d& matrix) {
  return Row(matrix.row(0).transpose()) + ", " + Row(matrix.row(1).transpose()) + ", " + Row(matrix.row(2).transpose());
}

void Print(std::ostream& out, int number, const SetNumbers& set, const PoseNumbers& pose) {
  out << "set " << number << ": " << InfoOf(set.type).name << ", lengths " << Row(set.lengths) << ", radius "
      << set.radius;
  if (set.exponent > 0) out << ", exponent " << set.exponent;
  out << "\n";
  if (!set.stretch.isIdentity(0)) out << "  stretch, by rows " << Rows(set.stretch) << "\n";
  if (!set.points.empty()) out << "  points\n";
  for (const Vector3d& point : set.points) out << "    " << Row(point) << ",\n";
  out << "  rotation, by rows " << Rows(pose.rotation) << "\n  translation " << Row(pose.translation) << "\n";
}

}  // namespace

PairNumbers RoundedToFloat(const PairNumbers& pair) {
  PairNumbers rounded = pair;
  RoundToFloat(rounded.set_1);
  RoundToFloat(rounded.set_2);
  RoundToFloat(rounded.pose_1);
  RoundToFloat(rounded.pose_2);
  return rounded;
}

std::string Dump(const PairNumbers& pair) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  Print(out, 1, pair.set_1, pair.pose_1);
  Print(out, 2, pair.set_2, pair.pose_2);
  return out.str();
}

}  // namespace dgd_test
