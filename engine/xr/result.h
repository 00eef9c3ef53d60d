#pragma once
// How calls of OpenXR fail: as in engine/vulkan, what goes wrong at run time is thrown, and entry points that
// other rooms call make a sentence of it.

#include <stdexcept>
#include <string>

#include "engine/vulkan/result.h"
#include "engine/xr/openxr.h"

namespace fulcrum::xr {

using fulcrum::Error;
using fulcrum::Result;

class Failure : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

// The session is lost, or the headset gone: another session may be made once it is found again.
class Lost : public Failure {
public:
  using Failure::Failure;
};

// "XR_ERROR_SESSION_LOST" and so on.
std::string name_of(XrResult code);

// Throws Failure "The headset's runtime could not DOING (CODE) ..." with a remedy if the code is an error;
// a Lost where that is the end of a session alone.
void check(XrResult code, const char* doing);

}  // namespace fulcrum::xr
