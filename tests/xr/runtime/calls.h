#pragma once
// The functions of OpenXR that the tests' runtime has, by what they are about.

#include <array>
#include <span>
#include <string>

#include "engine/xr/openxr.h"

namespace runtime {

struct Call {
  const char* name;
  PFN_xrVoidFunction function;
};

std::span<const Call> instance_calls();
std::span<const Call> session_calls();
std::span<const Call> picture_calls();
std::span<const Call> action_calls();
// Of XR_EXT_hand_tracking; none where the program has not asked for it.
std::span<const Call> hand_calls();

template <class Function>
PFN_xrVoidFunction erased(Function* function) {
  return reinterpret_cast<PFN_xrVoidFunction>(function);
}

// The idiom of OpenXR for lists: how many there are, and as many as there is room for.
template <class T, class U>
XrResult give(std::span<const T> all, std::uint32_t capacity, std::uint32_t* count, U* to) {
  *count = static_cast<std::uint32_t>(all.size());
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
  for (std::size_t i = 0; i < all.size(); ++i) to[i] = all[i];
  return XR_SUCCESS;
}

// The same of a text with the zero at its end.
inline XrResult give_text(const std::string& text, std::uint32_t capacity, std::uint32_t* count, char* to) {
  return give(std::span<const char>(text.c_str(), text.size() + 1), capacity, count, to);
}

}  // namespace runtime
