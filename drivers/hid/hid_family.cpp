#include "drivers/hid/hid_family.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "drivers/permission.h"

namespace fulcrum::hid {

std::optional<HidPlace> find_one(const HidFamily& family) {
  std::vector<HidPlace> places = find_hid(family.ids(), family.nodes);
  std::erase_if(places, [&](const HidPlace& p) { return !p.product.starts_with(family.product); });
  if (places.empty()) return std::nullopt;
  const auto open = std::ranges::find(places, true, &HidPlace::permitted);
  return open != places.end() ? *open : places.front();
}

Result<HidPlace> place_of(const HidFamily& family) {
  std::optional<HidPlace> place = find_one(family);
  if (!place)
    return Error{family.nodes != Nodes::of_axes
                     ? "none is plugged in: plug one in, and switch it on."
                     : "none is plugged in, and none is paired and awake: plug one in."};
  if (!place->permitted) return not_permitted(place->path);
  return std::move(*place);
}

Result<std::unique_ptr<HidPort>> open_one(const HidFamily& family) {
  const Result<HidPlace> place = place_of(family);
  if (!place) return place.error();
  return open_hid(*place);
}

Result<HidOpened> open_spoken(const HidFamily& family, const VibrotactileSignal& signal) {
  const Result<HidPlace> place = place_of(family);
  if (!place) return place.error();
  Result<std::unique_ptr<HidPort>> port = open_hid(*place);
  if (!port) return port.error();
  return HidOpened{std::move(*port), family.protocol(*place, signal)};
}

}  // namespace fulcrum::hid
