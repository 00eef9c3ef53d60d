#include "engine/app/training_window.h"

#include <GLFW/glfw3.h>

#include <cctype>
#include <cstdio>
#include <utility>

#include "engine/app/holding_controls.h"
#include "engine/app/interrupt.h"
#include "engine/app/terminal.h"
#include "engine/record/percentiles.h"
#include "engine/ui/cue_panel.h"
#include "engine/ui/holding_panel.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kCostWindow = 1000;  // ticks that the shown percentiles are of

std::string lower(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

// What a key asks of the panel of the holding point.
std::optional<HoldingKey> holding_key(int key) {
  switch (key) {
    case GLFW_KEY_LEFT_BRACKET:
      return HoldingKey::nearer;
    case GLFW_KEY_RIGHT_BRACKET:
      return HoldingKey::farther;
    case GLFW_KEY_MINUS:
      return HoldingKey::softer;
    case GLFW_KEY_EQUAL:
      return HoldingKey::stiffer;
    case GLFW_KEY_N:
      return HoldingKey::method;
    case GLFW_KEY_H:
      return HoldingKey::measured;
    default:
      return std::nullopt;
  }
}

std::vector<ui::KeyLine> key_lines(const ui::OverlayState& state, bool circle) {
  std::vector<ui::KeyLine> lines = {
      {"Esc", "stop the force"},  {"Enter", "let the force return"},     {"R", "start again"},
      {"1 to 9", "go to a view"}, {"Home", "back to this view's start"}, {"F1", "show or hide this list"},
  };
  for (const ui::CueLine& cue : state.cues)
    lines.insert(lines.end() - 1, {cue.key, "switch the " + lower(cue.name)});
  if (state.holding) {
    const std::vector<ui::KeyLine> keys = holding_keys();
    lines.insert(lines.end() - 1, keys.begin(), keys.end());
  }
  if (circle) lines.insert(lines.end() - 1, {"C", "show or hide the circle of confusion"});
  return lines;
}

}  // namespace

TrainingWindow::TrainingWindow(const Prepared& prepared, const scenario::VisualAssembly& visual)
    : prepared_(prepared),
      visual_(visual),
      camera_(visual.desc.camera),
      bridge_(visual.desc, prepared.scenario, prepared.haptic.scene) {}

Result<std::unique_ptr<TrainingWindow>> TrainingWindow::create(const Prepared& prepared,
                                                               const scenario::VisualAssembly& visual,
                                                               const RunOptions& options) {
  std::unique_ptr<TrainingWindow> self(new TrainingWindow(prepared, visual));
  auto window = ui::Window::create("Fulcrum: " + prepared.scenario.title, options.size);
  if (!window) return Error{window.error()};
  self->window_ = std::move(window.value());
  self->circle_ = options.circle;
  vulkan::InstanceOptions instance_options;
  instance_options.extensions = self->window_->instance_extensions();
  instance_options.validation = options.validate;
  auto instance = vulkan::Instance::create(instance_options);
  if (!instance) return Error{instance.error()};
  self->instance_ = std::make_unique<vulkan::Instance>(std::move(instance.value()));
  auto surface = self->window_->surface(*self->instance_);
  if (!surface) return Error{surface.error()};
  self->surface_ = std::make_unique<vulkan::Surface>(std::move(surface.value()));
  auto gpu = vulkan::Device::create(*self->instance_, options.gpu, self->surface_->get());
  if (!gpu) return Error{gpu.error()};
  self->gpu_ = std::move(gpu.value());
  auto swapchain = vulkan::Swapchain::create(*self->gpu_, self->surface_->get());
  if (!swapchain) return Error{swapchain.error()};
  self->swapchain_ = std::move(swapchain.value());
  auto overlay = ui::Overlay::create(*self->gpu_);
  if (!overlay) return Error{overlay.error()};
  self->overlay_ = std::move(overlay.value());
  if (!self->overlay_->font_note().empty()) complain(self->overlay_->font_note());
  render::RenderOptions render_options;
  render_options.extent = options.size;
  render_options.quality = self->quality_.quality();
  render_options.shader_folder = render::development_shader_folder();
  auto renderer = render::Renderer::create(*self->gpu_, visual.desc, render_options);
  if (!renderer) return Error{renderer.error()};
  self->renderer_ = std::move(renderer.value());
  return self;
}

