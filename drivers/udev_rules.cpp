#include <algorithm>
#include <cstdio>

#include "drivers/driver.h"

namespace fulcrum {
namespace {

// Its numbers on USB; none of a device that a maker's library finds.
std::span<const hid::HidId> ids_of(const Driver& driver) {
  if (driver.usb != nullptr) return driver.usb();
  if (driver.family != nullptr) return driver.family->ids();
  return {};
}

std::string usb_rule(const hid::HidId& id) {
  char rule[160];
  std::snprintf(rule, sizeof rule,
                "SUBSYSTEM==\"usb\", ENV{DEVTYPE}==\"usb_device\", ATTR{idVendor}==\"%04x\", "
                "ATTR{idProduct}==\"%04x\", MODE=\"0660\", TAG+=\"uaccess\"\n",
                id.vendor, id.product);
  return rule;
}

// A node of hidraw by USB has the numbers of the device above it; by Bluetooth they are in that one's name.
std::string hid_rules(const hid::HidId& id) {
  char rules[240];
  std::snprintf(rules, sizeof rules,
                "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", "
                "MODE=\"0660\", TAG+=\"uaccess\"\n"
                "KERNEL==\"hidraw*\", KERNELS==\"0005:%04X:%04X.*\", MODE=\"0660\", TAG+=\"uaccess\"\n",
                id.vendor, id.product, id.vendor, id.product);
  return rules;
}

}  // namespace

std::string udev_rules() {
  std::string rules =
      "# Devices that Fulcrum opens: the person at the seat may. Written by `fulcrum devices --udev`.\n";
  for (const Driver& driver : all_drivers()) {
    if (ids_of(driver).empty()) continue;
    rules += "\n# " + std::string(driver.what) + "\n";
    for (const hid::HidId& id : ids_of(driver)) rules += driver.usb != nullptr ? usb_rule(id) : hid_rules(id);
  }
  return rules;
}

bool knows_usb(std::uint16_t vendor, std::uint16_t product) {
  return std::ranges::any_of(
      all_drivers(),
      [&](const Driver& driver) {
        const std::span<const hid::HidId> ids = ids_of(driver);
        return std::ranges::find(ids, hid::HidId{vendor, product}) != ids.end();
      });
}

}  // namespace fulcrum
