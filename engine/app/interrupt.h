#pragma once

namespace fulcrum::app {

// From here on SIGINT and SIGTERM end a run as its time limit would: files are closed and the summary is
// written. A second one ends the program at once.
void catch_interrupts();
bool interrupted();

}  // namespace fulcrum::app
