#include "engine/session/credentials.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "engine/files/file_error.h"
#include "engine/files/plain_text.h"
#include "engine/files/regular_file.h"
#include "engine/files/utf8.h"

namespace fulcrum::session {
namespace {

constexpr std::size_t kLongestLine = 4096;  // bytes

// What is asked is the open file: whatever becomes of the name meanwhile, this is what is read.
std::optional<Error> why_no_secret(const RegularFile& file, const std::string& name) {
  struct stat status {};
  if (::fstat(file.descriptor(), &status) != 0 || status.st_uid != ::geteuid())
    return Error{"The file of credentials " + name +
                 " belongs to another user. Write one of your own, and make it yours alone: chmod 600 FILE."};
  if ((status.st_mode & 07777 & ~0600u) != 0)
    return Error{"The file of credentials " + name +
                 " has other rights than to be read and written by you. Make it yours alone: chmod 600 " +
                 name + "."};
  return std::nullopt;
}

}  // namespace

Result<Credentials> read_credentials(const std::filesystem::path& path) {
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return read_error(path, file.error());
  const std::string name = plain_text(path.string());
  if (const auto fault = why_no_secret(*file, name)) return *fault;
  const Result<std::string> bytes = file->first_bytes(kLongestLine + 1);
  if (!bytes) return read_error(path, bytes.error());
  std::string line = bytes->substr(0, bytes->find('\n'));
  if (line.ends_with('\r')) line.pop_back();
  const std::size_t colon = line.find(':');
  const bool whole =
      line.size() <= kLongestLine && colon != line.npos && colon > 0 && colon + 1 < line.size();
  // libcurl takes both as C strings, and a header has no place for the other control characters.
  const auto controls = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  if (!whole || utf8_bytes(line) != line.size() || std::ranges::any_of(line, controls))
    return Error{
        "The first line of the file of credentials " + name +
        " is not in the form USER:PASSWORD. Write it as the learning record store's page of keys gives it."};
  return Credentials{.user = line.substr(0, colon), .password = line.substr(colon + 1)};
}

}  // namespace fulcrum::session
