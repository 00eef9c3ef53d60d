#pragma once
// What the buttons of a device ask for that stand for Esc and Enter.

#include <cstdint>
#include <optional>
#include <utility>

#include "haptics/tick/command.h"

namespace fulcrum::app {

class ButtonCommands {
public:
  ButtonCommands() = default;
  // Of DeviceSample::buttons.
  ButtonCommands(std::uint32_t stop, std::uint32_t go) : stop_(stop), go_(go) {}

  // down: in the newest sample. What was pressed since the one before; a stop, where both were.
  std::optional<Command> pressed(std::uint32_t down) {
    const std::uint32_t pressed = down & ~std::exchange(down_, down);
    if ((pressed & stop_) != 0) return Command{Command::Kind::stop};
    if ((pressed & go_) != 0) return Command{Command::Kind::acknowledge};
    return std::nullopt;
  }

private:
  std::uint32_t stop_ = 0, go_ = 0, down_ = 0;
};

}  // namespace fulcrum::app
