// The thread that feeds a card. Whatever is waited for is waited for until it is seen: no clock decides.

#include "drivers/sound/sound_link.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/sound/usb_card.h"
#include "tests/drivers/sound_card.h"

namespace fulcrum::test {
namespace {

using sound::SoundLink;

VibrotactileDesc two_coils() {
  const ChannelDesc left{.name = "left", .largest = 10, .resonance_Hz = 233, .quality = 3};
  ChannelDesc right = left;
  right.name = "right";
  return {{left, right}};
}

std::unique_ptr<sound::Pcm> open_card(SoundCard& card) {
  const std::lock_guard lock(card.mutex);
  if (!card.plugged) return nullptr;
  return std::make_unique<SoundCardPcm>(card);
}

std::unique_ptr<SoundLink> linked(SoundCard& card) {
  return std::make_unique<SoundLink>(
      open_card(card), [&card] { return open_card(card); }, two_coils(), VibrotactileSignal{.largest = 10},
      1e-3);
}

VibrotactileCommand tone() {
  VibrotactileCommand command;
  command.level = {5, 5};
  command.glide = 1e-3;
  return command;
}

// Ticks and the card's clock go on, a millisecond at a time, until it is seen.
void play_until(SoundLink& link, SoundCard& card, auto seen) {
  while (!seen()) {
    link.drive(tone());
    card.pass(48);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

bool sounds(const sound::Frame& frame) {
  return frame[0] != 0 && frame[1] != 0;
}

TEST(SoundLink, WhatIsToldIsPlayedAndTheEndIsSilence) {
  SoundCard card;
  auto link = linked(card);
  EXPECT_TRUE(link->connected());
  play_until(*link, card, [&] {
    const auto written = card.all_written();
    return std::ranges::count_if(written, sounds) > 4800;
  });
  EXPECT_GT(link->counts().ticks, 0);
  EXPECT_GT(link->counts().latency_most, 0);
  link.reset();
  EXPECT_EQ(card.closed, 1);
  EXPECT_FALSE(sounds(card.written.back()));
}

TEST(SoundLink, UnpluggedItSaysSoAndPluggedInAgainItPlays) {
  SoundCard card;
  const auto link = linked(card);
  for (int time = 1; time <= 2; ++time) {
    play_until(*link, card, [&] { return !card.all_written().empty() && sounds(card.all_written().back()); });
    card.plug(false);
    play_until(*link, card, [&] { return !link->connected(); });
    card.plug(true);
    {
      const std::lock_guard lock(card.mutex);
      card.written.clear();
    }
    play_until(*link, card, [&] { return link->connected(); });
    EXPECT_EQ(card.opened, time + 1);
  }
}

TEST(SoundLink, ACardThatStandsStillIsLostAndHoldsNobodyUp) {
  SoundCard card;
  auto link = linked(card);
  play_until(*link, card, [&] { return link->counts().ticks > 10; });
  {
    const std::lock_guard lock(card.mutex);
    card.runs = false;
  }
  play_until(*link, card, [&] { return !link->connected(); });
  {
    const std::lock_guard lock(card.mutex);
    card.plugged = false;
  }
  link.reset();
}

// Nobody takes what a thread that is held up leaves: the haptic thread goes on, and what had no place counts.
TEST(SoundLink, ARingThatIsFullIsCounted) {
  SoundCard card;
  const auto link = linked(card);
  int told = 0;
  while (link->counts().left_out == 0) {
    link->drive(tone());
    ++told;
  }
  EXPECT_GT(told, 16);
}

TEST(UsbCard, IsFoundByItsNumbers) {
  std::string name = (std::filesystem::temp_directory_path() / "fulcrum_asound_XXXXXX").string();
  const std::filesystem::path asound = mkdtemp(name.data());
  EXPECT_FALSE(sound::find_usb_card(asound, dualsense::usb_ids())) << "a machine without sound";
  const auto add = [&](const char* card, const char* numbers) {
    std::filesystem::create_directories(asound / card);
    std::ofstream(asound / card / "usbid") << numbers << "\n";
  };
  std::filesystem::create_directories(asound / "card0");
  add("card1", "not numbers");
  add("card2", "1234:5678");
  EXPECT_FALSE(sound::find_usb_card(asound, dualsense::usb_ids()));
  add("card11", "054c:0ce6");
  EXPECT_EQ(sound::find_usb_card(asound, dualsense::usb_ids()), 11);
  std::filesystem::remove_all(asound);
}

}  // namespace
}  // namespace fulcrum::test
