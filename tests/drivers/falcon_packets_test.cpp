// A Falcon's packets, against ones that are spelled out here.

#include "drivers/falcon/falcon_packets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace fulcrum::test {
namespace {

using FalconBytes = std::vector<std::uint8_t>;

FalconBytes letters(std::string_view text) {
  return {text.begin(), text.end()};
}

// 1, -2 and 0x1234, the low nibble first; homed, with buttons 0 and 2 down.
FalconBytes homed_packet() {
  FalconBytes packet = letters("<BAAAOPPPEDCB.A>");
  packet[13] = 'A' + 0x75;
  return packet;
}

TEST(FalconPackets, CountsButtonsAndHomingAreRead) {
  const auto says = falcon::decode(homed_packet());
  ASSERT_TRUE(says);
  EXPECT_EQ(says->counts, (std::array<int, 3>{1, -2, 0x1234}));
  EXPECT_EQ(says->buttons, 5u);
  EXPECT_TRUE(says->homed);
  for (const int legs : {0, 1, 3, 5, 6}) {
    FalconBytes packet = homed_packet();
    packet[13] = static_cast<std::uint8_t>('A' + 16 * legs);
    const auto some = falcon::decode(packet);
    ASSERT_TRUE(some);
    EXPECT_FALSE(some->homed) << "all legs or none: " << legs;
  }
  FalconBytes extreme = letters("<AAAIPPPHAAAAAA>");
  EXPECT_EQ(falcon::decode(extreme)->counts, (std::array<int, 3>{-32768, 32767, 0}));
}

TEST(FalconPackets, WhatIsNoPacketIsRefused) {
  for (std::size_t length = 0; length < 40; ++length) {
    FalconBytes packet = homed_packet();
    packet.resize(length, 'A');
    EXPECT_EQ(falcon::decode(packet).has_value(), length == 16) << length;
  }
  for (std::size_t at = 0; at < 16; ++at) {
    FalconBytes packet = homed_packet();
    packet[at] = 200;
    EXPECT_EQ(falcon::decode(packet).has_value(), at == 14) << "nothing is known of the spare byte: " << at;
    packet[at] = '@';
    EXPECT_EQ(falcon::decode(packet).has_value(), at == 14) << at;
  }
}

TEST(FalconPackets, MotorsAreWrittenLowNibbleFirstAndHeld) {
  const auto text = [](const falcon::Packet& packet) { return std::string(packet.begin(), packet.end()); };
  EXPECT_EQ(text(falcon::encode({0, 0, 0}, 0)), "<AAAAAAAAAAAAAA>");
  EXPECT_EQ(text(falcon::encode({0x123, -1, 4096}, falcon::kHoming | falcon::kRed)), "<DCBAPPPPAAABJA>");
  EXPECT_EQ(text(falcon::encode({100000, -100000, -4096}, 0)), "<AAABAAAPAAAPAA>");
}

TEST(FalconPackets, AStreamFindsPacketsInWhateverPieces) {
  FalconBytes line = letters("AB>C<AAA");  // what was begun before
  const FalconBytes one = letters("<BAAAAAAAAAAAAA>"), two = letters("<CAAAAAAAAAAAAA>");
  line.insert(line.end(), one.begin(), one.end());
  line.insert(line.end(), two.begin(), two.end());
  falcon::PacketStream whole;
  const auto newest = whole.feed(line);
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->counts[0], 2) << "the newest";
  for (std::size_t piece = 1; piece < 17; ++piece) {
    falcon::PacketStream stream;
    std::vector<int> seen;
    for (std::size_t at = 0; at < line.size(); at += piece)
      if (const auto says = stream.feed(std::span(line).subspan(at, std::min(piece, line.size() - at))))
        seen.push_back(says->counts[0]);
    EXPECT_EQ(seen.back(), 2) << piece;
    EXPECT_EQ(seen.size(), 2u) << piece;
  }
  falcon::PacketStream cleared;
  EXPECT_FALSE(cleared.feed(std::span(one).first(8)));
  cleared.clear();
  EXPECT_FALSE(cleared.feed(std::span(one).subspan(8)));
  EXPECT_TRUE(cleared.feed(two));
}

}  // namespace
}  // namespace fulcrum::test
