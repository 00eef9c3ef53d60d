#include "tests/xr/runtime/log.h"

#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace runtime {

void log(const std::string& line) {
  static std::mutex mutex;
  static std::FILE* const file = [] {
    const char* const name = std::getenv("FULCRUM_XR_LOG");
    return name != nullptr ? std::fopen(name, "w") : nullptr;
  }();
  if (file == nullptr) return;
  const std::lock_guard lock(mutex);
  std::fprintf(file, "%s\n", line.c_str());
  std::fflush(file);
}

void wrong(const std::string& line) {
  log("WRONG: " + line);
}

}  // namespace runtime
