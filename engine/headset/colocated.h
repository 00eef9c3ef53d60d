#pragma once
// A device on a desk that a headset shows where it is felt: where its base stands in the headset's space, as
// was kept or as points are touched now, and where the scene is for that.

#include <optional>
#include <string>

#include "engine/app/prepare/colocation_choice.h"
#include "engine/headset/placement.h"
#include "engine/headset/touched_points.h"
#include "engine/record/summary.h"
#include "haptics/device/mapping.h"
#include "haptics/loop/tick_event.h"

namespace fulcrum::headset {

class Colocated {
public:
  // Points are touched first. device: of device_on_desk().
  Colocated(const app::HeadsetOptions& options, std::string device, const MappingDesc& mapping);
  // As it was kept.
  Colocated(scenario::Colocation kept, const MappingDesc& mapping);

  // Each tick: where the handle is.
  void note(const TickEvent& event);

  // Points are being touched, and squeezes and stops are for them.
  bool is_asked() const { return points_ && !points_->is_taken(); }
  // One picture of that. hands: at `time` (s). Once enough is there it is kept, and holds from then on.
  void touch(double time, const std::array<xr::Hand, xr::kHands>& hands);
  // A picture that nobody sees.
  void look_away() { points_->look_away(); }
  // What was touched so far may be of another space.
  void touch_anew();
  // What to do now, a line each.
  std::string text() const { return points_->text(); }

  // The headset's space has moved in the room: what was touched or kept is of a place that is no more. It is
  // forgotten, its file goes, and a sentence on stderr says so.
  void space_moved();

  // Of the scene, where it is known where the device stands: the handle is seen where it is. What the
  // clutch, drift or a start elsewhere has put between it and the scene, the scene is moved by.
  std::optional<Placement> placement() const;
  // Of a summary; none where nothing is known.
  std::optional<record::Colocated> figures() const;

private:
  void keep();

  MappingDesc mapping_;
  std::string device_, space_;
  std::optional<TouchedPoints> points_;  // none: they were not asked for
  std::optional<scenario::Colocation> kept_;
  std::optional<Vec3> p_DH_;  // of the newest tick, where the device said it
  Vec3 p_WD_;                 // where the scene's base is, by what the handle does there
};

}  // namespace fulcrum::headset
