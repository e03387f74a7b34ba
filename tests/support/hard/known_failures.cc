// Numbers that made other engines fail, from their public issues: facts, rebuilt here as pairs. FCL's and Bullet's
// boxes are given by their edges, not by half of them.
#include <Eigen/Geometry>
#include <initializer_list>
#include <vector>

#include "support/hard/draw.h"

namespace dgd_test::hard {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

struct KnownFailure {
  const char* name;
  PairNumbers pair;
};

SetNumbers Box(double x, double y, double z) {
  SetNumbers set;
  set.type = SetType::kBox;
  set.lengths = Vector3d(x, y, z) / 2;
  return set;
}
/// About the z axis.
SetNumbers CylinderOf(double radius, double length) {
  SetNumbers set;
  set.type = SetType::kCylinder;
  set.lengths = {radius, length / 2, 0};
  return set;
}
SetNumbers Sphere(double radius) {
  SetNumbers set;
  set.radius = radius;
  return set;
}
SetNumbers CapsuleOf(double radius, double half_length) {
  SetNumbers set;
  set.type = SetType::kSegment;
  set.lengths.x() = half_length;
  set.radius = radius;
  return set;
}
SetNumbers PointsOf(SetType type, std::initializer_list<Vector3d> points) {
  SetNumbers set;
  set.type = type;
  set.points = points;
  return set;
}

PoseNumbers At(double x, double y, double z) { return {Matrix3d::Identity(), {x, y, z}}; }
PoseNumbers At(double x, double y, double z, const Quaterniond& turn) {
  return {turn.normalized().toRotationMatrix(), {x, y, z}};
}
/// By rows, the translation at each one's end.
PoseNumbers Rows(std::initializer_list<double> numbers) {
  PoseNumbers pose;
  const double* number = numbers.begin();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.rotation(row, column) = *number++;
    pose.translation[row] = *number++;
  }
  return pose;
}

/// A quarter turn about z.
Quaterniond QuarterAboutZ() { return {0.707107, 0, 0, 0.707107}; }
/// From an axis along z to one along y.
Quaterniond ZToY() { return Quaterniond(Eigen::AngleAxisd(-1.5707963267948966, Vector3d::UnitX())); }

void AddBullets(std::vector<KnownFailure>& list) {
  // The sphere overlaps all three; in float, Bullet found fewer.
  for (const double z : {0.3925, 0.3975, 0.4025}) {
    list.push_back(
        {"bullet3 #2579",
         {Sphere(0.01), Box(0.005, 0.005, 0.005), At(0.019576, -1.03115, 0.398155), At(0.0275, -1.0275, z)}});
  }
  // A floor 128 times as wide as the box on it, and no margin.
  for (const double sunk : {0.0, 0.001, 0.01}) {
    list.push_back({"bullet3 #1703", {Box(256, 2, 256), Box(2, 2, 2), At(0, 0, 0), At(7.3, 2 - sunk, -11.9)}});
  }
}

