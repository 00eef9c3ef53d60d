#pragma once
// Programs that lie beside fulcrum and carry out some of its subcommands.

#include <string>

namespace fulcrum::app {

// What a program beside this one is for, in a sentence about its absence: "studies are carried out".
struct Beside {
  const char* program;  // "fulcrum-studies"
  const char* task;
};

// This process becomes the program. Does not return where that succeeds; otherwise an exit code, and stderr
// says what to do.
int become(const Beside& beside, char** argv);

// The program runs until it is done: its exit code. Where a signal ended it, kError after `failed` on stderr.
int run_beside(const Beside& beside, char** argv, const std::string& failed);

}  // namespace fulcrum::app
