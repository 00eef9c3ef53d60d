#pragma once
// The error tier of building things: a value, or a sentence with a remedy. Ticks use fault bits instead.

#include <string>
#include <utility>
#include <variant>

namespace fulcrum {

struct Error {
  std::string sentence;  // what is wrong and what to do about it, one sentence or two
};

template <class T>
class [[nodiscard]] Result {
public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return state_.index() == 0; }
  T& operator*() { return std::get<0>(state_); }
  const T& operator*() const { return std::get<0>(state_); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }
  const Error& error() const { return std::get<1>(state_); }

private:
  std::variant<T, Error> state_;
};

}  // namespace fulcrum
