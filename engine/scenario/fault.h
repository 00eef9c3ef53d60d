#pragma once
// What is wrong with a file, where, and what to do about it. A reader collects every fault of a file, not
// only the first, so that a file is repaired in one go.

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum::scenario {

struct Fault {
  std::string file;      // or "--set KEY=VALUE", for a value that came from there
  int line = 0;          // from 1; 0: no line to point at
  int column = 0;        // from 1
  std::string sentence;  // what is wrong and the remedy

  std::string text() const;  // file:line:column: sentence
};

// Where something stands in a file; parts of Fault.
struct Place {
  std::string file;
  int line = 0, column = 0;

  std::string text() const;  // file:line:column; the file alone if there is no line to point at
  Fault fault(std::string sentence) const { return {file, line, column, std::move(sentence)}; }
};

using Faults = std::vector<Fault>;

std::string to_text(const Faults& faults);  // one to a line

// A value, or at least one fault.
template <class T>
class [[nodiscard]] Checked {
public:
  Checked(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Checked(Faults faults) : state_(std::in_place_index<1>, std::move(faults)) {}

  explicit operator bool() const { return state_.index() == 0; }
  T& operator*() { return std::get<0>(state_); }
  const T& operator*() const { return std::get<0>(state_); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }
  const Faults& faults() const { return std::get<1>(state_); }

private:
  std::variant<T, Faults> state_;
};

}  // namespace fulcrum::scenario
