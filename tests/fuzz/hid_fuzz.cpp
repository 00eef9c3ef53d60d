// Reference: none; any bytes as the reports of each device that is pushed, of one that pushes, and of a
// strip. Invariants: axes are from -1 to 1, what is refused changes nothing, and what is sent is as long as
// its kind; a pose is one, within the reach of its arm, currents are what the motors take, and actuators are
// told nothing that harms them; a reading is no negative resistance, and a strip is told nothing. A first
// byte of odd value has the checksum of a Bluetooth report put right, so that what stands behind it is
// reached.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/dualshock4/dualshock4_protocol.h"
#include "drivers/hid/hid_bytes.h"
#include "drivers/joycon/joycon_protocol.h"
#include "drivers/polhem/polhem_bus.h"
#include "drivers/spacemouse/spacemouse_protocol.h"
#include "drivers/strip/strip_bus.h"

namespace fulcrum {
namespace {

void require(bool good) {
  if (!good) std::abort();
}

bool same(const PushedAxes& a, const PushedAxes& b) {
  return a.way == b.way && a.turn == b.turn && a.buttons == b.buttons;
}

void feed(hid::HidProtocol& device, std::span<const std::uint8_t> report) {
  PushedAxes axes;
  const PushedAxes before = axes;
  if (!device.decode(report, axes)) require(same(axes, before));
  for (const double value :
       {axes.way.x(), axes.way.y(), axes.way.z(), axes.turn.x(), axes.turn.y(), axes.turn.z()})
    require(std::abs(value) <= 1);
  device.learn(report);

  ChannelDrives drives{};
  if (report.size() >= sizeof drives) std::memcpy(drives.data(), report.data(), sizeof drives);
  hid::HidProtocol::Report sent{};
  const std::size_t length = device.encode(drives, sent);
  require(length == 0 || length == 10 || length == 32 || length == 63 || length == 78);
  if (length == 10)
    for (std::size_t at = 2; at < length; at += 4)
      require((sent[at + 1] & 0xFE) <= 0xC8 && sent[at + 3] >= 0x40 && sent[at + 3] <= 0x72);
  const std::size_t asked = device.ask(sent);
  require(asked == 0 || asked == 12 || asked == 16);
}

// Its arm, as content/devices/polhem.yaml has it.
DeviceDesc polhem_desc() {
  DeviceDesc desc;
  desc.mechanism.q_DK = Quat(0.5, -0.5, -0.5, -0.5);
  desc.mechanism.arms = {
      {"arm",
       {{.axis_K = {0, 0, 1}},
        {.axis_K = {0, -1, 0}, .point_K = {0, 0, 0.058}, .home = -0.4393498},
        {.axis_K = {0, -1, 0}, .point_K = {0, 0, 0.232}, .home = 0.9585170, .through_parallelogram = true}},
       Vec3(0, 0, 0.099)}};
  return desc;
}

// The bytes as reports, one after another, each with its length before it.
class BytesPort final : public hid::HidPort {
public:
  // pushes: it may be told something.
  BytesPort(std::span<const std::uint8_t> bytes, bool pushes) : bytes_(bytes), pushes_(pushes) {}
  int read(std::span<std::uint8_t> report, int) override {
    if (bytes_.empty()) return -1;
    const std::size_t length = std::min<std::size_t>({bytes_[0] % 72u, bytes_.size() - 1, report.size()});
    std::copy_n(bytes_.begin() + 1, length, report.begin());
    bytes_ = bytes_.subspan(1 + length);
    return static_cast<int>(length);
  }
  bool write(std::span<const std::uint8_t> report) override {
    require(pushes_);
    require(report.size() == 15 && report[0] == 0);
    const auto number = [&](std::size_t i) {
      return static_cast<std::int16_t>(
          static_cast<std::uint16_t>(report[1 + 2 * i] | report[2 + 2 * i] << 8));
    };
    if (number(3) == 0)
      for (std::size_t i = 0; i < 3; ++i) require(std::abs(number(i)) <= polhem::kMostCurrent_mA);
    return true;
  }
  int read_feature(std::span<std::uint8_t>) override { return -1; }

private:
  std::span<const std::uint8_t> bytes_;
  bool pushes_;
};

void feed_polhem(std::span<const std::uint8_t> bytes) {
  static const DeviceDesc desc = polhem_desc();
  polhem::PolhemBus bus(std::make_unique<BytesPort>(bytes, true), desc);
  DeviceSample sample;
  DeviceCommand command;
  if (bytes.size() >= 24) std::memcpy(command.effort.data(), bytes.data(), 24);
  for (ForceBus::Turn turn = ForceBus::Turn::none; turn != ForceBus::Turn::lost;) {
    turn = bus.exchange(command, sample);
    require(sample.X_DH.is_finite() && sample.X_DH.p.norm() < 1 && std::abs(sample.X_DH.q.norm() - 1) < 1e-9);
    (void)bus.trouble();
  }
}

void feed_strip(std::span<const std::uint8_t> bytes) {
  strip::StripBus bus(std::make_unique<BytesPort>(bytes, false), DeviceDesc());
  DeviceSample sample;
  for (ForceBus::Turn turn = ForceBus::Turn::none; turn != ForceBus::Turn::lost;) {
    turn = bus.exchange({}, sample);
    require(!(sample.strip_ohm < 0) && sample.age == 0 && sample.connected);
    (void)bus.trouble();
  }
}

}  // namespace
}  // namespace fulcrum

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulcrum;
  if (size == 0) return 0;
  std::vector<std::uint8_t> report(data + 1, data + size);
  if (data[0] % 2 == 1 && report.size() >= 78)
    hid::put_u32(report, 74, hid::crc32(0xA1, std::span(report).first(74)));
  feed_polhem(report);
  feed_strip(report);
  for (const joycon::Side side : {joycon::Side::left, joycon::Side::right, joycon::Side::both}) {
    joycon::JoyConProtocol half(side, data[0] * 6.0);
    for (int time = 0; time < 6; ++time) feed(half, report);
  }
  SpaceMouseProtocol mouse;
  feed(mouse, report);
  for (const sony::Link link : {sony::Link::usb, sony::Link::bluetooth}) {
    dualsense::DualSenseProtocol dualsense(link);
    feed(dualsense, report);
    dualshock4::DualShock4Protocol dualshock4(link);
    feed(dualshock4, report);
  }
  return 0;
}
