#include "engine/app/window/prepare_in_window.h"

#include <GLFW/glfw3.h>

#include <chrono>
#include <future>
#include <mutex>
#include <utility>

#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/run/expert.h"

namespace fulcrum::app {
namespace {

using namespace std::chrono_literals;

// Ends a bake, or the watching, from within its progress.
struct Closed {};

// What the thread that prepares says and the window's shows, and the other way about.
class Progress {
public:
  explicit Progress(const std::string& title) : shown_{title, "Reading the models", 0, "Esc: cancel"} {}

  void tell(std::string_view what, double fraction) {
    const std::lock_guard lock(mutex_);
    if (closed_) throw Closed();
    shown_.what = what;
    shown_.fraction = fraction;
    shown_.note = "Once only: the next start finds it in the cache. Esc: cancel";
  }
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    shown_.what = "Ending";
    shown_.note.clear();
  }
  ui::Busy shown() const {
    const std::lock_guard lock(mutex_);
    return shown_;
  }

private:
  mutable std::mutex mutex_;
  ui::Busy shown_;
  bool closed_ = false;
};

}  // namespace

PreparedInWindow prepare_in_window(WindowStage& stage, const std::string& name, scenario::Scenario scenario) {
  Progress progress(scenario.title);
  auto preparing = std::async(std::launch::async, [&] {
    PreparedInWindow ready;
    try {
      ready.prepared =
          prepare(name, std::move(scenario), [&progress](std::string_view what, double fraction) {
            progress.tell("Baking the " + std::string(what), fraction);
          });
      if (ready.prepared)
        ready.expert = watch_expert(*ready.prepared, [&progress](double fraction) {
          progress.tell("Watching the expert", fraction);
          return true;
        });
    } catch (const Closed&) {
      ready = {};
    }
    return ready;
  });
  ui::WindowEvents events;
  bool cancelled = false;
  events.key = [&](int key, int action, int) {
    if (key != GLFW_KEY_ESCAPE || action != GLFW_PRESS) return;
    cancelled = true;
    progress.close();
  };
  stage.window().set_events(std::move(events));
  bool closed = false;
  // Now and then is often enough: the processor has other things to do.
  while (!closed && preparing.wait_for(100ms) != std::future_status::ready) {
    const Result<bool> open = stage.show(progress.shown());
    if (!open) complain(open.error().sentence);
    closed = !open || !*open || interrupted();
  }
  stage.window().set_events({});
  if (closed) {
    progress.close();
    stage.window().hide();  // what is under way ends at its next report, which may take seconds
  }
  PreparedInWindow ready = preparing.get();
  ready.closed = closed;
  ready.cancelled = cancelled && !closed;
  return ready;
}

}  // namespace fulcrum::app
