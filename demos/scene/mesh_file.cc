#include "scene/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cstring>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kGreatestMeshFile = 1 << 30;  // Bytes.

// From the origin, m; as for positions in scenes.
constexpr double kFarthest = 1e4;

// @return its size in bytes.
std::uint64_t CheckIsFile(const std::filesystem::path& file) {
  const auto fail = [] { throw std::runtime_error(std::string("it cannot be read: ") + std::strerror(errno)); };
  const int descriptor = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) fail();
  struct stat status = {};
  const int error = fstat(descriptor, &status);
  close(descriptor);
  if (error != 0) fail();
  if (S_ISDIR(status.st_mode)) throw std::runtime_error("it is a folder");
  if (!S_ISREG(status.st_mode)) throw std::runtime_error("it is no regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > kGreatestMeshFile) {
    throw std::runtime_error("it has " + std::to_string(size) + " bytes; " + std::to_string(kGreatestMeshFile) +
                             " is the most that is read");
  }
  return size;
}

// Coordinates of all vertices, as in the file.
std::string ImportVertices(const std::filesystem::path& file) {
  Assimp::Importer importer;
  // Pre-transformed: the vertices of all nodes in one frame.
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) {
    if (std::string_view(importer.GetErrorString()) == std::bad_alloc().what()) throw std::bad_alloc();
    throw std::runtime_error(importer.GetErrorString());
  }
  std::string coordinates;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Vector3d vertex(mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z);
      coordinates.append(reinterpret_cast<const char*>(vertex.data()), sizeof vertex);
    }
  }
  return coordinates;
}

std::vector<Vector3d> ScaledVertices(const std::string& coordinates, double scale) {
  std::vector<Vector3d> vertices(coordinates.size() / sizeof(Vector3d));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Vector3d& vertex = vertices[i];
    std::memcpy(vertex.data(), coordinates.data() + i * sizeof vertex, sizeof vertex);
    vertex *= scale;
    if (vertex.cwiseAbs().maxCoeff() <= kFarthest && vertex.allFinite()) continue;
    std::ostringstream complaint;
    complaint << "a vertex is at (" << vertex.x() << ", " << vertex.y() << ", " << vertex.z()
              << ") m; each coordinate must be from " << -kFarthest << " to " << kFarthest << " m";
    throw std::runtime_error(complaint.str());
  }
  return vertices;
}

}  // namespace

// About ten times what importers take of formats with one number in ten bytes.
ChildLimits ImportLimits(std::uint64_t file_size) {
  const std::uint64_t megabytes = file_size >> 20;
  const auto seconds = static_cast<unsigned>(4 + 2 * megabytes);
  const auto machine =
      static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return {seconds, 6 * seconds, std::min((1024 + 128 * megabytes) << 20, machine)};
}

Polyhedron LoadConvexMesh(const std::filesystem::path& file, double scale, std::optional<ChildLimits> limits) {
  const std::uint64_t size = CheckIsFile(file);
  if (!limits) limits = ImportLimits(size);
  const std::string coordinates = RunInChild(
      "its import", [&] { return ImportVertices(file); }, *limits);
  Polyhedron hull = ConvexHull(ScaledVertices(coordinates, scale));
  const Vector3d centre_of_mass = Centroid(hull);
  for (Vector3d& vertex : hull.vertices) vertex -= centre_of_mass;
  return hull;
}

}  // namespace dgd_demos
