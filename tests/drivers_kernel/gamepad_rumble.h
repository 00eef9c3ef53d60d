#pragma once
// A pad's rumble as games ask Linux for it: by the force feedback of its node in /dev/input, which Linux's
// own driver of the pad answers for.

#include <cstdint>
#include <memory>

namespace fulcrum::test {

class GamepadRumble {
public:
  // The first node that rumbles; null: there is none yet.
  static std::unique_ptr<GamepadRumble> find();
  ~GamepadRumble();
  GamepadRumble(const GamepadRumble&) = delete;
  GamepadRumble& operator=(const GamepadRumble&) = delete;

  // False: the kernel refuses.
  bool play(std::uint16_t strong, std::uint16_t weak);
  bool stop();

private:
  explicit GamepadRumble(int file) : file_(file) {}
  bool begin(int times);  // 0: it ends

  int file_;
  std::int16_t effect_ = -1;  // the kernel's number of it, once it has one
};

}  // namespace fulcrum::test