void AddFclBoxes(std::vector<KnownFailure>& list) {
  const PoseNumbers shelf = Rows({0, -1, 0, 0.8, 1, 0, 0, -0.4575, 0, 0, 1, 1.0225});
  list.push_back(
      {"fcl #390",
       {Box(0.03, 0.12, 0.1), Box(0.025, 0.35, 1.845),
        Rows({-3.0627937852578681533e-08, -0.99999999999999888978, -2.8893865161583314238e-08, 0.63499979627350811029,
              0.9999999999999980016, -3.0627939739957803544e-08, 6.4729926918527511769e-08, -0.48500002215636439651,
              -6.4729927722963847085e-08, -2.8893863029448751323e-08, 0.99999999999999711342, 1.0778146458339641356}),
        shelf}});
  list.push_back(
      {"fcl #395",
       {Box(0.46, 0.48, 0.01), Box(0.049521, 0.146, 0.0725), At(-0.721, -0.772, 0.81),
        Rows({0.10758262492983036718, -0.6624881850015212903, -0.74130653817877356637, -0.42677133002999478872,
              0.22682184885125472595, -0.709614040775253474, 0.6670830248314786326, -0.76596851247746788882,
              -0.96797615037608542021, -0.23991106241273435495, 0.07392465377049164954, 0.80746731400091054098})}});
  list.push_back(
      {"fcl #398", {Box(0.614, 3, 0.37), Box(0.494, 0.552, 0.01), At(-0.675, 0, 0.9115), At(-0.692, 0, 0.935)}});
  list.push_back({"fcl #398, as first reported",
                  {Box(0.614, 3, 0.037), Box(0.494, 0.552, 0.01), At(-0.675, 0, 0.9115), At(-0.692, 0, 0.935)}});
  list.push_back({"fcl #399",
                  {Box(0.23768037557601928711, 0.15702305734157562256, 0.25), Box(0.01, 0.78165709972381591797, 0.25),
                   Rows({-0.099432387353076273628, 0.99504432079443971837, 0, 0.29526406526565551758,
                         -0.99504432079443971837, -0.099432387353076273628, 0, -0.013230856508016586304, 0, 0, 1, 0}),
                   Rows({0.99506598442099225554, 0.099215354901756730444, 0, 0.22759585694545214629,
                         -0.099215354901756730444, 0.99506598442099225554, 0, 0.14974093549228112421, 0, 0, 1, 0})}});
  list.push_back(
      {"fcl #415",
       {Box(0.49, 0.05, 0.21), Box(0.035, 0.12, 0.03),
        Rows({4.8966386501092529215e-12, -1, 0, -0.43999999999999994671, 1, 4.8966386501092529215e-12, 0,
              -0.61499999999858001587, 0, 0, 1, 0.35499999999999998224}),
        Rows({0.83512153565236335595, -0.55006546945762568868, -9.4542360608233572896e-16, -0.40653441507331000704,
              0.55006546945762568868, 0.83512153565236313391, 1.1787444236552387666e-15, -0.69166166923735727945,
              1.2902271444330665572e-16, -1.4878153530113264589e-15, 1, 0.43057093858718892276})}});
  list.push_back({"fcl #428",
                  {Box(0.2, 0.33, 0.1), Box(0.452, 0.27, 0.6), At(-0.071000000000000035305, -0.772, 0.8),
                   At(0.12099999999999999645, -0.78769605692727695523, 0.53422044196125151316)}});
  list.push_back(
      {"drake #21673",
       {Box(0.05, 0.55, 0.3), Box(0.25, 0.2, 0.15),
        Rows({0.00079632671073326442932, -0.99999968293183538748, 0, 0.75000000000000055511, 0.99999968293183538748,
              0.00079632671073326442932, 0, -2.4083553715553102684e-15, 0, 0, 1, 0.14999999999999999445}),
        Rows({6.1232339957367660359e-17, 0, 1, 0.75, -1, 6.1232339957367660359e-17, 6.1232339957367660359e-17, 0,
              -6.1232339957367660359e-17, -1, 3.7493994566546440196e-33, 0.14999999999999999445})}});
}

/// Stacked and tilted, apart by less than the rounding of their poses.
void AddFclKisses(std::vector<KnownFailure>& list) {
  list.push_back(
      {"fcl #493",
       {Box(0.5, 0.5, 0.5), Box(0.5, 0.5, 0.5),
        Rows({0.96193976625564348026, 0.15401279915737359216, 0.22572537250328919556, 2.0770063995786869349,
              -0.19134171618254486313, 0.96936494951283913579, 0.15401279915737359216, 0.48468247475641951239,
              -0.19509032201612822033, -0.19134171618254486313, 0.96193976625564348026, 1.1543291419087275962}),
        Rows({0.96193976625564348026, 0.15401279915737359216, 0.22572537250328919556, 2, -0.19134171618254486313,
              0.96936494951283913579, 0.15401279915737359216, 0, -0.19509032201612822033, -0.19134171618254486313,
              0.96193976625564348026, 1.25})}});
  Matrix3d tilted;
  tilted << 0.94096063217417758029, 0.29296840037289501035, 0.16959541586174811667, -0.23569836841299879326,
      0.92661523595848427348, -0.29296840037289506586, -0.2429801799032638987, 0.23569836841299884878,
      0.94096063217417758029;
  for (const double size : {0.01, 0.25, 10.0, 1000.0}) {
    for (const double gap : {-1e-15, 0.0, 2.5e-16}) {
      const Vector3d base(0, 0, 5 * size);
      const Vector3d way(0, size + gap * std::max(1.0, size), 0);
      list.push_back(
          {"fcl #495", {Box(size, size, size), Box(size, size, size), {tilted, base}, {tilted, base + tilted * way}}});
    }
  }
}

