#include "tests/person/pad.h"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace fulcrum::person {

Pad::Pad(const std::string& pipe) : out_(pipe) {
  if (!out_) throw std::runtime_error("no pad listens at " + pipe);
}

// One report, as a pad sends them: y down, a trigger for each way along the line of sight.
void Pad::push(const PadPush& push) {
  out_ << "left_x " << push.right << " left_y " << -push.up << " right_trigger " << std::max(push.away, 0.0)
       << " left_trigger " << std::max(-push.away, 0.0) << std::endl;
}

}  // namespace fulcrum::person
