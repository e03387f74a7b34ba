// Folders for results.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace dgd_demos {

/// Makes a folder, with those that it is in, unless it is there.
/// @throws std::runtime_error with the folder and the reason if it cannot be made, as where a file has its name.
void MakeOutputFolder(const std::filesystem::path& folder);

/// What results are of, and where.
struct Results {
  std::filesystem::path folder;                    ///< As the user has named it.
  std::string label;                               ///< Name of the file that says what results are there: "run.json".
  nlohmann::json identity;                         ///< All that they depend on, as an object of names and values.
  std::function<bool(const std::string&)> is_own;  ///< Whether a file's name is one that the results may have.
};

/// Makes the folder and labels it. Results that it has of the same identity are replaced as they are written. Those of
/// another, or without a label, are refused, unless they are to be replaced: then they are removed, with a word on
/// standard error.
/// @throws std::runtime_error with the folder, what differs and what can be done.
void ClaimFolder(const Results& results, bool replaces_others);

/// While it exists, no other process of this machine can have one for the same folder.
class FolderLock {
 public:
  /// @pre the folder is there.
  /// @throws std::runtime_error if another process has it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace dgd_demos
