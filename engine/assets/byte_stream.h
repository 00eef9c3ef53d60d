#pragma once
// Plain values into bytes and back, in this machine's order: for caches, which never leave the machine.

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace fulcrum {

class ByteWriter {
public:
  template <class T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    array(std::span(&v, 1));
  }
  template <class T, class Allocator>
  void vector(const std::vector<T, Allocator>& v) {
    value(v.size());
    array(std::span(v));
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }

private:
  template <class T, std::size_t N>
  void array(std::span<T, N> v) {
    const auto raw = std::as_bytes(v);
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
  }
  std::vector<std::byte> bytes_;
};

// Reading past the end fails, is remembered, and yields zeros.
class ByteReader {
public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  T value() {
    static_assert(std::is_trivially_copyable_v<T>);
    T v{};
    take(&v, sizeof(T));
    return v;
  }
  template <class T, class Allocator = std::allocator<T>>
  std::vector<T, Allocator> vector() {
    const auto count = value<std::size_t>();
    if (count > rest_.size() / sizeof(T)) {
      failed_ = true;
      return {};
    }
    std::vector<T, Allocator> v(count);
    take(v.data(), count * sizeof(T));
    return v;
  }
  bool finished_well() const { return !failed_ && rest_.empty(); }

private:
  void take(void* to, std::size_t count) {
    failed_ = failed_ || count > rest_.size();
    if (failed_ || count == 0) return;
    std::memcpy(to, rest_.data(), count);
    rest_ = rest_.subspan(count);
  }
  std::span<const std::byte> rest_;
  bool failed_ = false;
};

}  // namespace fulcrum
