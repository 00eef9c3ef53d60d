#pragma once
// A Falcon from when it is opened to its first packet. Switched on, its processor has a boot loader alone,
// which takes the firmware and gives every byte of it back; firmware that runs already is left alone.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "drivers/falcon/falcon_line.h"
#include "drivers/falcon/falcon_packets.h"
#include "haptics/math/result.h"

namespace fulcrum::falcon {

class FalconBoot {
public:
  // Asked for once, and only where the device has none.
  using Firmware = std::function<Result<std::vector<std::uint8_t>>()>;

  enum class State {
    going,
    done,   // the firmware answers
    failed  // and why() says why
  };

  explicit FalconBoot(Firmware firmware) : load_(std::move(firmware)) {}

  // The next step, which waits for some ms at most. Always the same line.
  State advance(FalconLine& line);
  State state() const { return state_; }
  // A sentence with its remedy; empty unless it has failed.
  const std::string& why() const { return why_; }

private:
  enum class Step { asks, greets, signs, uploads, asks_again };
  // One for each step. tries_: how often in a row it has gone without what it waits for.
  void ask(FalconLine& line);
  void greet(FalconLine& line);
  void sign(FalconLine& line);
  void upload(FalconLine& line);

  void begin(Step step, bool set);  // set: the line took the step's settings
  void read_firmware(FalconLine& line);
  void send_chunk(FalconLine& line);
  void fail(std::string why);
  // Bytes of the line, or none.
  std::span<const std::uint8_t> hear(FalconLine& line);

  Firmware load_;
  State state_ = State::going;
  Step step_ = Step::asks;
  bool begun_ = false;  // the line is set as the first step needs it
  int tries_ = 0;
  std::string why_;
  std::array<std::uint8_t, FalconLine::kMostRead> heard_{};
  PacketStream packets_;
  std::size_t matched_ = 0;  // bytes of the boot loader's answer
  bool signed_ = false;
  std::vector<std::uint8_t> firmware_;
  std::size_t sent_ = 0, echoed_ = 0;  // bytes of it
};

}  // namespace fulcrum::falcon
