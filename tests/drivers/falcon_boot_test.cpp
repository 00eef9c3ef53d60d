// How a Falcon is started, on a model of the device that knows nothing of the driver.

#include "drivers/falcon/falcon_boot.h"

#include <gtest/gtest.h>

#include "tests/drivers/falcon_cable.h"

namespace fulcrum::test {
namespace {

using Model = FalconModel;
using falcon::FalconBoot;

// Until it is done or has failed; a boot that goes on for ever is one that failed.
FalconBoot::State run(FalconBoot& boot, falcon::FalconLine& line) {
  for (int n = 0; n < 100000; ++n)
    if (boot.advance(line) != FalconBoot::State::going) break;
  return boot.state();
}

struct Booted {
  FalconCable port;
  falcon::FalconLine line;
  FalconBoot boot;
  Booted(Model& model, FalconBoot::Firmware firmware) : port(model), line(port), boot(std::move(firmware)) {}
  FalconBoot::State run() { return test::run(boot, line); }
};

TEST(FalconBoot, FirmwareThatRunsIsLeftAlone) {
  Model model(firmware_of(100), true);
  Booted booted(model, [] {
    ADD_FAILURE() << "it is not asked for";
    return brings_none();
  });
  EXPECT_EQ(booted.run(), FalconBoot::State::done) << booted.boot.why();
  EXPECT_TRUE(model.runs());
  EXPECT_EQ(model.motors(), (std::array<int, 3>{}));
}

TEST(FalconBoot, OneThatWasSwitchedOnTakesItsFirmware) {
  for (const std::size_t length : {1u, 61u, 62u, 63u, 124u, 30000u})
    for (const auto fault : {Model::Fault::none, Model::Fault::zero_at_first, Model::Fault::one_by_one}) {
      const Model::Bytes firmware = firmware_of(length);
      Model model(firmware);
      model.have(fault);
      Booted booted(model, brings(firmware));
      EXPECT_EQ(booted.run(), FalconBoot::State::done) << length << booted.boot.why();
      EXPECT_TRUE(model.runs()) << length;
      EXPECT_GT(model.packets(), 0);
      EXPECT_LE(model.most_unread(), 62u) << "a chunk goes out once the one before has come back";
    }
}

TEST(FalconBoot, WhatGoesWrongIsSaid) {
  const Model::Bytes firmware = firmware_of(300);
  const auto why = [&](Model::Fault fault, const FalconBoot::Firmware& brought) {
    Model model(firmware);
    model.have(fault);
    Booted booted(model, brought);
    EXPECT_EQ(booted.run(), FalconBoot::State::failed);
    EXPECT_FALSE(model.runs());
    return booted.boot.why();
  };
  EXPECT_EQ(why(Model::Fault::none, &brings_none), "there is no firmware.");
  EXPECT_NE(why(Model::Fault::silent, brings(firmware)).find("boot loader does not answer"),
            std::string::npos);
  EXPECT_NE(why(Model::Fault::never_greets, brings(firmware)).find("its own power"), std::string::npos);
  EXPECT_NE(why(Model::Fault::none, brings(firmware_of(200))).find("does not answer: the file"),
            std::string::npos)
      << "another one's firmware";
}

// At each moment of the upload.
TEST(FalconBoot, AnEchoThatIsWrongOrStaysAwayEndsIt) {
  const Model::Bytes firmware = firmware_of(300);
  for (const auto& [fault, says] :
       {std::pair{Model::Fault::garbles, "did not come back"}, {Model::Fault::silent, "fell silent"}})
    for (int chunk = 0; chunk < 4; ++chunk) {
      Model model(firmware);
      Booted booted(model, brings(firmware));
      // A turn for the line, 25 for firmware that might run, two to greet and sign, and one for each chunk.
      for (int turn = 0; turn < 28 + chunk; ++turn) booted.boot.advance(booted.line);
      ASSERT_EQ(booted.boot.state(), FalconBoot::State::going);
      model.have(fault);
      EXPECT_EQ(booted.run(), FalconBoot::State::failed);
      EXPECT_NE(booted.boot.why().find(says), std::string::npos) << chunk << ": " << booted.boot.why();
    }
}

TEST(FalconBoot, UnpluggedItFails) {
  const Model::Bytes firmware = firmware_of(300);
  for (int turns = 0; turns < 34; ++turns) {
    Model model(firmware);
    Booted booted(model, brings(firmware));
    for (int n = 0; n < turns; ++n) booted.boot.advance(booted.line);
    if (booted.boot.state() != FalconBoot::State::going) break;
    booted.port.plugged = false;
    EXPECT_EQ(booted.run(), FalconBoot::State::failed);
    EXPECT_NE(booted.boot.why().find("plug it in again"), std::string::npos) << booted.boot.why();
  }
}

}  // namespace
}  // namespace fulcrum::test
