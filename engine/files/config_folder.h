#pragma once
// Where what a person keeps for Fulcrum lies: firmware, calibrations.

#include <filesystem>

namespace fulcrum {

// $XDG_CONFIG_HOME/fulcrum, or ~/.config/fulcrum. It need not be there. Empty: neither
// names a folder, and what lies in the current one is nobody's.
std::filesystem::path config_folder();

}  // namespace fulcrum
