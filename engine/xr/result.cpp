#include "engine/xr/result.h"

#include <openxr/openxr_reflection.h>

namespace fulcrum::xr {

std::string name_of(XrResult code) {
  switch (code) {
#define FULCRUM_XR_NAME(name, value) \
  case name:                         \
    return #name;
    XR_LIST_ENUM_XrResult(FULCRUM_XR_NAME)
#undef FULCRUM_XR_NAME
  }
  return "XrResult " + std::to_string(static_cast<int>(code));  // of an extension that these headers lack
}

void check(XrResult code, const char* doing) {
  if (XR_SUCCEEDED(code)) return;
  const std::string sentence = std::string("The headset's runtime could not ") + doing + " (" +
                               name_of(code) + "): start it anew, and this run with it.";
  if (code == XR_ERROR_SESSION_LOST || code == XR_ERROR_FORM_FACTOR_UNAVAILABLE) throw Lost(sentence);
  throw Failure(sentence);
}

}  // namespace fulcrum::xr
