#include "engine/files/put_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "engine/files/descriptor.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPart = ".part";

bool write_all(int descriptor, Pieces pieces) {
  for (std::span<const std::byte> piece : pieces) {
    while (!piece.empty()) {
      const ssize_t written = ::write(descriptor, piece.data(), piece.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      piece = piece.subspan(static_cast<std::size_t>(written));
    }
  }
  return true;
}

// "x.yaml.4711.part", "x.yaml.4711-3.part": with the number of a process. Other programs have files that end
// in .part, too.
bool is_a_part(std::string_view name) {
  if (!name.ends_with(kPart)) return false;
  name.remove_suffix(kPart.size());
  const std::size_t dot = name.rfind('.');
  return dot != name.npos && dot > 0 && dot + 1 < name.size() &&
         name.find_first_not_of("0123456789-", dot + 1) == name.npos;
}

// A part that is being written is locked by who writes it, and the lock goes with the process.
void remove_abandoned(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code fault;
  fs::directory_iterator entry(folder, fault);
  while (!fault && entry != fs::directory_iterator()) {
    std::error_code gone;
    if (is_a_part(entry->path().filename().native()) && fs::is_regular_file(entry->symlink_status(gone)))
      parts.push_back(entry->path());
    entry.increment(fault);
  }
  for (const fs::path& part : parts) {
    const Descriptor file(::open(part.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
    if (file && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0) fs::remove(part, fault);
  }
}

// Gives a file without a name this one. A link does not replace what is there, so that it comes by way of a
// part, which does.
bool name_file(int descriptor, const fs::path& path) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return false;
  fs::path part = path;
  part += "." + std::to_string(::getpid()) + "-" + std::to_string(descriptor);
  part += kPart;
  const std::string unnamed = "/proc/self/fd/" + std::to_string(descriptor);
  if (::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, part.c_str(), AT_SYMLINK_FOLLOW) != 0) return false;
  if (::rename(part.c_str(), path.c_str()) == 0) return true;
  ::unlink(part.c_str());
  return false;
}

}  // namespace

bool put_file(const fs::path& path, Pieces pieces) {
  std::error_code fault;
  fs::create_directories(path.parent_path(), fault);
  {
    const Descriptor file(::open(path.parent_path().c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666));
    if (file && write_all(file.number(), pieces) && name_file(file.number(), path)) {
      remove_abandoned(path.parent_path());
      return true;
    }
  }
  return put_file_by_part(path, pieces);
}

bool put_file_by_part(const fs::path& path, Pieces pieces) {
  std::error_code fault, fault_of_folder;
  fs::create_directories(path.parent_path(), fault_of_folder);
  remove_abandoned(path.parent_path());
  fs::path part = path;
  part += "." + std::to_string(::getpid());
  part += kPart;
  const Descriptor file(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file) {
    // A folder that could not be made is why, and not that it is missing.
    if (errno == ENOENT && fault_of_folder) errno = fault_of_folder.value();
    return false;
  }
  const bool written = ::flock(file.number(), LOCK_EX | LOCK_NB) == 0 && write_all(file.number(), pieces) &&
                       ::rename(part.c_str(), path.c_str()) == 0;
  const int why_not = errno;
  if (!written) fs::remove(part, fault);
  errno = why_not;
  return written;
}

}  // namespace fulcrum
