#pragma once
// What --push does: results of participants who consent go to a learning record store, each of them once.

#include <string>

#include "engine/session/store.h"

namespace fulcrum::app {

struct PushOptions {
  std::string url;
  std::string credentials;   // a file of its owner alone, "USER:PASSWORD"
  std::string certificates;  // PEM, of whom the store's is signed by; empty: the system's
};

// The program's exit code: kError while something is still to be sent. What waits lies in the store of
// results, so that the same command, given again, goes on.
int push_results(session::Store& store, const PushOptions& options);

}  // namespace fulcrum::app
