#include "engine/app/doctor/held_devices.h"

namespace fulcrum::app {

Finding devices_in(const std::vector<DeviceListing>& devices, const DeviceListing& best) {
  for (const DeviceListing& device : devices)
    if (device.permitted == false)
      return {"devices", Health::bad, device.name + ": " + device.reason,
              "tools/run --udev, then plug it in again"};
  if (!best.present)
    return {"devices", Health::fair, "Nothing is there that a hand could hold.",
            "fulcrum devices says what each lacks"};
  if (best.name == "mouse")
    return {"devices", Health::fair, "The mouse is the only device here, and it cannot push.",
            "fulcrum devices says what others lack"};
  return {"devices", Health::good, "A run takes " + best.name + ", " + best.what + ".", ""};
}

}  // namespace fulcrum::app
