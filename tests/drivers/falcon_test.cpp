// A Falcon from when it is opened to its last packet, on a model of the device that knows nothing of the
// driver. No time passes on its cable: what it does not say at once, it does not say.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <thread>

#include "drivers/falcon/falcon_bus.h"
#include "drivers/falcon/falcon_firmware.h"
#include "drivers/force/force_device.h"
#include "haptics/math/split_mix.h"
#include "tests/device_models/falcon_model.h"

namespace fulcrum::test {
namespace {

using Model = FalconModel;
using falcon::FalconBoot;

Model::Bytes firmware_of(std::size_t length) {
  SplitMix random(length);
  Model::Bytes bytes(length);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.uniform() * 256);
  return bytes;
}

// The cable to it.
class ModelPort final : public usb::UsbPort {
public:
  explicit ModelPort(Model& model) : model_(model) {}
  bool control(std::uint8_t request, std::uint16_t value) override {
    return plugged && model_.control(0x40, request, value, 0);
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    if (!plugged || !takes || bytes.size() > 64) return false;
    model_.out(bytes);
    return true;
  }
  int read(std::span<std::uint8_t> packet, int) override {
    if (!plugged) return -1;
    Model::Bytes next;
    if (model_.has_more()) {
      held_.push_back(model_.in());
      if (held_.size() <= late) return 0;
    }
    if (held_.size() <= late) return 0;
    next = held_.front();
    held_.pop_front();
    std::ranges::copy(next, packet.begin());
    return static_cast<int>(next.size());
  }

  bool plugged = true, takes = true;
  std::size_t late = 0;  // answers that are held back

private:
  Model& model_;
  std::deque<Model::Bytes> held_;
};

FalconBoot::Firmware brings(const Model::Bytes& firmware) {
  return [firmware] { return Result<std::vector<std::uint8_t>>(firmware); };
}
Result<std::vector<std::uint8_t>> brings_none() {
  return Error{"there is no firmware."};
}

// Until it is done or has failed; a boot that goes on for ever is one that failed.
FalconBoot::State run(FalconBoot& boot, falcon::FalconLine& line) {
  for (int n = 0; n < 100000; ++n)
    if (boot.advance(line) != FalconBoot::State::going) break;
  return boot.state();
}

struct Booted {
  ModelPort port;
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

DeviceCommand pushing(const Vec3& force) {
  DeviceCommand command;
  command.F_H_D.force = force;
  return command;
}

// Its firmware runs; the bus has found that out.
struct OnFalcon {
  Model model{firmware_of(10), true};
  ModelPort* port;
  falcon::FalconBus bus;
  DeviceSample sample;

  OnFalcon() : OnFalcon(std::make_unique<ModelPort>(model)) {}
  ForceBus::Turn turn(const Vec3& force = Vec3::Zero()) { return bus.exchange(pushing(force), sample); }
  // At the beginning nothing is known of where the grip is; a turn later it is.
  void make_ready() {
    while (bus.starts()) turn();
    ASSERT_EQ(turn(), ForceBus::Turn::none);
    ASSERT_TRUE(model.home());
    ASSERT_EQ(turn(), ForceBus::Turn::fresh);
  }

private:
  explicit OnFalcon(std::unique_ptr<ModelPort> p)
      : port(p.get()), bus(std::move(p), [] { return brings_none(); }) {}
};

constexpr std::array<int, 3> kRest{};

TEST(Falcon, UntilItIsHomedItIsNotPushedWith) {
  OnFalcon falcon;
  while (falcon.bus.starts()) EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::none);
  for (int n = 0; n < 50; ++n) {
    EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::none);
    EXPECT_EQ(falcon.model.motors(), kRest);
    EXPECT_NE(falcon.model.lights() & falcon::kHoming, 0u);
  }
  EXPECT_NE(falcon.bus.trouble().find("pull the grip out"), std::string::npos) << falcon.bus.trouble();
  ASSERT_TRUE(falcon.model.home());
  EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::fresh);
  EXPECT_EQ(falcon.model.motors(), kRest) << "it was not known yet";
  EXPECT_EQ(falcon.turn({1, 2, 3}), ForceBus::Turn::fresh);
  EXPECT_NE(falcon.model.motors(), kRest);
  EXPECT_EQ(falcon.model.lights(), falcon::kGreen);
  EXPECT_EQ(falcon.bus.trouble(), "");
}

