#include "engine/importing/ending_files.h"

#include <assimp/IOStream.hpp>
#include <stdexcept>

namespace fulcrum::importing {
namespace {

constexpr int kReadsAtTheEnd = 1000;

class EndingStream final : public Assimp::IOStream {
public:
  EndingStream(Assimp::DefaultIOSystem& system, Assimp::IOStream* stream)
      : system_(system), stream_(stream) {}
  ~EndingStream() override { system_.DefaultIOSystem::Close(stream_); }
  EndingStream(const EndingStream&) = delete;
  EndingStream& operator=(const EndingStream&) = delete;

  std::size_t Read(void* to, std::size_t size, std::size_t count) override {
    const std::size_t read = stream_->Read(to, size, count);
    if (read == 0 && ++empty_reads_ > kReadsAtTheEnd)
      throw std::runtime_error("the file ends before what it begins");
    return read;
  }
  std::size_t Write(const void* from, std::size_t size, std::size_t count) override {
    return stream_->Write(from, size, count);
  }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override { return stream_->Seek(offset, origin); }
  std::size_t Tell() const override { return stream_->Tell(); }
  std::size_t FileSize() const override { return stream_->FileSize(); }
  void Flush() override { stream_->Flush(); }

private:
  Assimp::DefaultIOSystem& system_;
  Assimp::IOStream* stream_;
  int empty_reads_ = 0;
};

}  // namespace

Assimp::IOStream* EndingFiles::Open(const char* file, const char* mode) {
  Assimp::IOStream* stream = DefaultIOSystem::Open(file, mode);
  return stream == nullptr ? nullptr : new EndingStream(*this, stream);
}

void EndingFiles::Close(Assimp::IOStream* stream) {
  delete stream;
}

}  // namespace fulcrum::importing