void AddFclRound(std::vector<KnownFailure>& list) {
  const PoseNumbers shelf = Rows({0, -1, 0, 0.8, 1, 0, 0, -0.4575, 0, 0, 1, 1.0225});
  list.push_back({"fcl #319",
                  {Box(0.05, 0.39, 1.47), CylinderOf(0.18, 0.18), At(0.8, -0.385, 0.735, QuarterAboutZ()),
                   At(0.4, -0.4, 0.93, {0.991445, 0, 0, -0.130526})}});
  list.push_back(
      {"fcl #388",
       {CylinderOf(0.05, 0.06), Box(0.025, 0.35, 1.845),
        Rows({-0.99999999997999022838, 6.2572835802045040178e-10, 6.3260669852976095481e-06, 0.57500009756757608503,
              6.3260669851683709551e-06, -6.3943303429958554955e-10, 0.99999999997999056145, -0.42711963046787942977,
              6.2573180158128459924e-10, 1, 6.3942912945996747041e-10, 1.1867093358746836351}),
        shelf}});
  list.push_back(
      {"fcl #390, cylinder",
       {CylinderOf(0.05, 0.06), Box(0.025, 0.35, 1.845),
        Rows({-0.97313010759279283679, -0.12202804064972551379, 0.19526123781136842106, 0.87472781461138560122,
              0.20950801135757171623, -0.11745920593569325607, 0.97072639199619581429, -0.4038687881347159947,
              -0.095520609678929752073, 0.98555187191549953329, 0.13986894183635001365, 1.5871328698116491385}),
        shelf}});
  list.push_back(
      {"fcl #391",
       {CylinderOf(0.03, 0.65), Sphere(0.055), At(0.6, 0, 0.325), At(0.5419794018, -0.0621175025, 0.6016236576)}});
  list.push_back(
      {"fcl #408",
       {Sphere(0.06), Box(0.1, 0.1, 0.1),
        At(1.7855056639081962376e-10, 0.039999999999999993894, 0.33000000000000012657), At(0.05, 0.15, 0.35)}});
}

void AddOthers(std::vector<KnownFailure>& list) {
  list.push_back({"ncollide #157",
                  {CylinderOf(0.5, 1.85), Box(0.1, 1.5, 1), At(10.97, 0.925, 61.02, ZToY()), At(11.50, 0.75, 60.5)}});
  list.push_back({"libccd #25", {Box(2, 2, 2), Box(2, 2, 2), At(0, 0, 0), At(0, 0, 1.9)}});
  list.push_back({"libccd #17", {Box(5, 5, 5), Box(0.2, 0.2, 0.2), At(0, 0, -2.5), At(1.3, -0.7, 0.099)}});
  for (const double half : {1.0, 10.0, 100.0}) {
    list.push_back({"mujoco_warp #1430",
                    {Box(2 * half, 2 * half, 0.5), Box(0.2, 0.2, 0.2), At(0, 0, 0.25), At(0, 0, 0.6 - 1e-4)}});
  }
  list.push_back({"genesis #2525", {Sphere(0.1), Sphere(0.08), At(0, 0, 0), At(0.08, 0.06, 0.06)}});
  // A wall two hundred times as long as wide, which GJK takes for a segment.
  list.push_back({"jolt #2065",
                  {CapsuleOf(0.25, 0.5),
                   PointsOf(SetType::kTriangle, {{-0.228017807, -28.1085911, 0.140446782},
                                                 {-0.252283931, 173.436920, 0.0938473940},
                                                 {-0.252283931, 172.436920, 0.0938473940}}),
                   At(0, 0, 0, ZToY()), At(0, 0, 0)}});
  list.push_back({"jolt #41",
                  {Box(0.6, 1.6, 0.2),
                   PointsOf(SetType::kTriangle, {{0.279280782, -0.467894495, 0.105353981},
                                                 {0.280091137, -0.467545986, 0.104968153},
                                                 {0.277769983, -0.469322920, 0.105590254}}),
                   At(0, 0, 0), At(0, 0, 0)}});
}

const std::vector<KnownFailure>& AllKnownFailures() {
  static const std::vector<KnownFailure> list = [] {
    std::vector<KnownFailure> all;
    AddBullets(all);
    AddFclBoxes(all);
    AddFclKisses(all);
    AddFclRound(all);
    AddOthers(all);
    return all;
  }();
  return list;
}

const KnownFailure& KnownFailureOf(int index) {
  return AllKnownFailures()[static_cast<std::size_t>(index) % AllKnownFailures().size()];
}

}  // namespace

int KnownFailureCount() { return static_cast<int>(AllKnownFailures().size()); }
const char* NameOfKnownFailure(int index) { return KnownFailureOf(index).name; }

HardCase DrawKnownFailures(Random& random, int index) {
  HardCase hard_case{KnownFailureOf(index).pair};
  // First as they were reported, then elsewhere, and the other way round.
  if (index >= KnownFailureCount()) {
    MoveBoth(random, hard_case.pair);
    if (random.Flip()) {
      std::swap(hard_case.pair.set_1, hard_case.pair.set_2);
      std::swap(hard_case.pair.pose_1, hard_case.pair.pose_2);
    }
  }
  return hard_case;
}

}  // namespace dgd_test::hard