// The force that the model's motors make on its grip is the one that was asked for, and nothing turns it
// round.
TEST(Falcon, ThePlaceIsReadAndTheForceIsFelt) {
  OnFalcon falcon;
  falcon.make_ready();
  SplitMix random(3);
  for (int n = 0; n < 200; ++n) {
    const Vec3 place =
        0.07 * (Vec3(random.uniform(), random.uniform(), random.uniform()) - Vec3::Constant(0.5));
    const Vec3 force = 4 * (Vec3(random.uniform(), random.uniform(), random.uniform()) - Vec3::Constant(0.5));
    falcon.model.hold(place);
    falcon.model.press(n % 16u);
    falcon.turn();
    ASSERT_EQ(falcon.turn(force), ForceBus::Turn::fresh);
    EXPECT_LT((falcon.sample.X_DH.p - place).norm(), 6e-5) << "a count";
    EXPECT_EQ(falcon.sample.X_DH.q.coeffs(), Quat::Identity().coeffs());
    EXPECT_EQ(falcon.sample.buttons, n % 16u);
    EXPECT_LT((falcon.model.force_D() - force).norm(), 0.02) << force.transpose();
  }
}

TEST(Falcon, WhoDoesNotAnswerIsNotPushed) {
  OnFalcon falcon;
  falcon.make_ready();
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_GT(falcon.model.force_D().z(), 2.9);
  falcon.model.have(Model::Fault::silent);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  for (int n = 0; n < 5; ++n) {
    EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
    EXPECT_EQ(falcon.model.motors(), kRest);
  }
  falcon.model.have(Model::Fault::none);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_EQ(falcon.model.motors(), kRest);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_GT(falcon.model.force_D().z(), 2.9);
}

TEST(Falcon, GarbageIsNoAnswer) {
  for (const auto fault : {Model::Fault::garbles, Model::Fault::impossible}) {
    OnFalcon falcon;
    falcon.make_ready();
    const Vec3 before = falcon.sample.X_DH.p;
    falcon.model.have(fault);
    falcon.model.hold({0.03, 0, 0});
    EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
    for (int n = 0; n < 5; ++n) {
      EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
      EXPECT_EQ(falcon.model.motors(), kRest);
    }
    EXPECT_EQ(falcon.sample.X_DH.p, before);
    EXPECT_EQ(falcon.bus.trouble().find("none of its kind") != std::string::npos,
              fault == Model::Fault::impossible);
  }
}

// An answer that comes a turn late is thrown away, and the packet after it has no force.
TEST(Falcon, ALateAnswerIsNotTaken) {
  OnFalcon falcon;
  falcon.make_ready();
  falcon.port->late = 1;
  falcon.model.hold({0.02, 0, 0});
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  falcon.model.hold({0.03, 0, 0});
  falcon.port->late = 0;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  EXPECT_EQ(falcon.model.motors(), kRest);
  EXPECT_NEAR(falcon.sample.X_DH.p.x(), 0.03, 6e-5) << "the newest";
}

TEST(Falcon, OneThatLosesItsPlaceIsLetGo) {
  OnFalcon falcon;
  falcon.make_ready();
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  falcon.model.lose_home();
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  EXPECT_EQ(falcon.model.motors(), kRest);
  EXPECT_NE(falcon.bus.trouble().find("pull the grip out"), std::string::npos);
}

TEST(Falcon, WhatCannotBeToldIsNoTurnAndUnpluggedItIsLost) {
  OnFalcon falcon;
  falcon.make_ready();
  falcon.port->takes = false;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::none);
  falcon.port->takes = true;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::fresh);
  falcon.port->plugged = false;
  EXPECT_EQ(falcon.turn({0, 0, 3}), ForceBus::Turn::lost);
}

