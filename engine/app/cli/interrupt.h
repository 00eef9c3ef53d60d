#pragma once

namespace fulcrum::app {

// From here on SIGINT, SIGTERM and SIGHUP end a run as its time limit would: files are closed and the summary
// is written. A second SIGINT or SIGTERM ends the program at once.
void catch_interrupts();
bool interrupted();

}  // namespace fulcrum::app
