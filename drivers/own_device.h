#pragma once
// Which of several devices of a kind is a run's own. A device that is plugged in again is the one that the
// run began with, and no other, whichever is listed first: its frame, its calibration and the hand at it are
// not another one's.
//
// By its serial number, where its bus tells one and it is nobody else's. Otherwise by its port, and at
// another port only where no other device of the kind had been: one that is there at the first look after the
// loss was there before, since nobody is so fast with a plug.

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum {

// Used by one thread at a time. Place: where a device is plugged in, by `serial` and `port`; empty ones are
// not known. One device may have several places, at one port.
class OwnDevice {
public:
  // The run goes on with the device at `mine`. all: what was there then.
  template <class Place>
  void be(const Place& mine, const std::vector<Place>& all) {
    const bool shared = std::ranges::any_of(
        all, [&](const Place& p) { return p.serial == mine.serial && p.port != mine.port; });
    serial_ = shared ? "" : mine.serial;
    port_ = mine.port;
    looks_ = false;
    remember_others(all);
  }

  // Leaves those that may be it; all of them before the run has one. Each call is a look for one that is
  // away.
  template <class Place>
  void keep_own(std::vector<Place>& places) {
    if (!port_) return;
    if (!serial_.empty()) {
      std::erase_if(places, [&](const Place& p) { return p.serial != serial_; });
      return;
    }
    if (!std::exchange(looks_, true)) remember_others(places);
    const bool back = std::ranges::count(places, *port_, &Place::port) > 0;
    std::erase_if(
        places, [&](const Place& p) { return back ? p.port != *port_ : others_.contains(p.port); });
    const bool several =
        std::ranges::any_of(places, [&](const Place& p) { return p.port != places.front().port; });
    if (several) places.clear();  // nobody can tell
  }

private:
  template <class Place>
  void remember_others(const std::vector<Place>& places) {
    others_.clear();
    for (const Place& place : places)
      if (place.port != *port_) others_.insert(place.port);
  }

  std::string serial_;
  std::optional<std::string> port_{};  // none: there was none yet
  std::set<std::string> others_;       // ports of others
  bool looks_ = false;                 // it is away
};

}  // namespace fulcrum
