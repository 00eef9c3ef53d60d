#pragma once
// The scene behind the start page: of the scenario that is chosen, seen from its first view, turning a
// little.

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "engine/app/picture/bridge.h"
#include "engine/app/window/window_stage.h"
#include "engine/scenario/assemble.h"

namespace fulcrum::app {

class Backdrop {
public:
  explicit Backdrop(WindowStage& stage) : stage_(stage) {}
  ~Backdrop();  // waits for what is being read

  // The scenario that is to be seen: its models are read on another thread, once it has been asked for for a
  // moment, and it is drawn when they are there. What cannot be read leaves the background plain.
  void want(const std::string& name, bool left_handed);
  // What to draw now.
  render::FrameState frame();

private:
  using Clock = std::chrono::steady_clock;
  struct Wanted {
    std::string name;
    bool left_handed = false;
    bool operator==(const Wanted&) const = default;
  };
  struct Read {
    Wanted of;
    std::optional<scenario::Scenario> scenario;
    std::optional<scenario::VisualAssembly> visual;
    Pose X_WT;
  };
  static Read read(const Wanted& wanted);
  void take();

  WindowStage& stage_;
  Wanted wanted_, asked_;  // asked_: what is being read, or was read last
  Clock::time_point since_ = Clock::now(), begin_ = Clock::now();
  std::future<Read> reading_;
  std::unique_ptr<Read> shown_;
  std::unique_ptr<FrameBridge> bridge_;
};

}  // namespace fulcrum::app
