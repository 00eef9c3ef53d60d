#pragma once
// That one program at a time writes into a folder.

#include <filesystem>
#include <memory>
#include <utility>

#include "engine/files/descriptor.h"
#include "haptics/math/result.h"

namespace fulcrum {

// Held until it goes, at the latest with the program, however that ends; no program that it starts has it.
// Nothing lies in the folder for it.
class FolderLock {
public:
  FolderLock() = default;  // of no folder
  // Errors: another program, or this one, holds that folder's. Where a folder cannot be locked, as on
  // NFS or where it may not be listed, there is none to hold, and nobody is kept from it.
  static Result<FolderLock> take(const std::filesystem::path& folder);

private:
  explicit FolderLock(std::unique_ptr<Descriptor> folder) : folder_(std::move(folder)) {}

  std::unique_ptr<Descriptor> folder_;
};

}  // namespace fulcrum
