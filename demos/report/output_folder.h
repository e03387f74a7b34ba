// Folders for results.
#pragma once

#include <filesystem>

namespace dgd_demos {

/// Makes a folder, with those that it is in, unless it is there.
/// @throws std::runtime_error with the folder and the reason if it cannot be made, as where a file has its name.
void MakeOutputFolder(const std::filesystem::path& folder);

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
