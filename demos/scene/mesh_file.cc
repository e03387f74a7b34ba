#include "scene/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <stdexcept>
#include <vector>

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> MeshVertices(const aiScene& scene, double scale) {
  std::vector<Vector3d> vertices;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& vertex = mesh.mVertices[i];
      vertices.emplace_back(scale * vertex.x, scale * vertex.y, scale * vertex.z);
    }
  }
  return vertices;
}

}  // namespace

Polyhedron LoadConvexMesh(const std::filesystem::path& file, double scale) {
  Assimp::Importer importer;
  // Pre-transformed: the vertices of all nodes in one frame.
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());

  Polyhedron hull = ConvexHull(MeshVertices(*scene, scale));
  const Vector3d centre_of_mass = Centroid(hull);
  for (Vector3d& vertex : hull.vertices) vertex -= centre_of_mass;
  return hull;
}

}  // namespace dgd_demos
