// Strict reading of JSON: every access checks, and every complaint names file, JSON path and value.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dgd_demos {

/// Parses the file. Beyond JSON's own rules, an object may not have the same key twice.
/// @throws SceneError with line and column if it is not JSON, or with the reason if it cannot be read.
nlohmann::json ParseJsonFile(const std::filesystem::path& file);

/// A range of numbers with its ends; both sides reject NaN.
struct Range {
  double low, high;
  bool low_is_allowed = true;
};

/// One value of a JSON document and the way to it. A view: it must not outlive the document. All members throw
/// SceneError on a value that is not what they promise.
class JsonReader {
 public:
  JsonReader(const std::string& file, const nlohmann::json& document) : file_(file), value_(document) {}

  bool Has(const std::string& key) const;
  bool IsArray() const { return value_.is_array(); }
  const nlohmann::json& value() const { return value_; }
  std::string Dump() const;                     ///< For a sentence: the value, or the beginning of a long one.
  JsonReader At(const std::string& key) const;  ///< The key must be there.
  JsonReader At(std::size_t index) const;
  std::size_t Size() const;     ///< Of an array.
  void ExpectDistinct() const;  ///< An array without two entries that are equal.

  /// An object with no keys but these.
  void AllowOnly(const std::vector<std::string_view>& keys) const;
  std::vector<std::string> Keys() const;  ///< Of an object, in alphabetical order.

  double Number(const Range& range) const;
  int Integer(int low, int high) const;
  bool Boolean() const;
  std::string Text() const;                          ///< A string that is not empty.
  Eigen::Vector3d Vector(const Range& range) const;  ///< Three numbers, each within the range.

  /// Complains about this value.
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  JsonReader(const std::string& file, const nlohmann::json& value, const nlohmann::json::json_pointer& path)
      : file_(file), value_(value), path_(path) {}

  const std::string& file_;
  const nlohmann::json& value_;
  nlohmann::json::json_pointer path_;
};

}  // namespace dgd_demos
