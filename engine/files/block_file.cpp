#include "engine/files/block_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "engine/files/file_error.h"

namespace fulcrum {

Result<BlockFile> BlockFile::create(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return file_error("create", path, errno);
  return BlockFile(descriptor, path);
}

BlockFile::BlockFile(BlockFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      size_(other.size_),
      previous_size_(other.previous_size_) {}

BlockFile& BlockFile::operator=(BlockFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(path_, other.path_);
  std::swap(size_, other.size_);
  std::swap(previous_size_, other.previous_size_);
  return *this;
}

BlockFile::~BlockFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<Error> BlockFile::append(std::string_view block) {
  previous_size_ = size_;
  std::size_t done = 0;
  while (done < block.size()) {
    const ssize_t written = ::write(descriptor_, block.data() + done, block.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const int error_number = written < 0 ? errno : ENOSPC;
      cut(size_);
      return file_error("write", path_, error_number);
    }
    done += static_cast<std::size_t>(written);
  }
  size_ += block.size();
  return std::nullopt;
}

void BlockFile::take_back() {
  size_ = previous_size_;
  cut(size_);
}

std::optional<Error> BlockFile::overwrite_head(std::string_view head) const {
  std::size_t done = 0;
  while (done < head.size()) {
    const ssize_t written =
        ::pwrite(descriptor_, head.data() + done, head.size() - done, static_cast<off_t>(done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return file_error("write", path_, written < 0 ? errno : ENOSPC);
    done += static_cast<std::size_t>(written);
  }
  return std::nullopt;
}

std::optional<Error> BlockFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) return file_error("write", path_, errno);
  return std::nullopt;
}

std::optional<Error> write_new_file(const std::filesystem::path& path, std::string_view content) {
  Result<BlockFile> file = BlockFile::create(path);
  if (!file) return file.error();
  std::optional<Error> failure = file->append(content);
  if (!failure) failure = file->close();
  if (failure) ::unlink(path.c_str());
  return failure;
}

void BlockFile::cut(std::uint64_t size) const {
  const auto end = static_cast<off_t>(size);
  // Shortening needs no space. Where it fails nevertheless (a device), readers still drop an unfinished end.
  if (::ftruncate(descriptor_, end) == 0) ::lseek(descriptor_, end, SEEK_SET);
}

}  // namespace fulcrum
