#include "render/light_samples.h"

#include <cmath>
#include <numbers>

#include "render/shortest_turn.h"

namespace dgd_demos {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The sun: high on the left, behind the camera's left shoulder. Its disc is larger than the real one, for soft edges.
const Vector3d kSunDirection = Vector3d(-0.55, -0.55, 1.0).normalized();
constexpr double kSunDiscRadius = 0.07;  // Tangent of the angle from its centre to its rim.
constexpr double kSunStrength = 0.75;
constexpr double kSkyStrength = 0.45;  // Irradiance of open ground by the whole sky.
constexpr double kLowestSky = 0.08;    // Sine of the elevation; grazing light only blurs.

// Each spiral turns by the golden angle from point to point, which spreads any number of points evenly.
double GoldenAngle(int index) { return index * std::numbers::pi * (3 - std::sqrt(5.0)); }

LightSample SunSample(int index, int count) {
  const double radius = kSunDiscRadius * std::sqrt((index + 0.5) / count);
  const Vector3d on_disc(radius * std::cos(GoldenAngle(index)), radius * std::sin(GoldenAngle(index)), 1);
  return {ShortestTurn(Vector3d::UnitZ(), kSunDirection) * on_disc.normalized(), kSunStrength};
}

LightSample SkySample(int index, int count) {
  const double sine = kLowestSky + (1 - kLowestSky) * (index + 0.5) / count;  // Even over the sphere's area.
  const double cosine = std::sqrt(1 - sine * sine);
  const Vector3d direction(cosine * std::cos(GoldenAngle(index)), cosine * std::sin(GoldenAngle(index)), sine);
  const double mean_sine = (1 + kLowestSky) / 2;
  return {direction, kSkyStrength / mean_sine};
}

// Van der Corput's sequence: the digits of `index` mirrored at the decimal point.
double RadicalInverse(int index, int base) {
  double value = 0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) value += digit * (index % base);
  return value;
}

}  // namespace

LightSample LightOfPass(int pass, int count) {
  const int half = count / 2;
  LightSample sample = pass % 2 == 0 ? SunSample(pass / 2, count - half) : SkySample(pass / 2, half);
  sample.strength *= 2;  // Each kind has half of the passes.
  return sample;
}

Vector2d JitterOfPass(int pass) {
  // The sun's passes and the sky's each cover the whole pixel.
  const int index = pass / 2 + 1;
  return {RadicalInverse(index, 2) - 0.5, RadicalInverse(index, 3) - 0.5};
}

}  // namespace dgd_demos
