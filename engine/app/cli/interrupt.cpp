#include "engine/app/cli/interrupt.h"

#include <csignal>

namespace fulcrum::app {
namespace {

volatile std::sig_atomic_t caught = 0;

// The second of a person who has no time ends the program at once.
void on_signal(int number) {
  caught = 1;
  std::signal(number, SIG_DFL);
}

// A terminal that closes sends it twice, by itself and by its shell: the second does not cut the end short.
void on_hangup(int) {
  caught = 1;
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  // Whoever started it under nohup wants it to go on.
  if (std::signal(SIGHUP, on_hangup) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  // With the terminal goes who read what is printed; the files are still to be written.
  std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() {
  return caught != 0;
}

}  // namespace fulcrum::app
