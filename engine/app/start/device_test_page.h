#pragma once
// The device test of the start page: until it is closed.

#include <string>

#include "engine/app/start/backdrop.h"
#include "engine/app/window/window_stage.h"
#include "engine/ui/start_page.h"

namespace fulcrum::app {

// page: what is behind it. Events of the window are its own meanwhile, and nobody's afterwards. Empty: it was
// closed, or the window was; else why the device cannot be tested.
Result<std::string> test_device(WindowStage& stage, Backdrop& backdrop, ui::StartPage page,
                                const std::string& name);

}  // namespace fulcrum::app
