#pragma once
// Drags and wheel steps -> where the handle shall go, in all six axes, as seen from the camera. No window in
// here.

#include <span>

#include "haptics/math/pose.h"

namespace fulcrum::input {

// What the trainee sees: the axes of the picture, and how tall it is where the tool has to touch.
struct ViewAxes {
  Vec3 right_W = Vec3::UnitX();     // (3) unit
  Vec3 up_W = Vec3::UnitY();        // (3) unit
  Vec3 forward_W = -Vec3::UnitZ();  // (3) unit, into the picture
  Vec3 sight_W = -Vec3::UnitZ();    // (3) from the eye towards that place, 1 along forward_W
  double height = 1;                // m, of the picture as deep as that place
};

// How far a wheel step takes the tool.
enum class Step { whole, fine };
struct MouseSteps {
  double whole = 4e-3;  // m
  double fine = 1e-3;   // m
};

// So that the wheel can stop within `detail` (m) of any depth: the finest that there is to hit in a scene.
MouseSteps mouse_steps(double detail);

class ToolMouse {
public:
  explicit ToolMouse(const MouseSteps& steps) : steps_(steps) {}

  // Fractions of the picture's height.
  void slide(const ViewAxes& view, double right, double down);
  // To the side, and away from the person along the line of sight: what touches stays where it is seen.
  void push(const ViewAxes& view, double right, double away);
  void turn(const ViewAxes& view, double right, double down);
  void roll(const ViewAxes& view, double right);
  // wheel steps along the line of sight, away from the person positive.
  void reach(const ViewAxes& view, double steps, Step step);

  void reset(const Pose& X_WH) { X_WH_ = X_WH; }
  const Pose& X_WH() const { return X_WH_; }

private:
  void rotate(const Vec3& rotation_W);

  MouseSteps steps_;
  Pose X_WH_;
};

// What each gesture does, for the screen.
std::span<const char* const> mouse_help();

}  // namespace fulcrum::input
