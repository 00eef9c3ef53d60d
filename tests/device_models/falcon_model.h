#pragma once
// A Falcon as it is seen from its USB cable and from the hand at its grip, without a bus: whoever stands in
// for a bus hands its requests and packets to it. Written from libnifalcon's sources; it shares no code with
// the driver.
//
// Each call is whole by itself: bus and hand may be different threads.

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum::test {

class FalconModel {
public:
  using Bytes = std::vector<std::uint8_t>;

  // firmware: what its boot loader takes. runs: it has taken it already.
  explicit FalconModel(Bytes firmware, bool runs = false);

  // From the cable.
  static Bytes device_descriptor();
  static Bytes configuration_descriptor();
  // A request without data. False: it stalls.
  bool control(int type, int request, int value, int index);
  void out(std::span<const std::uint8_t> bytes);  // to endpoint 2
  bool has_more() const;                          // endpoint 0x81 has more to say than the line's state
  Bytes in();                                     // the next packet from there, line's state first

  // From the hand. D: x right, y up, z towards the person, the origin 0.125 m before the base.
  void hold(const Vec3& p_D);
  void press(unsigned buttons);
  // Pulled out and pushed in. False: the firmware did not look for the legs' marks.
  bool home();
  void lose_home();
  void switch_off_and_on();
  Vec3 force_D() const;  // N, of the motors on the hand, where it is

  // What it was told.
  std::array<int, 3> motors() const;
  unsigned lights() const;
  bool runs() const;
  int packets() const;              // since it was made
  std::size_t most_unread() const;  // bytes of its firmware that had gone back and were not yet read

  // Faults.
  enum class Fault {
    none,
    silent,         // it says nothing
    garbles,        // what it says is wrong in a bit
    never_greets,   // its boot loader does not answer
    impossible,     // its counts are no Falcon's
    zero_at_first,  // a byte of nothing stands before the boot loader's answer
    one_by_one      // it says a byte in each packet
  };
  void have(Fault fault);

private:
  enum class Processor { off, listens, greeted, loads, runs };
  void hear(std::uint8_t byte);
  void hear_packet();
  void say(Bytes bytes);
  std::array<double, 3> angles_at(const Vec3& p_D) const;
  std::array<int, 3> counts() const;

  const Bytes firmware_;
  mutable std::mutex mutex_;
  Processor processor_;
  Fault fault_ = Fault::none;
  int latency_ = 16, baud_ = 0, data_ = 0, flow_ = -1;
  bool rts_ = true, dtr_ = false;
  Bytes heard_, said_, taken_;
  Vec3 p_D_ = Vec3::Zero();
  unsigned buttons_ = 0, lights_ = 0;
  bool homed_ = false;
  std::array<int, 3> motors_{};
  int packets_ = 0;
  std::size_t most_unread_ = 0;
};

}  // namespace fulcrum::test
