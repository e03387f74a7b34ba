// A record file of any bytes: what it holds up to the damage, or an exception that says that it is none. Checksums
// would stop nearly all changes at the first block, so that they are made right first, where a block is whole.
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "dgd_bullet/record_file.h"
#include "fuzz/fuzz_target.h"
#include "record_format.h"

namespace dgd_fuzz {
namespace {

namespace record = dgd_bullet::record;

/// Of the bytes before it.
void MendChecksum(std::string& file, std::size_t begin, std::size_t end) {
  const record::Checksum checksum = record::ChecksumOf(std::string_view(file).substr(begin, end - begin));
  std::memcpy(file.data() + end, &checksum, sizeof(checksum));
}

void MendChecksums(std::string& file) {
  constexpr std::size_t kChecksum = sizeof(record::Checksum);
  if (file.size() < record::kHeaderSize) return;
  MendChecksum(file, 0, record::kHeaderSize - kChecksum);
  std::size_t begin = record::kHeaderSize;
  while (file.size() - begin >= record::kBlockHeadSize + kChecksum) {
    std::uint32_t size = 0;
    std::memcpy(&size, file.data() + begin + sizeof(std::uint32_t), sizeof(size));
    if (size > file.size() - begin - record::kBlockHeadSize - kChecksum) return;
    const std::size_t end = begin + record::kBlockHeadSize + size;
    MendChecksum(file, begin, end);
    begin = end + kChecksum;
  }
}

}  // namespace
}  // namespace dgd_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dgd_fuzz;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  MendChecksums(bytes);
  std::istringstream file(bytes);
  try {
    const dgd_bullet::Record record = dgd_bullet::ReadRecord(file, "record");
    for (const dgd_bullet::RecordedPair& pair : record.pairs) {
      if (pair.shape_1 >= record.shapes.size() || pair.shape_2 >= record.shapes.size())
        Fail("a pair without its shapes");
    }
    if (record.problem && record.problem->empty()) Fail("a problem that says nothing");
  } catch (const std::runtime_error& error) {
    if (std::string_view(error.what()).substr(0, 8) != "record: ") Fail("an error that does not name the file");
  }
  return 0;
}
