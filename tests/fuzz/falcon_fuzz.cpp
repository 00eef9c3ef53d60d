// Reference: none; any bytes as what a Falcon says, from its first packet on: its boot loader, its echo and
// its packets, each piece with its length before it. Invariants: what it is told is as long as its kind, and
// motors are told what they take; they rest unless the packet before was answered with a place; a place is
// one, within reach; no more firmware goes out than one chunk beyond its echo; and whatever comes, starting
// it ends.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "drivers/falcon/falcon_bus.h"

namespace fulcrum {
namespace {

constexpr std::size_t kFirmwareBytes = 200, kChunkBytes = 62;

void insist(bool good) {
  if (!good) std::abort();
}

class PiecesPort final : public usb::UsbPort {
public:
  explicit PiecesPort(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool control(std::uint8_t, std::uint16_t) override { return !bytes_.empty(); }
  bool write(std::span<const std::uint8_t> bytes) override {
    insist(!bytes.empty() && bytes.size() <= kChunkBytes);
    if (bytes.size() == falcon::kPacketBytes && bytes[0] == '<') check_motors(bytes);
    return true;
  }
  int read(std::span<std::uint8_t> packet, int) override {
    insist(packet.size() == usb::kPacketBytes);
    if (bytes_.empty()) return -1;
    const std::size_t length = std::min<std::size_t>({bytes_[0] % 65u, bytes_.size() - 1, packet.size()});
    std::copy_n(bytes_.begin() + 1, length, packet.begin());
    bytes_ = bytes_.subspan(1 + length);
    return static_cast<int>(length);
  }

  bool may_push = false;

private:
  void check_motors(std::span<const std::uint8_t> packet) const {
    insist(packet[15] == '>');
    for (std::size_t leg = 0; leg < 3; ++leg) {
      unsigned word = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        insist(packet[1 + 4 * leg + i] >= 'A' && packet[1 + 4 * leg + i] <= 'P');
        word |= static_cast<unsigned>(packet[1 + 4 * leg + i] - 'A') << 4 * i;
      }
      const int motor = static_cast<std::int16_t>(static_cast<std::uint16_t>(word));
      insist(std::abs(motor) <= falcon::kMostMotor && (may_push || motor == 0));
    }
  }

  std::span<const std::uint8_t> bytes_;
};

Result<std::vector<std::uint8_t>> some_firmware() {
  return std::vector<std::uint8_t>(kFirmwareBytes, 'Z');
}

void feed_falcon(std::span<const std::uint8_t> bytes, const DeviceCommand& command) {
  auto owned = std::make_unique<PiecesPort>(bytes);
  PiecesPort& port = *owned;
  falcon::FalconBus bus(std::move(owned), &some_firmware);
  DeviceSample sample;
  for (ForceBus::Turn turn = ForceBus::Turn::none; turn != ForceBus::Turn::lost;) {
    turn = bus.exchange(command, sample);
    port.may_push = turn == ForceBus::Turn::fresh;
    insist(sample.X_DH.is_finite() && sample.X_DH.p.norm() < 0.2 && sample.buttons < 16);
    (void)bus.trouble();
  }
}

}  // namespace
}  // namespace fulcrum

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulcrum;
  if (size < 12) return 0;
  // A force of any size and kind: three floats.
  std::array<float, 3> force{};
  std::memcpy(force.data(), data, sizeof force);
  DeviceCommand command;
  command.F_H_D.force = Vec3(force[0], force[1], force[2]);
  feed_falcon(std::span(data, size).subspan(12), command);
  return 0;
}
