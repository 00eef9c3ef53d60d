#include "tests/device_models/falcon_usb.h"

namespace fulcrum::test {
namespace {

constexpr std::uint8_t kBulkIn = 1, kBulkOut = 2, kVendorsOut = 0x40;
constexpr int kDevice = 1, kConfiguration = 2;        // kinds of descriptors
constexpr std::chrono::milliseconds kStateEvery{16};  // where there is nothing else to say

}  // namespace

std::optional<Bytes> FalconUsb::control(const UsbSetup& setup, std::span<const std::uint8_t>) {
  switch (setup.type << 8 | setup.request) {
    case kGetStatus:
      return Bytes{0, 0};
    case kGetDescriptor:
      if (setup.value >> 8 == kDevice) return FalconModel::device_descriptor();
      if (setup.value >> 8 == kConfiguration) return FalconModel::configuration_descriptor();
      return std::nullopt;
    case kSetConfiguration:
    case kSetInterface:
    case kClearStall:
      return Bytes{};
    default:
      if (setup.type != kVendorsOut || !falcon_.control(setup.type, setup.request, setup.value, setup.index))
        return std::nullopt;
      return Bytes{};
  }
}

bool FalconUsb::out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) {
  if (endpoint != kBulkOut) return false;
  falcon_.out(bytes);
  return true;
}

std::optional<Bytes> FalconUsb::in(std::uint8_t endpoint) {
  if (endpoint != kBulkIn) return std::nullopt;
  const Clock::time_point now = Clock::now();
  if (!falcon_.has_more() && now - said_ < kStateEvery) return std::nullopt;
  said_ = now;
  return falcon_.in();
}

}  // namespace fulcrum::test