TrainingWindow::Leave TrainingWindow::run(World& world, Device& device, MouseDevice* mouse, RunSink& sink) {
  LiveLoop loop(world, device);
  loop_ = &loop;
  scene_ = &world.desc();
  mouse_ = mouse;
  restart_ = false;
  slides_ = false;
  button_ = -1;  // a release while no window listened is not told
  shown_ = {};
  cues_ = CueSwitches(*scene_);
  cpu_ns_.clear();
  cpu_at_ = 0;
  tool_mouse_.reset(scene_->tool.X_WT_start * scene_->tool.X_HT.inverse());
  ui::WindowEvents events;
  events.key = [this](int key, int action, int modifiers) {
    shift_ = (modifiers & GLFW_MOD_SHIFT) != 0;
    control_ = (modifiers & GLFW_MOD_CONTROL) != 0;
    on_key(key, action);
  };
  events.button = [this](int button, int action, int modifiers) {
    shift_ = (modifiers & GLFW_MOD_SHIFT) != 0;
    button_ = action == GLFW_PRESS ? button : -1;
    slides_ = false;
    if (button_ == GLFW_MOUSE_BUTTON_LEFT) on_press();
  };
  events.cursor = [this](double x, double y) { on_cursor(x, y); };
  events.scroll = [this](double, double steps) { on_scroll(steps); };
  window_->set_events(std::move(events));

  loop.start();
  while (!window_->closing() && !restart_ && !interrupted() && error_.empty()) {
    window_->poll();
    TickEvent event;
    while (loop.next(event)) {
      note_cost(event);
      if (sink.end() == RunSink::End::running) sink.take(event);
    }
    sink.flush_if_due();
    draw(sink, loop);
  }
  loop.stop();
  window_->set_events({});
  if (window_->lost())
    complain(
        "the window is gone, for its X server ended or another program closed it: the run ends here, and what "
        "it recorded is kept.");
  else if (!error_.empty())
    complain(error_);
  if (!loop.grant().scheduling.empty()) complain(loop.grant().scheduling);
  if (!loop.grant().memory.empty()) complain(loop.grant().memory);
  return restart_ ? Leave::restart : Leave::closed;
}

void TrainingWindow::on_press() {
  const std::optional<Command> pressed = cues_.press(shown_, window_->pixels(), cursor_x_, cursor_y_);
  send(pressed);
  const ui::PanelPoint at = ui::panel_point(window_->pixels(), cursor_x_, cursor_y_);
  const auto held = ui::pressed_holding(shown_, at.width, at.x, at.y);
  if (held) send(holding_commands(*shown_.holding, *held));
  slides_ = held && held->part == ui::HoldingPress::Part::place;
  if (pressed || held) button_ = -1;  // a press on a panel drags nothing in the scene
}

void TrainingWindow::on_key(int key, int action) {
  // A modifier's own event comes with the state before it.
  if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT) shift_ = action != GLFW_RELEASE;
  if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL) control_ = action != GLFW_RELEASE;
  if (action != GLFW_PRESS) return;
  switch (key) {
    case GLFW_KEY_ESCAPE:
      loop_->send({Command::Kind::stop});
      break;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      loop_->send({Command::Kind::acknowledge});
      break;
    case GLFW_KEY_R:
      restart_ = true;
      break;
    case GLFW_KEY_V:
      send(cues_.toggle(Command::Kind::vibration_gain, shown_));
      break;
    case GLFW_KEY_G:
      send(cues_.toggle(Command::Kind::ghost_gain, shown_));
      break;
    case GLFW_KEY_I:
      send(cues_.toggle(Command::Kind::impact_gain, shown_));
      break;
    case GLFW_KEY_B:
      send(cues_.toggle(Command::Kind::pulse_gain, shown_));
      break;
    case GLFW_KEY_M:
      send(cues_.toggle(Command::Kind::pulse_moment, shown_));
      break;
    case GLFW_KEY_T:
      send(cues_.toggle(Command::Kind::vibrotactile_gain, shown_));
      break;
    case GLFW_KEY_C:
      circle_shown_ = !circle_shown_;
      break;
    case GLFW_KEY_F1:
      keys_visible_ = !keys_visible_;
      break;
    case GLFW_KEY_HOME:
      camera_.reset();
      break;
    default:
      if (const auto holding = holding_key(key); holding && shown_.holding)
        send(holding_commands(*shown_.holding, *holding));
      if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) {
        const auto view = static_cast<std::size_t>(key - GLFW_KEY_1);
        if (view < visual_.views.size()) camera_ = render::OrbitCamera(visual_.views[view].camera);
      }
  }
}

void TrainingWindow::send(const std::optional<Command>& command) {
  if (command) loop_->send(*command);
}

void TrainingWindow::send(const std::vector<Command>& commands) {
  for (const Command& command : commands) loop_->send(command);
}

