#pragma once
// What the command line says of a headset.

#include <optional>
#include <string>

namespace fulcrum::app {

class Arguments;

// Of --xr-space: the scene is before who begins, wherever that is, or it stands in the middle of the floor.
inline constexpr const char* kLocalSpace = "local";
inline constexpr const char* kStageSpace = "stage";

// Why a device of a window's is not there in a headset.
inline constexpr const char* kNoWindowInHeadset = "it needs a window: leave out --xr, or --device.";

struct HeadsetOptions {
  bool asked = false;               // --xr
  std::string space = kLocalSpace;  // --xr-space
  double scale = 1;                 // --xr-scale: the scene is seen so many times as large as it is
  bool colocate = false;            // --colocate: the device is laid onto the headset's space first
  double colocate_limit_mm = 10;    // --colocate-limit: the largest residual that is kept
};

// The space alone.
void add_headset_space(Arguments& arguments, HeadsetOptions& options);

// Which of these options would do nothing since another is missing, --xr or --colocate; absent: none.
std::optional<std::string> refuse_without_headset(const HeadsetOptions& options);

// All of it.
void add_headset(Arguments& arguments, HeadsetOptions& options);

}  // namespace fulcrum::app
