#include "engine/files/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <system_error>
#include <utility>

#include "engine/files/descriptor.h"

namespace fulcrum {
namespace {

Error why(int error_number) {
  return {std::generic_category().message(error_number)};
}

// Empty for a file as it should be.
const char* why_not(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFREG:
      return "";
    case S_IFDIR:
      return "it is a folder, not a file";
    case S_IFIFO:
      return "it is a pipe, not a file";
    case S_IFSOCK:
      return "it is a socket, not a file";
    default:
      return "it is a device, not a file";
  }
}

std::filesystem::path in_proc(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

// Where a descriptor's file lies, whatever names and links led to it. Empty where the system does not tell.
std::string place_of(int descriptor) {
  std::string place(PATH_MAX, '\0');
  const ssize_t size = ::readlink(in_proc(descriptor).c_str(), place.data(), place.size());
  place.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return place;
}

bool lies_in(const std::string& place, std::string folder) {
  if (!folder.ends_with('/')) folder += '/';
  return folder.starts_with('/') && place.starts_with(folder);
}

}  // namespace

// O_PATH gives a handle without opening: a pipe does not wait and a device does nothing. What has been looked
// at through it is what is opened, whatever has become of the name meanwhile.
//
// openat2() and RESOLVE_BENEATH would refuse a link that is absolute or goes out and comes back, and are
// missing in some containers and under qemu-user.
Result<RegularFile> RegularFile::open(const std::filesystem::path& path) {
  const Descriptor handle(::open(path.c_str(), O_PATH | O_CLOEXEC));
  if (!handle) return why(errno);
  return open_handle(handle.number());
}

Result<RegularFile> RegularFile::open_within(const std::filesystem::path& folder,
                                             const std::filesystem::path& path) {
  const Descriptor inside(::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!inside) return why(errno);
  const Descriptor handle(::openat(inside.number(), path.c_str(), O_PATH | O_CLOEXEC));
  if (!handle) return why(errno);
  if (!lies_in(place_of(handle.number()), place_of(inside.number())))
    return Error{"it leads out of the folder " + folder.string() + "; copy the file there"};
  return open_handle(handle.number());
}

Result<RegularFile> RegularFile::open_handle(int handle) {
  struct stat status {};
  if (::fstat(handle, &status) != 0) return why(errno);
  if (const char* const reason = why_not(status.st_mode); *reason != '\0') return Error{reason};
  // O_NONBLOCK: what is a file by its mode may still wait, such as the system's own logs.
  const int descriptor = ::open(in_proc(handle).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return why(errno);
  return RegularFile(descriptor, static_cast<std::uint64_t>(status.st_size));
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

RegularFile::~RegularFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<std::string> RegularFile::first_bytes(std::uint64_t most) const {
  constexpr std::uint64_t kStep = 1 << 16;
  std::string bytes;
  // The size is a hint alone: the file may grow meanwhile, and those of /proc have none.
  std::uint64_t wanted = std::min(most, size_ + 1);
  while (bytes.size() < most) {
    const std::size_t begin = bytes.size();
    bytes.resize(static_cast<std::size_t>(std::min(most, std::max(wanted, begin + kStep))));
    const ssize_t got =
        ::pread(descriptor_, bytes.data() + begin, bytes.size() - begin, static_cast<off_t>(begin));
    const int error_number = errno;
    bytes.resize(begin + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0 && error_number != EINTR) return why(error_number);
    if (got == 0) break;
  }
  return bytes;
}

Result<std::size_t> RegularFile::read_on(char* to, std::size_t size) {
  for (;;) {
    const ssize_t got = ::read(descriptor_, to, size);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) return why(errno);
  }
}

}  // namespace fulcrum
