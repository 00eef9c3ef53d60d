#pragma once
// `fulcrum` without arguments: the start page, and what is started from it, in one window.

namespace fulcrum::app {

// The exit code. Where no window can be opened, a sentence on stderr says why.
int run_start_window();

}  // namespace fulcrum::app
