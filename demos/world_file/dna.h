// The description of structures that a .bullet file carries, by Blender's name for it: DNA. It lists names of fields,
// types with their lengths, and the structures that these make up.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "world_file/byte_reader.h"

namespace dgd_demos {

/// Offsets and sizes are those of the compiled structure, by its fields' alignment. The DNA has none: it takes fields
/// as one after the other, for which Bullet's structures are padded, but btHingeConstraintDoubleData2 is not.
class Dna {
 public:
  struct Field {
    std::string type;  ///< Name of a number's type ("float") or of a structure.
    std::string name;  ///< Name without star and brackets.
    bool is_pointer;
    std::size_t count;   ///< Number of elements of an array; else 1.
    std::size_t offset;  ///< Offset in its structure, bytes.
    std::size_t size;    ///< Size of all elements, bytes.

    bool operator==(const Field&) const = default;
  };
  struct Structure {
    std::string name;
    std::size_t size;       ///< Bytes.
    std::size_t alignment;  ///< Bytes.
    std::vector<Field> fields;

    bool operator==(const Structure&) const = default;
  };
  /// A field at any depth, as seen from the outermost structure.
  struct Location {
    std::size_t offset;
    const Field* field;
  };

  /// Checks everything: counts, ends, indices, lengths, and that structures contain only those that precede them, which
  /// rules out that one contains itself.
  /// @throws SceneError that begins with `place`.
  Dna(Bytes bytes, const std::string& place);

  std::size_t size() const { return structures_.size(); }
  const Structure& At(std::size_t number) const { return structures_[number]; }
  const Structure* Find(std::string_view name) const;

  /// Whether the structure and all that it contains are the same in both, to the byte.
  bool IsSameIn(const Dna& other, std::string_view name) const;

  /// @param path  as in C++: "m_collisionObjectData.m_worldTransform".
  /// @throws SceneError if there is no such field.
  Location Locate(const Structure& structure, std::string_view path) const;

  /// Visits all numbers of a field's elements, with their offset from the field's and their type ("float", "int").
  /// Bullet leaves the fourth number of a vector as it finds it, so that is skipped.
  void ForEachNumber(const Field& field, const std::function<void(std::size_t, std::string_view)>& visit) const;
  /// Visits the offsets of all pointers in a structure.
  void ForEachPointer(const Structure& structure, const std::function<void(std::size_t)>& visit) const;

 private:
  void ReadNames(ByteReader& reader);
  void ReadTypes(ByteReader& reader);
  void ReadLengths(ByteReader& reader);
  void ReadStructures(ByteReader& reader);
  Structure ReadStructure(ByteReader& reader);
  Field ReadField(ByteReader& reader, Structure& structure, std::size_t& sum) const;
  std::vector<std::string> ReadTexts(ByteReader& reader, const std::string& what) const;
  void ExpectTag(ByteReader& reader, std::string_view tag) const;
  void Align(ByteReader& reader) const;
  [[noreturn]] void Fail(const std::string& what) const;

  std::string place_;
  std::vector<std::string> names_, types_;  // The texts as they are in the file.
  std::vector<std::size_t> lengths_;        // Lengths of the types, bytes.
  std::vector<Structure> structures_;
  std::map<std::string, std::size_t, std::less<>> numbers_;  // Numbers of the structures, by name.
};

}  // namespace dgd_demos
