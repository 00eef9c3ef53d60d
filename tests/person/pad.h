#pragma once
// A gamepad in the hand of a trainee: what tests/support/stand_in_pad.cpp plays.

#include <fstream>
#include <string>

namespace fulcrum::person {

// -1..1: to the right, up, and away from the person.
struct PadPush {
  double right = 0, up = 0, away = 0;
};

class Pad {
public:
  // pipe: the FIFO from which the stand-in takes what the pad does. Throws std::runtime_error.
  explicit Pad(const std::string& pipe);
  void push(const PadPush& push);

private:
  std::ofstream out_;
};

}  // namespace fulcrum::person
