#include "scene/json_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

#include "scene/scene_error.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

std::string ReadText(const std::filesystem::path& file) {
  // A directory opens without complaint and reads as empty. What cannot be examined cannot be opened either.
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw SceneError(file.string() + ": is a directory, not a JSON file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw SceneError(file.string() + ": cannot be opened: " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(stream), {}};
}

// "line 3, column 14" of the last of the first `count` bytes.
std::string LineAndColumn(std::string_view text, std::size_t count) {
  const std::string_view before = text.substr(0, std::max<std::size_t>(count, 1) - 1);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0: the first line.
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - line_start + 1);
}

// What the parser complains of, without the number of its exception and without the place, which only some have.
std::string ReasonOf(const nlohmann::json::exception& error) {
  std::string reason = error.what();
  reason.erase(0, reason.find("] ") + 2);
  if (reason.starts_with("parse error at")) reason.erase(0, reason.find(": ") + 2);
  return reason;
}

// Accepts any JSON, and keeps the first complaint with its place. json::parse() itself takes the last of several equal
// keys, and gives no place for numbers that overflow.
class Checker : public nlohmann::json_sax<json> {
 public:
  explicit Checker(std::string_view text) : text_(text) {}
  const std::string& complaint() const { return complaint_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return true;
  }
  bool end_object() override {
    keys_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool key(string_t& name) override {
    const bool is_new = keys_.back().insert(name).second;
    if (!is_new) complaint_ = "the key \"" + name + "\" stands twice in one object";
    return is_new;
  }
  bool parse_error(std::size_t bytes_read, const std::string&, const nlohmann::json::exception& error) override {
    complaint_ = LineAndColumn(text_, bytes_read) + ": " + ReasonOf(error);
    return false;
  }

 private:
  std::string_view text_;
  std::vector<std::set<std::string>> keys_;  // One set for each object that is open.
  std::string complaint_;
};

std::string Describe(const Range& range) {
  std::ostringstream description;
  description << (range.low_is_allowed ? "from " : "above ") << range.low << " up to " << range.high;
  return description.str();
}

bool Contains(const Range& range, double number) {
  // Written so that NaN is outside.
  const bool above = range.low_is_allowed ? number >= range.low : number > range.low;
  return above && number <= range.high;
}

}  // namespace

json ParseJsonFile(const std::filesystem::path& file) {
  const std::string text = ReadText(file);
  Checker checker(text);
  if (!json::sax_parse(text, &checker)) throw SceneError(file.string() + ": " + checker.complaint());
  return json::parse(text);
}

std::string JsonReader::Dump() const {
  constexpr std::size_t kLongest = 80;
  std::string text = value_.dump();
  if (text.size() <= kLongest) return text;
  const auto is_inside_a_letter = [](char c) { return (c & 0xc0) == 0x80; };  // In UTF-8.
  std::size_t length = kLongest;
  while (is_inside_a_letter(text[length])) --length;
  return text.substr(0, length) + "...";
}

void JsonReader::Fail(const std::string& what) const {
  const std::string path = path_.empty() ? "top level" : path_.to_string();
  throw SceneError(file_ + ": " + path + ": " + what);
}

bool JsonReader::Has(const std::string& key) const { return value_.is_object() && value_.contains(key); }

JsonReader JsonReader::At(const std::string& key) const {
  const JsonReader missing(file_, value_, path_ / key);
  if (!value_.is_object()) Fail("must be an object, not " + Dump());
  if (!value_.contains(key)) missing.Fail("is missing");
  return {file_, value_.at(key), path_ / key};
}

JsonReader JsonReader::At(std::size_t index) const { return {file_, value_.at(index), path_ / index}; }

std::size_t JsonReader::Size() const {
  if (!value_.is_array()) Fail("must be an array, not " + Dump());
  return value_.size();
}

void JsonReader::ExpectDistinct() const {
  std::map<json, std::size_t> indices;
  for (std::size_t i = 0; i < Size(); ++i) {
    const auto [first, is_new] = indices.emplace(value_.at(i), i);
    if (!is_new) At(first->second).Fail("is there twice, " + At(i).Dump());
  }
}

std::vector<std::string> JsonReader::Keys() const {
  if (!value_.is_object()) Fail("must be an object, not " + Dump());
  std::vector<std::string> keys;
  for (const auto& [key, member] : value_.items()) keys.push_back(key);
  return keys;
}

void JsonReader::AllowOnly(const std::vector<std::string_view>& keys) const {
  if (!value_.is_object()) Fail("must be an object, not " + Dump());
  for (const auto& [key, member] : value_.items()) {
    if (std::ranges::find(keys, key) != keys.end()) continue;
    std::string known;
    for (const std::string_view name : keys) known += (known.empty() ? "" : ", ") + std::string(name);
    const JsonReader value(file_, member, path_ / key);
    value.Fail("is not a known key (with the value " + value.Dump() + "); known here: " + known);
  }
}

double JsonReader::Number(const Range& range) const {
  if (!value_.is_number()) Fail("must be a number, not " + Dump());
  const double number = value_.get<double>();
  if (!Contains(range, number)) Fail("must be " + Describe(range) + ", not " + Dump());
  return number;
}

int JsonReader::Integer(int low, int high) const {
  if (!value_.is_number_integer()) Fail("must be an integer, not " + Dump());
  Number({static_cast<double>(low), static_cast<double>(high)});
  return value_.get<int>();
}

bool JsonReader::Boolean() const {
  if (!value_.is_boolean()) Fail("must be true or false, not " + Dump());
  return value_.get<bool>();
}

std::string JsonReader::Text() const {
  if (!value_.is_string() || value_.get<std::string>().empty()) Fail("must be a text, not " + Dump());
  return value_.get<std::string>();
}

Eigen::Vector3d JsonReader::Vector(const Range& range) const {
  if (!value_.is_array() || value_.size() != 3) Fail("must be an array of 3 numbers, not " + Dump());
  Eigen::Vector3d vector;
  for (std::size_t i = 0; i < 3; ++i) vector[static_cast<Eigen::Index>(i)] = At(i).Number(range);
  return vector;
}

}  // namespace dgd_demos
