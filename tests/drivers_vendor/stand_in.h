#pragma once
// What a test holds the other end of: the device behind a maker's library that tests build themselves. One
// for each library.

#include <mutex>

namespace fulcrum::stand_in {

struct Handle {
  std::mutex mutex;
  bool there = true;  // plugged in
  bool calibrated = true;
  double p[3] = {0, 0, 0};                                // in the library's own frame and unit
  double turn[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // rows; of the handle against the library's frame
  int buttons = 0;                                        // bit n: button n
  // What the motors do.
  double force[3] = {0, 0, 0}, torque[3] = {0, 0, 0};
  bool powered = false;  // forces are enabled
  // What the program did.
  int opened = 0, closed = 0, turns = 0;
};

}  // namespace fulcrum::stand_in

// Of the library: where its device is held.
extern "C" fulcrum::stand_in::Handle* stand_in_handle();
