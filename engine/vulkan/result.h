#pragma once
// How building fails: with a sentence that names the remedy.
//
// Two tiers below it. A Vulkan call that fails (memory, a lost device) throws Failure from inside the
// wrappers; the entry points that other rooms call catch it and return a Result, so that no exception leaves
// engine/vulkan or engine/render.

#include <vulkan/vulkan_core.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace fulcrum::vulkan {

struct Error {
  std::string sentence;
};

// A value, or the sentence that says why there is none.
template <class T>
class [[nodiscard]] Result {
public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }
  T& value() { return std::get<T>(state_); }
  const T& value() const { return std::get<T>(state_); }
  const std::string& error() const { return std::get<Error>(state_).sentence; }

private:
  std::variant<T, Error> state_;
};

// Done, or the sentence that says why not.
template <>
class [[nodiscard]] Result<void> {
public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  const std::string& error() const { return error_->sentence; }

private:
  std::optional<Error> error_;
};

// A Vulkan call that failed at run time.
class Failure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

// "VK_ERROR_DEVICE_LOST" and so on; the number for a code that is not expected here.
std::string name_of(VkResult code);

// Throws Failure "Vulkan could not DOING: CODE." with a remedy unless the code is VK_SUCCESS.
void check(VkResult code, const char* doing);

}  // namespace fulcrum::vulkan
