#pragma once
// A vendor's library that may be there, opened while running: one binary serves machines with it and without.
// It stays open until the process ends, since such libraries have threads of their own.

#include <string>

#include "haptics/math/result.h"

namespace fulcrum {

class SharedLibrary {
public:
  // name: as the loader looks for it, such as "libHD.so". Errors: it is not found, or does not load, in the
  // loader's words.
  static Result<SharedLibrary> open(const std::string& name);

  // The function of that name; null where it has none, which missing() then tells.
  template <class Function>
  void find(const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(symbol(name));
  }
  // Names that were looked for and not found, with commas; empty: none.
  const std::string& missing() const { return missing_; }

private:
  SharedLibrary() = default;
  void* symbol(const char* name);

  void* handle_ = nullptr;
  std::string missing_;
};

}  // namespace fulcrum
