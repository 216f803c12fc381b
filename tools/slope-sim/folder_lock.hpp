#pragma once

#include <filesystem>

namespace slope::tools {

/// Keeps other programs of this kind out of a folder for as long as it lives; the system takes it away with the
/// program, however that ends. Where the file system knows no locks of folders, it keeps nobody out.
class FolderLock {
 public:
  /// @throws couple::FileError if another program has the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace slope::tools
