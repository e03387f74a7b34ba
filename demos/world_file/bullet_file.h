// A .bullet file taken apart: header, chunks and DNA, each checked against the file's end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "world_file/byte_reader.h"
#include "world_file/dna.h"

namespace dgd_demos {

/// Whether a file is one of Bullet's worlds and not a scene, by its name.
inline bool IsWorldFile(const std::filesystem::path& file) { return file.extension() == ".bullet"; }

/// Precision of the numbers in a file, and of the Bullet that wrote it.
enum class Precision { kFloat, kDouble };
const char* NameOf(Precision precision);  ///< "float" or "double".

struct FileChunk {
  std::string code;       ///< Four letters: "RBDY" is a rigid body.
  std::size_t position;   ///< Offset in the file, bytes.
  std::uint64_t pointer;  ///< Address of the data when the file was written, by which other chunks refer to it.
  int structure;          ///< Number of its structure in the DNA; -1: plain letters.
  std::size_t count;      ///< Number of elements.
  Bytes data;             ///< count * the structure's size bytes, except in chunks that Bullet skips.
};

struct BulletFile {
  std::string name;                                     ///< Name of the file in messages.
  std::shared_ptr<const std::vector<std::byte>> bytes;  ///< Content of the file, of which the chunks' data are views.
  Precision precision;
  int version;  ///< 324 is Bullet 3.24.
  Dna dna;
  std::vector<FileChunk> chunks;  ///< All chunks but the DNA.
};

/// @param name  Name of the file in messages.
/// Files of another byte order or with 32-bit pointers are refused as well: Bullet's importer would convert them by
/// code that trusts them.
/// @throws SceneError in one sentence: name, place and value.
BulletFile ParseBulletFile(std::string name, std::vector<std::byte> bytes);

/// @throws SceneError, also if the file cannot be read or is larger than 256 MB.
BulletFile ReadBulletFile(const std::filesystem::path& file);

/// "3.24" for 324.
std::string VersionText(int version);

}  // namespace dgd_demos
