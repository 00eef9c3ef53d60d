#pragma once

namespace fulcrum::app {

// Scripts rely on these.
enum ExitCode : int {
  kCompleted = 0,
  kError = 1,         // a sentence on stderr says what and what to do
  kUsage = 2,         // the command line was wrong
  kNotCompleted = 3,  // the run ended before its task did
  kEndedByFault = 4   // a fault stopped the force
};

}  // namespace fulcrum::app
