#include "engine/input/tool_mouse.h"

#include "haptics/math/rotation.h"

namespace fulcrum::input {
namespace {

constexpr double kTurnPerHeight = 3.5;  // rad: a drag across the picture is a little more than half a turn
constexpr double kFine = 0.25;          // of a step: one to look, and a finer one to touch

}  // namespace

// A detail is a radius: from any depth beside it one step ends within.
MouseSteps mouse_steps(double detail) {
  return {detail, kFine * detail};
}

void ToolMouse::slide(const ViewAxes& view, double right, double down) {
  X_WH_.p += view.height * (right * view.right_W - down * view.up_W);
}

void ToolMouse::push(const ViewAxes& view, double right, double away) {
  X_WH_.p += view.height * (right * view.right_W + away * view.sight_W);
}

void ToolMouse::turn(const ViewAxes& view, double right, double down) {
  rotate(kTurnPerHeight * (right * view.up_W + down * view.right_W));
}

void ToolMouse::roll(const ViewAxes& view, double right) {
  rotate(kTurnPerHeight * right * view.forward_W);
}

void ToolMouse::reach(const ViewAxes& view, double steps, Step step) {
  X_WH_.p += (step == Step::fine ? steps_.fine : steps_.whole) * steps * view.sight_W;
}

void ToolMouse::rotate(const Vec3& rotation_W) {
  X_WH_.q = (quaternion_exp(rotation_W) * X_WH_.q).normalized();
}

std::span<const char* const> mouse_help() {
  static constexpr const char* lines[] = {
      "Left drag: tool left, right, up, down",
      "Shift + left drag: left, right, farther, nearer",
      "Wheel: tool farther and nearer",
      "Shift + wheel: the same, finer",
      "Right drag: tool turns left, right, up, down",
      "Shift + right drag: tool rolls",
      "Middle drag: look around",
      "Shift + middle drag: move the view",
      "Ctrl + wheel: zoom",
  };
  return lines;
}

}  // namespace fulcrum::input
