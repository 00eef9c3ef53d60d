#pragma once
// An open HID device, as bytes. One thread may read while another writes.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drivers/hid/hid_id.h"
#include "haptics/math/result.h"

namespace fulcrum::hid {

class HidPort {
public:
  virtual ~HidPort() = default;
  // A report, its number first where the device numbers them. Bytes that were read; 0: none came in that
  // time; below 0: the device is gone. wait_ms: 0 does not wait.
  virtual int read(std::span<std::uint8_t> report, int wait_ms) = 0;
  // False: it was not taken.
  virtual bool write(std::span<const std::uint8_t> report) = 0;
  // feature[0]: which one. Bytes that were read, below 0 where there is none such.
  virtual int read_feature(std::span<std::uint8_t> feature) = 0;
};

// A device that is plugged in.
struct HidPlace {
  HidId id;
  std::string path;  // of its node
  bool bluetooth = false;
  std::string product;        // what it calls itself; may be empty
  bool permitted = true;      // the node may be read and written
  std::uint16_t release = 0;  // of its firmware, two decimal digits before the point and two after it, four
                              // bits each; 0: its bus does not tell
  std::string serial{};       // of the device, where its bus tells it
  std::string port{};         // of USB, that it is plugged in at; empty: it is not known
};

// One device may have several nodes.
enum class Nodes {
  of_axes,    // those that report a joystick's, a pad's or a cap's axes
  of_vendor,  // those of the usage page that is free to everybody, 0xFF00
  all
};
// Those of `ids` that are there now, in the order of their paths.
std::vector<HidPlace> find_hid(std::span<const HidId> ids, Nodes nodes = Nodes::of_axes);

// Errors: the node cannot be opened, with what would cure it.
Result<std::unique_ptr<HidPort>> open_hid(const HidPlace& place);

}  // namespace fulcrum::hid
