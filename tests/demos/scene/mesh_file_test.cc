// Contract: a mesh file of any content gives a hull, or a sentence within the time and the memory that its import has.
#include "scene/mesh_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "small_scenes.h"

namespace dgd_demos {
namespace {

constexpr ChildLimits kLimits = {1, 10, 256 << 20};

const std::string kPly = R"(ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
)";

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

constexpr float kFacets[4][3][3] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                    {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                    {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}};

std::string AsciiStl() {
  std::string text = "solid a\n";
  for (const auto& facet : kFacets) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const auto& v : facet) {
      text += "vertex " + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid a\n";
}

std::string BinaryStl(std::uint32_t count = 4) {
  std::string bytes(80, ' ');
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& facet : kFacets) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(facet), sizeof facet);
    bytes.append(2, '\0');
  }
  return bytes;
}

class MeshFileTest : public testing::Test {
 protected:
  ~MeshFileTest() override { EXPECT_TRUE(waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) << "a child is left"; }

  // Why the file gives no hull; empty if it gives one.
  static std::string ComplaintAbout(const std::filesystem::path& file) {
    try {
      const Polyhedron hull = LoadConvexMesh(file, 1, kLimits);
      EXPECT_TRUE(hull.IsSolid());
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()), "");
      return error.what();
    } catch (const std::invalid_argument& error) {  // Qhull's.
      return error.what();
    }
    return "";
  }
  std::string ComplaintAbout(const std::string& name, const std::string& content) const {
    return ComplaintAbout(folder_.Write(name, content));
  }

  TestFolder folder_;
};

std::string Replaced(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t place = text.find(old_part);
  EXPECT_NE(place, std::string::npos) << old_part;
  return text.replace(place, old_part.size(), new_part);
}

TEST_F(MeshFileTest, Formats_AreRead) {
  EXPECT_EQ(ComplaintAbout("a.ply", kPly), "");
  EXPECT_EQ(ComplaintAbout("a.obj", kObj), "");
  EXPECT_EQ(ComplaintAbout("a.stl", AsciiStl()), "");
  EXPECT_EQ(ComplaintAbout("b.stl", BinaryStl()), "");
}

TEST_F(MeshFileTest, DamageThatCrashesImporters_IsASentence) {
  EXPECT_EQ(ComplaintAbout("a.ply", Replaced(kPly, "3 1 2 3", "3 1 -1 3")), "its import crashed (Segmentation fault)");
  EXPECT_EQ(ComplaintAbout("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n"),
            "its import takes more than 1 s of processor time");
  const std::string complaint = ComplaintAbout("a.ply", Replaced(kPly, "vertex 4", "vertex 4000000000"));
  EXPECT_TRUE(complaint == "its import takes more than 256 MB of memory" ||
              complaint == "its import crashed (status 1)")  // A sanitizer's word for it.
      << complaint;
}

TEST_F(MeshFileTest, WhatIsNoFile_IsNamed) {
  EXPECT_EQ(ComplaintAbout(folder_.path() / "none.ply"), "it cannot be read: No such file or directory");
  std::filesystem::create_directory(folder_.path() / "folder.obj");
  EXPECT_EQ(ComplaintAbout(folder_.path() / "folder.obj"), "it is a folder");
  ASSERT_EQ(mkfifo((folder_.path() / "pipe.stl").c_str(), 0600), 0);
  EXPECT_EQ(ComplaintAbout(folder_.path() / "pipe.stl"), "it is no regular file");
  EXPECT_EQ(ComplaintAbout("/dev/zero"), "it is no regular file");
  folder_.Write("sparse.stl", "");
  std::filesystem::resize_file(folder_.path() / "sparse.stl", std::uintmax_t(1) << 40);
  EXPECT_EQ(ComplaintAbout(folder_.path() / "sparse.stl"),
            "it has 1099511627776 bytes; 1073741824 is the most that is read");
  const std::filesystem::path locked = folder_.Write("locked.obj", kObj);
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (access(locked.c_str(), R_OK) != 0) {  // Root may read anything.
    EXPECT_EQ(ComplaintAbout(locked), "it cannot be read: Permission denied");
  }
  for (const std::string name : {"a.ply", "a.stl", "a.obj", "a.dae", "a.gltf", "a.3ds", "a.off"}) {
    EXPECT_NE(ComplaintAbout(name, ""), "") << name;
  }
}

TEST_F(MeshFileTest, CoordinatesOutOfRange_AreNamed) {
  for (const std::string number : {"inf", "1e300", "-1e5"}) {
    const std::string complaint = ComplaintAbout("a.ply", Replaced(kPly, "1 0 0\n", number + " 0 0\n"));
    EXPECT_NE(complaint.find(" m; each coordinate must be from -10000 to 10000 m"), std::string::npos) << complaint;
  }
}

// Cut after every line, or with any number exchanged; within the head of a PLY file, whose every cut takes all the time
// that there is, only the latter.
TEST_F(MeshFileTest, DamagedText_IsAHullOrASentence) {
  int hulls = 0, errors = 0;
  const auto examine = [&](const std::string& name, const std::string& text) {
    ++(ComplaintAbout(name, text).empty() ? hulls : errors);
  };
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>("a.ply", kPly), {"a.obj", kObj}, {"a.stl", AsciiStl()}}) {
    const std::size_t head = name == "a.ply" ? text.find("end_header") : 0;
    for (std::size_t i = text.find('\n', head); i != std::string::npos; i = text.find('\n', i + 1)) {
      examine(name, text.substr(0, i));
    }
    constexpr const char* kDigits = "0123456789.";
    int number = 0;
    for (std::size_t i = text.find_first_of(kDigits); i != std::string::npos; i = text.find_first_of(kDigits, i)) {
      const std::size_t end = std::min(text.find_first_not_of(kDigits, i), text.size());
      const std::vector<std::string> others = {"-1", "99999999", "4000000000", "nan", "x", ""};
      const std::string& other = others[static_cast<std::size_t>(number++) % others.size()];
      examine(name, text.substr(0, i) + other + text.substr(end));
      i = end;
    }
  }
  std::printf("%d hulls, %d errors\n", hulls, errors);
  EXPECT_GT(hulls, 20);
  EXPECT_GT(errors, 20);
}

TEST_F(MeshFileTest, DamagedBinaryFile_IsAHullOrASentence) {
  const std::string bytes = BinaryStl();
  for (std::size_t length = 0; length < bytes.size(); length += 13) {
    EXPECT_NE(ComplaintAbout("a.stl", bytes.substr(0, length)), "") << length;
  }
  for (const std::uint32_t count : {0u, 5u, 50'000'000u, 0xffffffffu}) {
    EXPECT_NE(ComplaintAbout("a.stl", BinaryStl(count)), "") << count;
  }
  for (std::size_t i = 0; i < bytes.size(); i += 5) {
    std::string damaged = bytes;
    damaged[i] = '\xff';
    ComplaintAbout("a.stl", damaged);
  }
}

}  // namespace
}  // namespace dgd_demos
