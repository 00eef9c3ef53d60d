#pragma once
// What a person can set of an effect while it runs. A panel's line, its key and its command follow from it.

#include "haptics/tick/command.h"

namespace fulcrum {

struct Knob {
  Command::Kind kind;       // of the command that sets it, 0 (off) to 1
  const char* name;         // on the panel, one word
  char key;                 // of the keyboard, a capital letter
  double gain = 0;          // what it is set to, 0 to 1
  double on = 1;            // what it is set to when it is switched on
  double level = 0;         // 0 to 1: how strong it is in this tick
  bool brief = false;       // it lasts a tick or a few: what is shown is the peak of the last moments
  const char* effect = "";  // its name, which effect_knobs() writes
};

// What the panel says of torque above the knobs.
struct TorqueNote {
  bool bad = false;          // no force that the hand feels can tell of it
  const char* variant = "";  // of the study that the knobs amount to, such as "variant B"; empty: of none
};

}  // namespace fulcrum
