#include "engine/headset/colocated.h"

#include <cerrno>
#include <cstdio>
#include <span>
#include <system_error>
#include <utility>

#include "engine/app/cli/terminal.h"
#include "engine/files/file_error.h"
#include "engine/files/put_file.h"
#include "haptics/math/number_text.h"
#include "haptics/safety/faults.h"

namespace fulcrum::headset {

Colocated::Colocated(const app::HeadsetOptions& options, std::string device, const MappingDesc& mapping)
    : mapping_(mapping),
      device_(std::move(device)),
      space_(options.space),
      points_(1e-3 * options.colocate_limit_mm),
      p_WD_(mapping.X_WD.p) {}

Colocated::Colocated(scenario::Colocation kept, const MappingDesc& mapping)
    : mapping_(mapping),
      device_(kept.device),
      space_(kept.space),
      kept_(std::move(kept)),
      p_WD_(mapping.X_WD.p) {}

void Colocated::note(const TickEvent& event) {
  p_DH_.reset();
  // What the tick did not take moved nothing in the scene.
  if (!event.sample.connected || (event.record.faults & (kNotFinite | kSampleStale | kDeviceLost)) != 0)
    return;
  p_DH_ = event.sample.X_DH.p;
  p_WD_ = event.record.X_WH.p - mapping_.position_scale * (mapping_.X_WD.q * *p_DH_);
}

void Colocated::touch(double time, const std::array<xr::Hand, xr::kHands>& hands) {
  points_->note({time, hands, p_DH_});
  if (points_->is_taken()) keep();
}

void Colocated::keep() {
  kept_ = {device_, space_, points_->fit()->X_LD, points_->fit()->residuals};
  const std::filesystem::path file = scenario::colocation_file(device_, space_);
  const std::string text = scenario::colocation_text(*kept_);
  const bool is_kept = !file.empty() && put_file_by_part(file, {std::as_bytes(std::span(text))});
  const int why_not = errno;
  if (is_kept) {
    std::fprintf(stderr, "The device stands in %s space as %s has it: residual %s mm.\n", space_.c_str(),
                 file.c_str(), number_text(1e3 * kept_->rms(), 3).c_str());
    return;
  }
  app::complain("where the device stands is known for this run alone" +
                (file.empty() ? ": set XDG_CONFIG_HOME or HOME to keep it."
                              : ". " + kept_file_error("write", file, why_not).sentence));
}

void Colocated::touch_anew() {
  points_->forget("The headset's space may have moved: touch all the points anew.");
}

void Colocated::space_moved() {
  if (is_asked()) touch_anew();
  std::error_code ignored;
  const bool was_on_disk = std::filesystem::remove(scenario::colocation_file(device_, space_), ignored);
  if (!kept_ && !was_on_disk) return;
  kept_.reset();
  app::complain(
      "the headset's " + space_ +
      " space has moved in the room, and where the device stands in it is not known any more: lay "
      "it onto that anew with --colocate" +
      (space_ == app::kLocalSpace ? ", best with --xr-space stage, which recentring leaves alone." : "."));
}

std::optional<Placement> Colocated::placement() const {
  if (!kept_) return std::nullopt;
  return place_on_device({mapping_.X_WD.q, p_WD_}, mapping_.position_scale, kept_->X_LD);
}

std::optional<record::Colocated> Colocated::figures() const {
  if (!kept_) return std::nullopt;
  return record::Colocated{space_, kept_->rms(), kept_->residuals};
}

}  // namespace fulcrum::headset
