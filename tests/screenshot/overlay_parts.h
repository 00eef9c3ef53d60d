#pragma once
// Parts of an overlay's state that several tests draw.

#include "engine/ui/overlay.h"

namespace fulcrum::ui {

// A stick that is held at 100 mm, as a strip along it feels.
inline HoldingPanel held_stick() {
  HoldingPanel panel;
  panel.place = 0.1;
  panel.low = 0.03;
  panel.high = 0.17;
  panel.measured = true;
  panel.sensed = "the strip feels it at 100 mm";
  panel.stiffness = 300;
  panel.structure_known = true;
  panel.levels = {100, 200, 300, 400, 500, 600};
  panel.methods = {"none", "arm", "acceleration"};
  return panel;
}

// A nut in the middle of a picture of 640 x 360 px, which no panel reaches; distance in m, radius in px.
inline Target nut_in_sight(double distance, float radius) {
  Target target;
  target.name = "at the nut";
  target.at.in_sight = true;
  target.at.place = {350, 180};
  target.at.radius = radius;
  target.at.distance = distance;
  target.dwell_s = 3;
  return target;
}

}  // namespace fulcrum::ui
