#pragma once
// summary.json: what a run came to. Scripts rely on its names and meanings; what is not known is null.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/record/hand_to_pixel.h"
#include "engine/record/percentiles.h"
#include "engine/record/run_totals.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

struct CheckpointResult {
  std::string name;
  std::optional<double> reached_s;
};

// Of what the task counts.
struct Counted {
  std::int64_t count = 0;
  double time_s = 0;  // that they lasted
};

// From a tick to the output of the sound card that plays it.
struct SoundLatency {
  double mean_ms = 0, max_ms = 0;
};

// What was heard of the scene: of blows, from the end of a blow's tick to the loudspeaker.
struct HeardScene {
  std::string device;
  std::int64_t blows = 0;
  std::int64_t dropped = 0;  // for stronger ones
  std::int64_t late = 0;     // not played
  bool unplugged = false;    // the device has gone meanwhile
  std::optional<SoundLatency> latency{};
};

// "12 blows on Built-in Audio: 17 ms from a blow to the loudspeaker, at most 20 ms".
std::string heard_text(const HeardScene& heard);

// The device was seen in a headset where it was felt: how well, and in which of its spaces.
struct Colocated {
  std::string space;
  double residual_m = 0;            // RMS, of the points that were touched
  std::vector<double> residuals_m;  // (n) of each
};

struct Summary {
  std::string scenario;
  std::string device;
  std::string hand;
  bool left_handed = false;  // the scene was mirrored
  std::int64_t seed = 1;
  std::int64_t ticks = 0;
  double tick_s = 1e-3;
  bool completed = false;
  bool guided = false;  // the person was led, be it for a tick
  std::vector<CheckpointResult> checkpoints;
  std::optional<double> completion_time_s;
  // Absent where the task does not count them.
  std::optional<Counted> hard_touches, trespasses;
  std::optional<std::int64_t> slips;
  double torque_error_Nms = 0;
  double force_error_Ns = 0, force_error_rendered_Ns = 0;  // of contact; what the motors were told
  double peak_force_N = 0, peak_force_rendered_N = 0;
  double peak_torque_Nm = 0, peak_torque_rendered_Nm = 0;
  std::optional<double> max_penetration_m;
  std::optional<double> max_penetration_within_m;   // no tick was deeper than the two together
  std::optional<double> max_penetration_at_s;       // absent where nothing was touched
  std::optional<std::string> max_penetration_part;  // of the scene, at the deepest point
  std::optional<TickCpu> tick_cpu_us;
  std::optional<SoundLatency> sound_latency;  // of voice coils; absent where no sound card played them
  std::optional<HeardScene> heard;            // absent where nobody listened
  std::optional<double> frames_per_s;         // that the window drew; absent without one
  std::optional<HandToPixel> hand_to_pixel;   // of the frames that somebody saw
  std::optional<Colocated> colocation;        // absent where the scene stood elsewhere
  std::int64_t late_ticks = 0;
  std::int64_t lost_ticks = 0;
  std::vector<FaultCount> faults;
  std::vector<FaultCount> limits;
  std::vector<std::string> built;
  std::vector<std::string> left_out;
  std::optional<std::string> trace_sha256;

  // ticks, errors, peaks, faults and limits.
  void take(const RunTotals& totals);
};

std::string summary_json(const Summary& summary);

// As a new file FOLDER/summary.json.
Result<std::filesystem::path> write_summary(const std::filesystem::path& folder, const Summary& summary);

}  // namespace fulcrum::record
