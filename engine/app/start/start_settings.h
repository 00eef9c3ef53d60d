#pragma once
// What the start page remembers: $XDG_CONFIG_HOME/fulcrum/start.json, or ~/.config/fulcrum/start.json.

#include <optional>

#include "engine/app/start/start_menu.h"
#include "haptics/math/result.h"

namespace fulcrum::app {

// Empty: neither XDG_CONFIG_HOME nor HOME names a folder.
std::filesystem::path start_file();

// What is not there, or is none, is as at the first start.
StartChoice read_start_choice();
// Where it was this participant who trained, nobody is remembered any more; else why that cannot be written.
std::optional<Error> forget_start_participant(const std::string& participant);
// Absent: it is remembered; else why not, which hinders nothing.
std::optional<Error> write_start_choice(const StartChoice& choice);

}  // namespace fulcrum::app
