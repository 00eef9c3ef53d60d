#include "engine/app/run/headless_run.h"

#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/run/button_commands.h"
#include "engine/app/run/stop_response.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::app {
namespace {

bool goes_on(const RunSink& sink) {
  return sink.end() == RunSink::End::running && !interrupted();
}

}  // namespace

void run_offline(World& world, OpenDevice& device, RunSink& sink, bool acknowledges) {
  ProgressBar bar;
  StopResponse response(acknowledges, world.desc().tick_s);
  StopResponse::Next next = StopResponse::Next::go_on;
  ButtonCommands buttons(device.stop_buttons, device.go_buttons);
  std::vector<Command> commands;
  while (goes_on(sink) && next != StopResponse::Next::end) {
    TickEvent event;
    run_tick(world, *device.device, commands, event);
    sink.take(event);
    next = response.after(sink.stopped_by_fault());
    commands.clear();
    if (next == StopResponse::Next::acknowledge) commands.push_back({Command::Kind::acknowledge});
    if (const auto pressed = buttons.pressed(event.sample.buttons)) commands.push_back(*pressed);
    bar.show("Running", sink.time() / sink.limit());
  }
}

void run_live(World& world, OpenDevice& device, RunSink& sink, bool acknowledges) {
  LiveLoop loop(world, *device.device);
  ProgressBar bar;
  StopResponse response(acknowledges, world.desc().tick_s);
  StopResponse::Next next = StopResponse::Next::go_on;
  ButtonCommands buttons(device.stop_buttons, device.go_buttons);
  loop.start();
  while (goes_on(sink) && next != StopResponse::Next::end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    TickEvent event;
    while (goes_on(sink) && next != StopResponse::Next::end && loop.next(event)) {
      sink.take(event);
      next = response.after(sink.stopped_by_fault());
      if (next == StopResponse::Next::acknowledge) loop.send({Command::Kind::acknowledge});
      if (const auto pressed = buttons.pressed(event.sample.buttons)) loop.send(*pressed);
    }
    sink.flush_if_due();
    bar.show("Running", sink.time() / sink.limit());
  }
  loop.stop();
  bar.clear();
  report_live(loop);
}

void report_grant(const LiveLoop& loop) {
  if (!loop.grant().scheduling.empty()) complain(loop.grant().scheduling);
  if (!loop.grant().memory.empty()) complain(loop.grant().memory);
  if (loop.unrecorded() > 0)
    complain(std::to_string(loop.unrecorded()) +
             " ticks ran but were not recorded, because the disk or the display held the main thread up for "
             "too long.");
}

void report_live(const LiveLoop& loop) {
  report_grant(loop);
  std::fprintf(stderr, "Late ticks: %llu, lost: %llu. Ticks by how late they began:",
               static_cast<unsigned long long>(loop.late_ticks()),
               static_cast<unsigned long long>(loop.lost_ticks()));
  const LateHistogram& histogram = loop.late_histogram();
  for (std::size_t i = 0; i < histogram.size(); ++i)
    if (histogram[i] > 0)
      std::fprintf(stderr, "  <%llu us: %llu", 1ULL << i, static_cast<unsigned long long>(histogram[i]));
  std::fputc('\n', stderr);
}

}  // namespace fulcrum::app
