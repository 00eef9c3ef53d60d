#include "drivers/hid/hid_family.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "drivers/permission.h"

namespace fulcrum::hid {

namespace {

std::vector<HidPlace> all_of(const HidFamily& family) {
  std::vector<HidPlace> places = find_hid(family.ids(), family.nodes);
  std::erase_if(places, [&](const HidPlace& p) { return !p.product.starts_with(family.product); });
  return places;
}

std::optional<HidPlace> first_of(const std::vector<HidPlace>& places) {
  if (places.empty()) return std::nullopt;
  const auto open = std::ranges::find(places, true, &HidPlace::permitted);
  return open != places.end() ? *open : places.front();
}

Result<HidPlace> permitted(const HidFamily& family, std::optional<HidPlace> place) {
  if (!place)
    return Error{family.nodes != Nodes::of_axes
                     ? "none is plugged in: plug one in, and switch it on."
                     : "none is plugged in, and none is paired and awake: plug one in."};
  if (!place->permitted) return not_permitted(place->path);
  return std::move(*place);
}

struct At {
  HidPlace place;
  std::unique_ptr<HidPort> port;
};

Result<At> open_own(const HidFamily& family, OwnDevice& own) {
  const std::vector<HidPlace> all = all_of(family);
  std::vector<HidPlace> places = all;
  own.keep_own(places);
  const Result<HidPlace> place = permitted(family, first_of(places));
  if (!place) return place.error();
  Result<std::unique_ptr<HidPort>> port = open_hid(*place);
  if (!port) return port.error();
  own.be(*place, all);
  return At{*place, std::move(*port)};
}

}  // namespace

std::optional<HidPlace> find_one(const HidFamily& family) {
  return first_of(all_of(family));
}

Result<HidPlace> place_of(const HidFamily& family) {
  return permitted(family, find_one(family));
}

Result<std::unique_ptr<HidPort>> open_one(const HidFamily& family, OwnDevice& own) {
  Result<At> at = open_own(family, own);
  if (!at) return at.error();
  return std::move(at->port);
}

Result<HidOpened> open_spoken(const HidFamily& family, const VibrotactileSignal& signal, OwnDevice& own) {
  Result<At> at = open_own(family, own);
  if (!at) return at.error();
  return HidOpened{std::move(at->port), family.protocol(at->place, signal)};
}

}  // namespace fulcrum::hid
