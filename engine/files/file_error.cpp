#include "engine/files/file_error.h"

#include <cerrno>
#include <string>
#include <system_error>

namespace fulcrum {

namespace {

std::string reason_and_remedy(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return "the disk is full. Free some space, or choose a folder on another disk with --out.";
    case EDQUOT:
      return "your disk quota is used up. Remove files you no longer need, or choose a folder on another "
             "disk "
             "with --out.";
    case EFBIG:
      return "the file would grow beyond the allowed size. Raise the limit (ulimit -f), or choose a folder "
             "on "
             "another file system with --out.";
    case EIO:
      return "the disk reported a fault. Look at dmesg, and choose a folder on another disk with --out.";
    case EACCES:
    case EPERM:
      return "permission is refused. Change the permissions, or choose another place (for results: --out).";
    case EROFS:
      return "the file system is read-only. Choose a folder elsewhere with --out.";
    case EEXIST:
      return "it is there already. Choose another folder with --out, or replace the results in it with "
             "--force.";
    case ENOENT:
      return "it does not exist. Check the path.";
    case EMFILE:
    case ENFILE:
      return "too many files are open. Raise the limit (ulimit -n).";
    default:
      return std::generic_category().message(error_number) + ". Choose another file or folder.";
  }
}

}  // namespace

Error file_error(std::string_view doing, const std::filesystem::path& path, int error_number) {
  return {"Cannot " + std::string(doing) + ' ' + path.string() + ": " + reason_and_remedy(error_number)};
}

Error read_error(const std::filesystem::path& path, const Error& why) {
  return {"Cannot read " + path.string() + ": " + why.sentence + ". Check the path and its permissions."};
}

}  // namespace fulcrum
