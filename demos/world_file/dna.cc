#include "world_file/dna.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>
#include <utility>

#include "scene/scene_error.h"

namespace dgd_demos {
namespace {

constexpr std::size_t kPointerSize = 8;
// Bullet 3.24 has 438 names of at most 45 letters, and arrays of at most 7 elements.
constexpr std::int32_t kMostTexts = 10'000;
constexpr std::size_t kLongestText = 200;
constexpr std::size_t kMostElements = 10'000;

struct NumberType {
  std::string_view name;
  std::size_t size;
};
constexpr std::array kNumberTypes = {NumberType{"char", 1}, NumberType{"short", 2}, NumberType{"int", 4},
                                     NumberType{"float", 4}, NumberType{"double", 8}};

bool IsNumber(std::string_view type) {
  return std::ranges::find(kNumberTypes, type, &NumberType::name) != kNumberTypes.end();
}

// "*m_name"; "(*m_function)()" is one of Blender's.
bool IsPointer(std::string_view name) { return name.starts_with('*') || name.starts_with('('); }

/// Number of elements of "[3]" or "[3][4]"; 0 if the text is neither.
std::size_t ElementCount(const std::string& brackets) {
  std::istringstream text(brackets);
  std::size_t count = 1, extent = 0;
  for (char open = 0, close = 0; text >> open;) {
    if (open != '[' || !(text >> extent >> close) || close != ']' || extent > kMostElements) return 0;
    count *= extent;
    if (count > kMostElements) return 0;
  }
  return count;
}

std::size_t RoundUp(std::size_t number, std::size_t step) { return (number + step - 1) / step * step; }

bool IsVector(std::string_view structure) {
  return structure == "btVector3FloatData" || structure == "btVector3DoubleData";
}

}  // namespace

Dna::Dna(Bytes bytes, const std::string& place) : place_(place) {
  ByteReader reader(bytes);
  ExpectTag(reader, "SDNA");
  ReadNames(reader);
  ReadTypes(reader);
  ReadLengths(reader);
  ReadStructures(reader);
  if (reader.left() > 0) Fail(std::to_string(reader.left()) + " bytes follow the last structure");
}

void Dna::Fail(const std::string& what) const { throw SceneError(place_ + ": " + what); }

void Dna::ExpectTag(ByteReader& reader, std::string_view tag) const {
  const auto bytes = reader.Take(tag.size());
  if (!bytes || std::memcmp(bytes->data(), tag.data(), tag.size()) != 0) {
    Fail("there is no \"" + std::string(tag) + "\" at byte " + std::to_string(reader.position()) + " of it");
  }
}

// Each part begins at a multiple of four bytes.
void Dna::Align(ByteReader& reader) const {
  const std::size_t padding = (4 - reader.position() % 4) % 4;
  if (!reader.Take(padding)) Fail("it ends early");
}

std::vector<std::string> Dna::ReadTexts(ByteReader& reader, const std::string& what) const {
  const auto count = reader.Number<std::int32_t>();
  if (!count) Fail("it ends before the number of " + what);
  if (*count < 1 || *count > kMostTexts) {
    Fail("the number of " + what + " is " + std::to_string(*count) + ", not one of 1 to " + std::to_string(kMostTexts));
  }
  std::vector<std::string> texts;
  for (std::int32_t i = 0; i < *count; ++i) {
    auto text = reader.Text();
    if (!text) Fail("it ends in the " + what);
    if (text->size() > kLongestText) Fail("one of the " + what + " has " + std::to_string(text->size()) + " letters");
    for (const char letter : *text) {
      if (!std::isprint(static_cast<unsigned char>(letter))) Fail("one of the " + what + " is not printable");
    }
    texts.push_back(std::move(*text));
  }
  Align(reader);
  return texts;
}

void Dna::ReadNames(ByteReader& reader) {
  ExpectTag(reader, "NAME");
  names_ = ReadTexts(reader, "names");
}

void Dna::ReadTypes(ByteReader& reader) {
  ExpectTag(reader, "TYPE");
  types_ = ReadTexts(reader, "types");
}

void Dna::ReadLengths(ByteReader& reader) {
  ExpectTag(reader, "TLEN");
  for (const std::string& type : types_) {
    const auto length = reader.Number<std::int16_t>();
    if (!length) Fail("it ends in the lengths of types");
    if (*length < 0) Fail("the length of " + type + " is " + std::to_string(*length));
    lengths_.push_back(static_cast<std::size_t>(*length));
    const auto number = std::ranges::find(kNumberTypes, type, &NumberType::name);
    if (number != kNumberTypes.end() && number->size != lengths_.back()) {
      Fail("the length of " + type + " is " + std::to_string(*length));
    }
  }
  Align(reader);
}

void Dna::ReadStructures(ByteReader& reader) {
  ExpectTag(reader, "STRC");
  const auto count = reader.Number<std::int32_t>();
  if (!count) Fail("it ends before the number of structures");
  if (*count < 1 || *count > kMostTexts) Fail("the number of structures is " + std::to_string(*count));
  for (std::int32_t i = 0; i < *count; ++i) {
    Structure structure = ReadStructure(reader);
    if (!numbers_.emplace(structure.name, structures_.size()).second) Fail(structure.name + " is described twice");
    structures_.push_back(std::move(structure));
  }
}

Dna::Structure Dna::ReadStructure(ByteReader& reader) {
  const auto type = reader.Number<std::int16_t>();
  const auto field_count = reader.Number<std::int16_t>();
  if (!type || !field_count) Fail("it ends in the structures");
  if (*type < 0 || static_cast<std::size_t>(*type) >= types_.size()) {
    Fail("structure " + std::to_string(structures_.size()) + " is of type " + std::to_string(*type) + " of " +
         std::to_string(types_.size()));
  }
  Structure structure{types_[static_cast<std::size_t>(*type)], 0, 1, {}};
  if (IsNumber(structure.name)) Fail(structure.name + " is described as a structure");
  if (*field_count < 0) Fail(structure.name + " has " + std::to_string(*field_count) + " fields");
  std::set<std::string> names;
  std::size_t sum = 0;  // Length of the fields without padding, which is the structure's by the DNA.
  for (int i = 0; i < *field_count; ++i) {
    Field field = ReadField(reader, structure, sum);
    if (!names.insert(field.name).second) Fail(structure.name + " has two fields " + field.name);
    structure.size = field.offset + field.size;
    structure.fields.push_back(std::move(field));
  }
  structure.size = RoundUp(structure.size, structure.alignment);
  const std::size_t length = lengths_[static_cast<std::size_t>(*type)];
  if (sum != length) {
    Fail(structure.name + " is said to be " + std::to_string(length) + " bytes long, and its fields are " +
         std::to_string(sum));
  }
  return structure;
}

Dna::Field Dna::ReadField(ByteReader& reader, Structure& structure, std::size_t& sum) const {
  const auto type = reader.Number<std::int16_t>();
  const auto name = reader.Number<std::int16_t>();
  if (!type || !name) Fail("it ends in " + structure.name);
  if (*type < 0 || static_cast<std::size_t>(*type) >= types_.size() || *name < 0 ||
      static_cast<std::size_t>(*name) >= names_.size()) {
    Fail("a field of " + structure.name + " has type " + std::to_string(*type) + " and name " + std::to_string(*name));
  }
  const std::string& written = names_[static_cast<std::size_t>(*name)];
  Field field{types_[static_cast<std::size_t>(*type)], written, IsPointer(written), 1, 0, 0};
  const Structure* inner = field.is_pointer ? nullptr : Find(field.type);
  const bool is_known = field.is_pointer || IsNumber(field.type) || inner != nullptr;
  if (!is_known) Fail(structure.name + " contains " + field.type + ", which is no number and not described before");
  field.name.erase(0, field.name.find_first_not_of("*("));
  const std::size_t bracket = field.name.find('[');
  if (bracket != std::string::npos) {
    field.count = ElementCount(field.name.substr(bracket));
    if (field.count < 1 || field.count > kMostElements) Fail(structure.name + " has no such array: " + written);
    field.name.erase(bracket);
  }
  const std::size_t length = field.is_pointer ? kPointerSize : lengths_[static_cast<std::size_t>(*type)];
  const std::size_t alignment = inner != nullptr ? inner->alignment : length;
  sum += field.count * length;
  field.size = field.count * (inner != nullptr ? inner->size : length);
  field.offset = RoundUp(structure.size, alignment);
  structure.alignment = std::max(structure.alignment, alignment);
  return field;
}

const Dna::Structure* Dna::Find(std::string_view name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? nullptr : &structures_[found->second];
}

bool Dna::IsSameIn(const Dna& other, std::string_view name) const {
  const Structure* mine = Find(name);
  const Structure* others = other.Find(name);
  if (mine == nullptr || others == nullptr) return mine == others;
  if (*mine != *others) return false;
  for (const Field& field : mine->fields) {
    if (!field.is_pointer && !IsSameIn(other, field.type)) return false;
  }
  return true;
}

Dna::Location Dna::Locate(const Structure& structure, std::string_view path) const {
  const std::size_t dot = path.find('.');
  const std::string_view first = path.substr(0, dot);
  for (const Field& field : structure.fields) {
    if (field.name != first) continue;
    if (dot == std::string_view::npos) return {field.offset, &field};
    const Structure* inner = field.is_pointer ? nullptr : Find(field.type);
    if (inner == nullptr) break;
    const Location rest = Locate(*inner, path.substr(dot + 1));
    return {field.offset + rest.offset, rest.field};
  }
  Fail(structure.name + " has no field " + std::string(path));
}

void Dna::ForEachNumber(const Field& field, const std::function<void(std::size_t, std::string_view)>& visit) const {
  if (field.is_pointer) return;
  const Structure* structure = Find(field.type);
  const std::size_t element = field.size / field.count;
  for (std::size_t i = 0; i < field.count; ++i) {
    if (structure == nullptr) {
      visit(i * element, field.type);
      continue;
    }
    for (const Field& inner : structure->fields) {
      Field counted = inner;
      if (IsVector(structure->name)) {
        counted.count = 3;
        counted.size = inner.size / inner.count * 3;
      }
      ForEachNumber(counted, [&](std::size_t offset, std::string_view type) {
        visit(i * element + inner.offset + offset, type);
      });
    }
  }
}

void Dna::ForEachPointer(const Structure& structure, const std::function<void(std::size_t)>& visit) const {
  for (const Field& field : structure.fields) {
    const Structure* inner = field.is_pointer ? nullptr : Find(field.type);
    if (!field.is_pointer && inner == nullptr) continue;
    const std::size_t element = field.size / field.count;
    for (std::size_t i = 0; i < field.count; ++i) {
      const std::size_t offset = field.offset + i * element;
      if (field.is_pointer) {
        visit(offset);
      } else {
        ForEachPointer(*inner, [&](std::size_t deeper) { visit(offset + deeper); });
      }
    }
  }
}

}  // namespace dgd_demos
