#pragma once
// Where what a person keeps for Fulcrum lies. None of the folders need be there. Empty: neither variable names
// a folder, and what lies in the current one is nobody's.

#include <filesystem>

namespace fulcrum {

// Firmware, calibrations: $XDG_CONFIG_HOME/fulcrum, or ~/.config/fulcrum.
std::filesystem::path config_folder();

// Recordings, reports, results: $XDG_DATA_HOME/fulcrum, or ~/.local/share/fulcrum.
std::filesystem::path data_folder();

}  // namespace fulcrum
