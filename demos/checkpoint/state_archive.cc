#include "checkpoint/state_archive.h"

#include <cstring>
#include <stdexcept>

namespace dgd_demos {

void StateArchive::Serialize(bool& value) {
  auto byte = static_cast<unsigned char>(value);
  SerializeBytes(&byte, 1);
  Require(byte <= 1, "what is true or false is neither");
  value = byte != 0;
}

void StateArchive::Serialize(std::string& text) {
  text.resize(SerializeCount(text.size()));
  SerializeBytes(text.data(), text.size());
}

void StateArchive::Expect(std::uint64_t number, const char* what) {
  std::uint64_t written = number;
  Serialize(written);
  if (written != number) {
    Fail("it has " + std::to_string(written) + " " + what + ", not " + std::to_string(number));
  }
}

void StateArchive::ExpectEnd() const {
  if (read_ != bytes_.size()) Fail("it is longer than the state that is read from it");
}

void StateArchive::Fail(const std::string& what) const { throw std::runtime_error(place_ + ": " + what); }

void StateArchive::SerializeBytes(void* value, std::size_t size) {
  if (!is_reading_) {
    bytes_.append(static_cast<const char*>(value), size);
    return;
  }
  if (size > bytes_.size() - read_) Fail("it ends within a value");
  if (size > 0) std::memcpy(value, bytes_.data() + read_, size);
  read_ += size;
}

std::size_t StateArchive::SerializeCount(std::size_t count) {
  std::uint64_t written = count;
  Serialize(written);
  // Every element has at least a byte, so that a damaged count is found before memory is reserved for it.
  if (is_reading_ && written > bytes_.size() - read_) Fail("it ends within a list");
  return static_cast<std::size_t>(written);
}

}  // namespace dgd_demos