// From a cold start to rest by the device's own thread. It is homed while it is waited for.
TEST(Falcon, ADeviceIsStartedPushesAndRests) {
  const Model::Bytes firmware = firmware_of(20000);
  Model model(firmware);
  std::atomic<bool> ends{false};
  std::thread hand([&] {
    while (!ends && !model.home()) std::this_thread::yield();
  });
  auto bus = std::make_unique<falcon::FalconBus>(std::make_unique<ModelPort>(model), brings(firmware));
  auto device = ForceDevice::start(DeviceDesc{}, std::move(bus), [] { return nullptr; });
  ends = true;
  hand.join();
  ASSERT_TRUE(device) << device.error().sentence;
  model.hold({0, 0.02, 0});
  while ((*device)->read().X_DH.p.y() < 0.0199) std::this_thread::yield();
  while (model.force_D().y() < 1.9) (*device)->write(pushing({0, 2, 0}));
  while (model.motors() != kRest) std::this_thread::yield();  // nobody renews it
  while (model.force_D().y() < 1.9) (*device)->write(pushing({0, 2, 0}));
  device->reset();
  EXPECT_EQ(model.motors(), kRest);
}

TEST(Falcon, WhoWillNotStartIsRefusedWithItsReason) {
  Model model(firmware_of(10));
  auto bus = std::make_unique<falcon::FalconBus>(std::make_unique<ModelPort>(model), &brings_none);
  const auto refused = ForceDevice::start(DeviceDesc{}, std::move(bus), [] { return nullptr; });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence, "there is no firmware.");
}

class FalconFirmware : public testing::Test {
protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("falcon_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "fulcrum");
    unsetenv("FULCRUM_FALCON_FIRMWARE");
    setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("FULCRUM_FALCON_FIRMWARE");
    unsetenv("XDG_CONFIG_HOME");
    std::filesystem::remove_all(folder);
  }
  static void put(const std::filesystem::path& file, std::size_t length) {
    std::ofstream(file, std::ios::binary) << std::string(length, '\xfe');
  }
  std::filesystem::path folder;
};

TEST_F(FalconFirmware, OneThatIsMissingIsSaidWithWhereItComesFromAndGoes) {
  const auto none = falcon::find_firmware();
  ASSERT_FALSE(none);
  for (const std::string& part : {(folder / "fulcrum" / "falcon_firmware.bin").string(),
                                  std::string("FULCRUM_FALCON_FIRMWARE"), std::string("libnifalcon")})
    EXPECT_NE(none.error().sentence.find(part), std::string::npos) << none.error().sentence;
}

TEST_F(FalconFirmware, ItIsReadFromItsPlaceOrFromWhereItIsNamed) {
  put(folder / "fulcrum" / "falcon_firmware.bin", 100);
  const auto found = falcon::find_firmware();
  ASSERT_TRUE(found) << found.error().sentence;
  EXPECT_EQ(*found, std::vector<std::uint8_t>(100, 0xfe));
  put(folder / "other.bin", 50);
  setenv("FULCRUM_FALCON_FIRMWARE", (folder / "other.bin").c_str(), 1);
  EXPECT_EQ(falcon::find_firmware()->size(), 50u);
}

TEST_F(FalconFirmware, WhatIsNoneIsRefused) {
  const auto refusal = [](const std::filesystem::path& file) {
    setenv("FULCRUM_FALCON_FIRMWARE", file.c_str(), 1);
    const auto found = falcon::find_firmware();
    return found ? "" : found.error().sentence;
  };
  put(folder / "empty", 0);
  put(folder / "most", 256 * 1024);
  put(folder / "large", 256 * 1024 + 1);
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(refusal(folder / "empty").find("it is empty"), std::string::npos);
  EXPECT_EQ(refusal(folder / "most"), "");
  EXPECT_NE(refusal(folder / "large").find("larger than 256 KiB"), std::string::npos);
  EXPECT_NE(refusal(folder / "pipe").find("it is a pipe"), std::string::npos);
  EXPECT_NE(refusal(folder).find("it is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder / "nothing").find("No such file"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::test
