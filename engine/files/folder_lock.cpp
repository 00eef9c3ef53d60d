#include "engine/files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

namespace fulcrum {

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  auto opened = std::make_unique<Descriptor>(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (*opened && ::flock(opened->number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return Error{"another run is writing into " + folder.string() +
                 ": wait for its end, or choose another folder with --out."};
  return FolderLock(std::move(opened));
}

}  // namespace fulcrum
