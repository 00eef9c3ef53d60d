#pragma once
// What the reports of Sony's pads have in common.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum::sony {

// How a pad is connected: its reports differ.
enum class Link { usb, bluetooth };

// The checksum of a report that came by Bluetooth, 78 bytes, is right.
bool whole_input(std::span<const std::uint8_t> report);
// Ends one that is to be sent with its checksum.
void seal_output(std::span<std::uint8_t> report);

// The gyroscope's readings, of what follows the first byte of the sticks.
std::array<std::int16_t, 3> gyro_at(std::span<const std::uint8_t> sticks, std::size_t at);

inline constexpr std::size_t kUsbInput = 64, kBluetoothReport = 78;

// 0 to 255. drive: 0 to 1; what is no number is 0.
std::uint8_t motor_byte(double drive);

}  // namespace fulcrum::sony