void TrainingWindow::on_cursor(double x, double y) {
  const double dx = x - std::exchange(cursor_x_, x), dy = y - std::exchange(cursor_y_, y);
  if (slides_ && shown_.holding) {
    const ui::PanelPoint at = ui::panel_point(window_->pixels(), cursor_x_, cursor_y_);
    send(holding_commands(*shown_.holding,
                          {ui::HoldingPress::Part::place, ui::dragged_place(shown_, at.width, at.x)}));
  }
  if (button_ < 0) return;
  const bool moves_tool = mouse_ != nullptr && button_ != GLFW_MOUSE_BUTTON_MIDDLE;
  if (moves_tool) {
    const input::ViewAxes view = view_axes(camera_.camera(), tool_mouse_.X_WH().p);
    if (button_ == GLFW_MOUSE_BUTTON_LEFT)
      tool_mouse_.slide(view, dx, dy);
    else
      tool_mouse_.turn(view, dx, dy);
    mouse_->aim(tool_mouse_.X_WH());
  } else if (shift_) {
    camera_.pan(static_cast<float>(dx), static_cast<float>(dy));
  } else {
    camera_.orbit(static_cast<float>(dx), static_cast<float>(dy));
  }
}

void TrainingWindow::on_scroll(double steps) {
  if (control_ || mouse_ == nullptr) {
    camera_.zoom(static_cast<float>(steps));
    return;
  }
  const input::ViewAxes view = view_axes(camera_.camera(), tool_mouse_.X_WH().p);
  if (shift_)
    tool_mouse_.roll(view, steps);
  else
    tool_mouse_.reach(view, steps);
  mouse_->aim(tool_mouse_.X_WH());
}

void TrainingWindow::note_cost(const TickEvent& event) {
  if (cpu_ns_.size() < kCostWindow)
    cpu_ns_.push_back(event.cpu_ns);
  else
    cpu_ns_[cpu_at_] = event.cpu_ns;
  cpu_at_ = (cpu_at_ + 1) % kCostWindow;
}

std::string TrainingWindow::message(const RunSink& sink) const {
  char text[120];
  switch (sink.end()) {
    case RunSink::End::completed:
      std::snprintf(text, sizeof text, "Completed in %.1f s. R starts again; close the window to end.",
                    sink.time());
      return text;
    case RunSink::End::limit:
      std::snprintf(text, sizeof text, "Time is up after %.0f s. R starts again; close the window to end.",
                    sink.limit());
      return text;
    case RunSink::End::running:
      break;
  }
  return keys_visible_ ? std::string() : "F1: keys and mouse";
}

ui::OverlayState TrainingWindow::overlay_of(const TickRecord& record, const RunSink& sink,
                                            const LiveLoop& loop) const {
  ui::OverlayState state = overlay_state(prepared_, *scene_, record, sink.afterglow(), sink.task());
  state.ticks.rate_Hz = 1.0 / scene_->tick_s;
  state.ticks.late = loop.late_ticks();
  state.ticks.lost = loop.lost_ticks();
  if (!cpu_ns_.empty()) {
    std::vector<std::int64_t> sorted = cpu_ns_;
    const record::TickCpu cpu = record::tick_cpu_percentiles(sorted);
    state.ticks.cpu_p50_us = cpu.p50;
    state.ticks.cpu_p99_us = cpu.p99;
  }
  state.message = message(sink);
  state.keys_visible = keys_visible_;
  state.keys = key_lines(state, circle_);
  if (mouse_ != nullptr) {
    for (const char* line : input::mouse_help()) state.mapping.emplace_back(line);
  } else {
    state.mapping = {"Drag: look around", "Shift + drag: move the view", "Wheel: zoom"};
  }
  return state;
}

render::FrameState TrainingWindow::frame_of(const TickRecord& record, const RunSink& sink) {
  render::FrameState frame = bridge_.frame(record, circle_shown_ ? sink.afterglow() : Afterglow(),
                                           sink.task(), camera_.camera(), shown_.time_s);
  frame.overlay = overlay_.get();
  return frame;
}

Result<std::filesystem::path> TrainingWindow::save_picture(const RunSink& sink,
                                                           const std::filesystem::path& file) {
  if (const auto laid_out = overlay_->prepare(shown_, renderer_->plan().picture); !laid_out)
    return Error{laid_out.error()};
  if (const auto drawn = renderer_->frame(frame_of(sink.last(), sink)); !drawn) return Error{drawn.error()};
  const auto picture = renderer_->read_back();
  if (!picture) return Error{picture.error()};
  if (const auto written = render::write_png(file, picture.value()); !written) return Error{written.error()};
  return file;
}

void TrainingWindow::draw(const RunSink& sink, LiveLoop& loop) {
  const render::Extent size = window_->pixels();
  if (size.width == 0 || size.height == 0) return;
  const TickRecord& record = loop.newest();
  shown_ = overlay_of(record, sink, loop);
  if (const auto laid_out = overlay_->prepare(shown_, size); !laid_out) {
    error_ = laid_out.error();
    return;
  }
  const auto drawn = renderer_->frame(frame_of(record, sink), *swapchain_, size);
  if (!drawn) {
    error_ = drawn.error();
    return;
  }
  if (drawn.value() && quality_.add(renderer_->last_frame_s())) {
    if (const auto changed = renderer_->set_quality(quality_.quality()); !changed) error_ = changed.error();
  }
}

}  // namespace fulcrum::app
