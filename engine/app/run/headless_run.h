#pragma once
// The loops without a window: as fast as the ticks go, or by the clock.

#include "drivers/registry.h"
#include "engine/app/run/run_sink.h"
#include "haptics/loop/live_loop.h"

namespace fulcrum::app {

// A stop that a button of the device asks for lasts until another one goes on. acknowledges: a stop by a
// fault does not end the run, where acknowledging it after a second is of avail.
void run_offline(World& world, OpenDevice& device, RunSink& sink, bool acknowledges);
void run_live(World& world, OpenDevice& device, RunSink& sink, bool acknowledges);

// What the operating system refused, and ticks that no record is left of: on stderr.
void report_grant(const LiveLoop& loop);
// The same; how late ticks were, how many were lost: on stderr.
void report_live(const LiveLoop& loop);

}  // namespace fulcrum::app
