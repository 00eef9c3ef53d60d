#pragma once
// Drags and wheel steps -> where the handle shall go, in all six axes, as seen from the camera. No window in
// here.

#include <span>

#include "haptics/math/pose.h"

namespace fulcrum::input {

// What the trainee sees: the axes of the picture and how tall it is at the tool.
struct ViewAxes {
  Vec3 right_W = Vec3::UnitX();     // (3) unit
  Vec3 up_W = Vec3::UnitY();        // (3) unit
  Vec3 forward_W = -Vec3::UnitZ();  // (3) unit, into the picture
  double height = 1;                // m, of the picture at the tool's distance
};

class ToolMouse {
public:
  explicit ToolMouse(const Pose& X_WH) : X_WH_(X_WH) {}

  // Fractions of the picture's height.
  void slide(const ViewAxes& view, double right, double down);
  void turn(const ViewAxes& view, double right, double down);
  // wheel steps, away from the person positive.
  void reach(const ViewAxes& view, double steps);
  void roll(const ViewAxes& view, double steps);

  void reset(const Pose& X_WH) { X_WH_ = X_WH; }
  const Pose& X_WH() const { return X_WH_; }

private:
  void rotate(const Vec3& rotation_W);

  Pose X_WH_;
};

// What each gesture does, for the screen.
std::span<const char* const> mouse_help();

}  // namespace fulcrum::input
