#include "engine/files/file_error.h"

#include <cerrno>
#include <string>
#include <system_error>

namespace fulcrum {

namespace {

struct Reason {
  std::string why, remedy;
  std::string remedy_by_out;  // where --out names the place
};

Reason reason_of(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return {"the disk is full", "Free some space.",
              "Free some space, or choose a folder on another disk with --out."};
    case EDQUOT:
      return {"your disk quota is used up", "Remove files you no longer need.",
              "Remove files you no longer need, or choose a folder on another disk with --out."};
    case EFBIG:
      return {"the file would grow beyond the allowed size", "Raise the limit (ulimit -f).",
              "Raise the limit (ulimit -f), or choose a folder on another file system with --out."};
    case EIO:
      return {"the disk reported a fault", "Look at dmesg.",
              "Look at dmesg, and choose a folder on another disk with --out."};
    case EACCES:
    case EPERM:
      return {"permission is refused", "Make it and its folder yours.",
              "Change the permissions, or choose another place (for results: --out)."};
    case EROFS:
      return {"the file system is read-only", "Mount it so that it can be written.",
              "Choose a folder elsewhere with --out."};
    case EEXIST:
      return {"it is there already", "Move it away.",
              "Choose another folder with --out, or replace the results in it with --force."};
    case ENOENT:
      return {"it does not exist", "Check the path.", "Check the path."};
    case EMFILE:
    case ENFILE:
      return {"too many files are open", "Raise the limit (ulimit -n).", "Raise the limit (ulimit -n)."};
    default:
      return {std::generic_category().message(error_number), "See that its folder is one, and yours.",
              "Choose another file or folder."};
  }
}

std::string cannot(std::string_view doing, const std::filesystem::path& path, const Reason& reason) {
  return "Cannot " + std::string(doing) + ' ' + path.string() + ": " + reason.why + ". ";
}

}  // namespace

Error file_error(std::string_view doing, const std::filesystem::path& path, int error_number) {
  const Reason reason = reason_of(error_number);
  return {cannot(doing, path, reason) + reason.remedy_by_out};
}

Error kept_file_error(std::string_view doing, const std::filesystem::path& path, int error_number) {
  const Reason reason = reason_of(error_number);
  return {cannot(doing, path, reason) + reason.remedy};
}

Error read_error(const std::filesystem::path& path, const Error& why) {
  return {"Cannot read " + path.string() + ": " + why.sentence + ". Check the path and its permissions."};
}

}  // namespace fulcrum
