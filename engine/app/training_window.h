#pragma once
// The window a trainee works in: the scene, the overlay, the keys, and the mouse as a device.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/mouse/mouse_device.h"
#include "engine/app/bridge.h"
#include "engine/app/cue_switches.h"
#include "engine/app/run_options.h"
#include "engine/app/run_sink.h"
#include "engine/input/tool_mouse.h"
#include "engine/render/orbit_camera.h"
#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/ui/overlay.h"
#include "engine/ui/window.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::app {

class TrainingWindow {
public:
  // Errors: no display, no Vulkan. prepared and visual must outlive the window.
  static Result<std::unique_ptr<TrainingWindow>> create(const Prepared& prepared,
                                                        const scenario::VisualAssembly& visual,
                                                        const RunOptions& options);

  enum class Leave { closed, restart };
  // One attempt. mouse: the device, if it is the mouse.
  Leave run(World& world, Device& device, MouseDevice* mouse, RunSink& sink);
  // The attempt's last moment, as it was seen, into a PNG. After run().
  Result<std::filesystem::path> save_picture(const RunSink& sink, const std::filesystem::path& file);

  const render::RenderPlan& plan() const { return renderer_->plan(); }
  // What Vulkan's validation layers have said so far, if options asked for them.
  std::vector<std::string> validation_messages() const { return instance_->messages(); }

private:
  TrainingWindow(const Prepared& prepared, const scenario::VisualAssembly& visual);

  void on_key(int key, int action);
  void on_press();
  void on_cursor(double x, double y);
  void on_scroll(double steps);
  void send(const std::optional<Command>& command);
  void send(const std::vector<Command>& commands);
  void note_cost(const TickEvent& event);
  ui::OverlayState overlay_of(const TickRecord& record, const RunSink& sink, const LiveLoop& loop) const;
  std::string message(const RunSink& sink) const;
  void draw(const RunSink& sink, LiveLoop& loop);
  render::FrameState frame_of(const TickRecord& record, const RunSink& sink);

  const Prepared& prepared_;
  const scenario::VisualAssembly& visual_;
  // In the order in which they need each other; destroyed backwards.
  std::unique_ptr<ui::Window> window_;
  std::unique_ptr<vulkan::Instance> instance_;
  std::unique_ptr<vulkan::Surface> surface_;
  std::unique_ptr<vulkan::Device> gpu_;
  std::unique_ptr<vulkan::Swapchain> swapchain_;
  std::unique_ptr<ui::Overlay> overlay_;
  std::unique_ptr<render::Renderer> renderer_;

  render::AutoQuality quality_;
  render::OrbitCamera camera_;
  FrameBridge bridge_;

  // Of the attempt that runs.
  LiveLoop* loop_ = nullptr;
  const SceneDesc* scene_ = nullptr;
  MouseDevice* mouse_ = nullptr;
  input::ToolMouse tool_mouse_{Pose{}};
  std::vector<std::int64_t> cpu_ns_;  // of the newest ticks, a ring
  std::size_t cpu_at_ = 0;

  int button_ = -1;      // that is down, or -1
  bool slides_ = false;  // it holds the slider of the holding point
  bool shift_ = false, control_ = false;
  double cursor_x_ = 0, cursor_y_ = 0;
  bool keys_visible_ = false;
  bool circle_ = false;       // of confusion: it is there
  bool circle_shown_ = true;  // where it is
  ui::OverlayState shown_;    // what the panels showed last
  CueSwitches cues_;
  bool restart_ = false;
  std::string error_;  // why drawing stopped
};

}  // namespace fulcrum::app
