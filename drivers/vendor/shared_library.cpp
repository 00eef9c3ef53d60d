#include "drivers/vendor/shared_library.h"

#include <dlfcn.h>

namespace fulcrum {

Result<SharedLibrary> SharedLibrary::open(const std::string& name) {
  SharedLibrary library;
  library.handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library.handle_ == nullptr) {
    const char* const why = dlerror();
    return Error{why != nullptr ? why : name + " does not load"};
  }
  return library;
}

void* SharedLibrary::symbol(const char* name) {
  void* const found = dlsym(handle_, name);
  if (found == nullptr) missing_.append(missing_.empty() ? "" : ", ").append(name);
  return found;
}

}  // namespace fulcrum
