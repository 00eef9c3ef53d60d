#pragma once
// Whether a headset shows a device where it is felt: known before anything is opened.

#include <filesystem>
#include <optional>
#include <string>

#include "engine/app/cli/headset_options.h"
#include "engine/scenario/colocation.h"
#include "haptics/math/result.h"

namespace fulcrum::app {

struct ColocationChoice {
  std::string built;  // by what, in words; empty: it is not, and `why_not` says why
  std::string why_not;
  std::filesystem::path file;  // that says where the device stands; empty: none does yet
};

// device: as the command line names it.
ColocationChoice choose_colocation(const HeadsetOptions& options, const std::string& device);

// Of a device that a person holds at its place on a desk, the part of its name that moves; empty: it is none
// such.
std::string device_on_desk(const std::string& device);

// What is kept of it: none where nothing is. Errors: it cannot be read, or is of something else.
Result<std::optional<scenario::Colocation>> kept_colocation(const HeadsetOptions& options,
                                                            const std::string& device);

}  // namespace fulcrum::app
