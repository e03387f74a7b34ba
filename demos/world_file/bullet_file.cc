#include "world_file/bullet_file.h"

#include <cctype>
#include <fstream>
#include <memory>
#include <string_view>
#include <utility>

#include "scene/scene_error.h"

namespace dgd_demos {
namespace {

constexpr std::size_t kHeaderSize = 12;
constexpr std::uintmax_t kGreatestFile = 256'000'000;  // bytes
constexpr std::int32_t kMostElements = 100'000'000;
// Constraints in double precision have structures of their own since 2.82; in older files, the importer guesses.
constexpr int kOldestVersion = 282;

struct Header {
  Precision precision;
  int version;
};

class Parser {
 public:
  Parser(const std::string& name, Bytes bytes) : name_(name), reader_(bytes) {}

  Header ReadHeader();
  std::vector<FileChunk> ReadChunks();
  Dna ReadDna() const;
  void CheckStructures(const Dna& dna, const std::vector<FileChunk>& chunks) const;

 private:
  FileChunk ReadChunk(std::size_t number);
  [[noreturn]] void Fail(const std::string& what) const { throw SceneError(name_ + ": " + what); }

  const std::string& name_;
  ByteReader reader_;
  Bytes dna_;
  std::size_t dna_position_ = 0;
};

Header Parser::ReadHeader() {
  const auto bytes = reader_.Take(kHeaderSize);
  if (!bytes) Fail("no world of Bullet's: it ends within the " + std::to_string(kHeaderSize) + " bytes of a header");
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  if (!text.starts_with("BULLET") || (text[6] != 'f' && text[6] != 'd')) {
    Fail("no world of Bullet's: it does not begin with BULLETf or BULLETd");
  }
  if (text[7] != '-') {
    Fail(text[7] == '_' ? "its pointers have 32 bits; write it with a Bullet of 64 bits"
                        : "the header's byte 7, for the size of pointers, is neither - nor _");
  }
  if (text[8] != 'v') {
    Fail(text[8] == 'V' ? "its numbers are big-endian; write it on a little-endian machine"
                        : "the header's byte 8, for the order of bytes, is neither v nor V");
  }
  int version = 0;
  for (const char digit : text.substr(9)) {
    if (digit < '0' || digit > '9') Fail("the header's version is no number of three digits");
    version = 10 * version + (digit - '0');
  }
  if (version < kOldestVersion) {
    Fail("Bullet " + VersionText(version) + " wrote it; Bullet " + VersionText(kOldestVersion) +
         " is the oldest that is read");
  }
  return {text[6] == 'd' ? Precision::kDouble : Precision::kFloat, version};
}

// The DNA is the last chunk, as Bullet writes it: Bullet reads nothing that follows.
std::vector<FileChunk> Parser::ReadChunks() {
  std::vector<FileChunk> chunks;
  while (true) {
    if (reader_.left() == 0) Fail("it ends after chunk " + std::to_string(chunks.size()) + ", without the DNA's");
    FileChunk chunk = ReadChunk(chunks.size());
    if (chunk.code == "DNA1") {
      dna_ = chunk.data;
      dna_position_ = chunk.position;
      break;
    }
    chunks.push_back(std::move(chunk));
  }
  if (reader_.left() > 0) {
    Fail(std::to_string(reader_.left()) + " bytes follow the last chunk, from byte " +
         std::to_string(reader_.position()) + " on");
  }
  return chunks;
}

FileChunk Parser::ReadChunk(std::size_t number) {
  const std::size_t position = reader_.position();
  const std::string place = "chunk " + std::to_string(number) + " at byte " + std::to_string(position);
  const auto code = reader_.Take(4);
  const auto length = reader_.Number<std::int32_t>();
  const auto pointer = reader_.Number<std::uint64_t>();
  const auto structure = reader_.Number<std::int32_t>();
  const auto count = reader_.Number<std::int32_t>();
  if (!count) Fail(place + " ends in its header, with the file");
  std::string letters(reinterpret_cast<const char*>(code->data()), code->size());
  for (const char letter : letters) {
    if (!std::isprint(static_cast<unsigned char>(letter))) Fail(place + " has a code that is not printable");
  }
  const std::string chunk = place + " (" + letters + ")";
  if (*length < 0) Fail(chunk + " has " + std::to_string(*length) + " bytes");
  if (*count < 0 || *count > kMostElements) Fail(chunk + " has " + std::to_string(*count) + " elements");
  if (*structure < -1) Fail(chunk + " is of structure " + std::to_string(*structure));
  const auto data = reader_.Take(static_cast<std::size_t>(*length));
  if (!data) {
    Fail(chunk + " has " + std::to_string(*length) + " bytes, and the file ends after " +
         std::to_string(reader_.left()));
  }
  return {std::move(letters), position, *pointer, *structure, static_cast<std::size_t>(*count), *data};
}

Dna Parser::ReadDna() const { return Dna(dna_, name_ + ": the DNA at byte " + std::to_string(dna_position_)); }

void Parser::CheckStructures(const Dna& dna, const std::vector<FileChunk>& chunks) const {
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const FileChunk& chunk = chunks[i];
    if (chunk.structure >= 0 && static_cast<std::size_t>(chunk.structure) >= dna.size()) {
      Fail("chunk " + std::to_string(i) + " at byte " + std::to_string(chunk.position) + " (" + chunk.code +
           ") is of structure " + std::to_string(chunk.structure) + ", and the DNA has " + std::to_string(dna.size()));
    }
  }
}

}  // namespace

const char* NameOf(Precision precision) { return precision == Precision::kFloat ? "float" : "double"; }

std::string VersionText(int version) {
  const int minor = version % 100;
  return std::to_string(version / 100) + (minor < 10 ? ".0" : ".") + std::to_string(minor);
}

BulletFile ParseBulletFile(std::string name, std::vector<std::byte> bytes) {
  auto shared = std::make_shared<const std::vector<std::byte>>(std::move(bytes));
  Parser parser(name, *shared);
  const Header header = parser.ReadHeader();
  std::vector<FileChunk> chunks = parser.ReadChunks();
  Dna dna = parser.ReadDna();
  parser.CheckStructures(dna, chunks);
  return {std::move(name), std::move(shared), header.precision, header.version, std::move(dna), std::move(chunks)};
}

BulletFile ReadBulletFile(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw SceneError(name + ": " + error.message());
  if (size > kGreatestFile) {
    throw SceneError(name + ": it has " + std::to_string(size) + " bytes; " + std::to_string(kGreatestFile) +
                     " is the most that is read");
  }
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw SceneError(name + ": it cannot be read");
  return ParseBulletFile(name, std::move(bytes));
}

}  // namespace dgd_demos
