// How OpenXR's loader finds the tests' runtime.
//
// The structures are those of "OpenXR Loader: Design and Operation", 1.0, interface version 1, whose header
// no package of Debian has.

#include <cstring>
#include <string_view>

#include "tests/xr/runtime/calls.h"

namespace runtime {
namespace {

struct LoaderInfo {
  std::uint32_t type, version;
  std::size_t size;
  std::uint32_t least_interface, newest_interface;
  XrVersion least_api, newest_api;
};

struct RuntimeRequest {
  std::uint32_t type, version;
  std::size_t size;
  std::uint32_t interface;
  XrVersion api;
  PFN_xrGetInstanceProcAddr get;
};

XrResult XRAPI_CALL get_function(XrInstance, const char* name, PFN_xrVoidFunction* function) {
  if (std::string_view(name) == "xrGetInstanceProcAddr") {
    *function = erased(get_function);
    return XR_SUCCESS;
  }
  for (const auto calls : {instance_calls(), session_calls(), picture_calls(), action_calls(), hand_calls()})
    for (const Call& call : calls)
      if (std::string_view(call.name) == name) {
        *function = call.function;
        return XR_SUCCESS;
      }
  *function = nullptr;
  return XR_ERROR_FUNCTION_UNSUPPORTED;
}

}  // namespace
}  // namespace runtime

extern "C" __attribute__((visibility("default"))) XrResult XRAPI_CALL
xrNegotiateLoaderRuntimeInterface(const runtime::LoaderInfo* loader, runtime::RuntimeRequest* request) {
  if (loader->least_interface > 1 || loader->newest_interface < 1) return XR_ERROR_INITIALIZATION_FAILED;
  request->interface = 1;
  request->api = XR_CURRENT_API_VERSION;
  request->get = &runtime::get_function;
  return XR_SUCCESS;
}
