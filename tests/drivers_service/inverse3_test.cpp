// An Inverse3 behind its maker's service, by the real websocket, against a stand-in that the test holds.
// Whatever is waited for is waited for until it is seen; that something does not come is never concluded from
// time.

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "drivers/force/force_device.h"
#include "drivers/inverse3/inverse3_bus.h"
#include "drivers/inverse3/local_websocket.h"
#include "drivers/watch/device_watch.h"
#include "haptics/math/rotation.h"
#include "tests/drivers_service/raw_listener.h"
#include "tests/drivers_service/stand_in_service.h"

namespace fulcrum::test {
namespace {

using inverse3::Inverse3Bus;
using inverse3::LocalWebSocket;
using stand_in::RawListener;
using stand_in::Service;

constexpr std::chrono::seconds kLongEnough{10};  // for what comes in microseconds

Result<std::unique_ptr<Inverse3Bus>> open_first(int port) {
  Inverse3Bus::Own own;
  return Inverse3Bus::open(own, port);
}

std::unique_ptr<ForceDevice> started_on(int port) {
  Inverse3Bus::Own own;
  auto bus = Inverse3Bus::open(own, port);
  EXPECT_TRUE(bus) << (bus ? "" : bus.error().sentence);
  if (!bus) return nullptr;
  auto device =
      ForceDevice::start(DeviceDesc{}, std::move(*bus), [port, own]() mutable -> std::unique_ptr<ForceBus> {
        auto again = Inverse3Bus::open(own, port);
        return again ? std::move(*again) : nullptr;
      });
  EXPECT_TRUE(device) << (device ? "" : device.error().sentence);
  return device ? std::move(*device) : nullptr;
}

void until(auto seen) {
  while (!seen()) std::this_thread::yield();
}

DeviceCommand push_of(const Vec3& force) {
  DeviceCommand command;
  command.F_H_D.force = force;
  return command;
}

// In the service's frame.
Vec3 force_on(Service& service) {
  return service.see([](const Service::State& s) { return Vec3(s.force[0], s.force[1], s.force[2]); });
}

// Writes until the service has that force.
void push_until_felt(ForceDevice& device, Service& service, const Vec3& force_D, const Vec3& force_S) {
  until([&] {
    device.write(push_of(force_D));
    return force_on(service) == force_S;
  });
}

std::string why_not(Service& service) {
  return inverse3::why_no_inverse3(service.port());
}

TEST(Inverse3, WithoutItsServiceThatIsSaidWithItsRemedy) {
  int nobody = 0;
  {
    const Service gone;
    nobody = gone.port();
  }
  const std::string reason = inverse3::why_no_inverse3(nobody);
  EXPECT_NE(reason.find("nobody listens"), std::string::npos) << reason;
  EXPECT_NE(reason.find("start Haply Hub"), std::string::npos) << reason;
  EXPECT_FALSE(open_first(nobody));
}

// Such as listens, and never answers.
TEST(Inverse3, WhatListensAtEitherAddressOfThisMachineIsFound) {
  const int listener = socket(AF_INET6, SOCK_STREAM, 0);
  sockaddr_in6 address{};
  address.sin6_family = AF_INET6;
  address.sin6_addr = in6addr_loopback;
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  if (bind(listener, any, size) != 0 || listen(listener, 8) != 0)
    GTEST_SKIP() << "there is no address ::1 here";
  ASSERT_EQ(getsockname(listener, any, &size), 0);
  const std::string reason = inverse3::why_no_inverse3(ntohs(address.sin6_port));
  EXPECT_NE(reason.find("does not answer"), std::string::npos) << reason;
  close(listener);
}

TEST(Inverse3, WhatTheServiceLacksIsSaid) {
  Service service;
  until([&] { return why_not(service).empty(); });
  const auto refused_with = [&service](const char* words) {
    until([&] { return why_not(service).find(words) != std::string::npos; });
    EXPECT_FALSE(open_first(service.port())) << words;
  };
  service.set([](Service::State& s) { s.arm = false; });
  refused_with("plug one in");
  service.set([](Service::State& s) {
    s.arm = true;
    s.kind = "minverse";
  });
  refused_with("minverse");
  service.set([](Service::State& s) {
    s.kind = "inverse3x";
    s.basis = "XZY";
  });
  refused_with("XYZ");
  service.set([](Service::State& s) {
    s.basis = "XYZ";
    s.scale = 2;
  });
  refused_with("scale");
  service.set([](Service::State& s) {
    s.scale = 1;
    s.greets = "<html>what else listens there</html>";
  });
  refused_with("not understood");
}

// The environment's proxy is for what is elsewhere: this one would lead nowhere.
TEST(Inverse3, NoProxyIsAsked) {
  setenv("http_proxy", "127.0.0.1:1", 1);
  Service service;
  const auto bus = open_first(service.port());
  unsetenv("http_proxy");
  EXPECT_TRUE(bus) << (bus ? "" : bus.error().sentence);
}

TEST(Inverse3, ItsPoseIsReadInOurFrameAndItsForceGivenInTheServices) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  // Right, up and toward the person by 1, 2 and 3 cm from the middle; turned by 0.6 rad about the line up.
  service.set([](Service::State& s) {
    s.p[0] = 0.01;
    s.p[1] = -0.12 - 0.03;
    s.p[2] = 0.15 + 0.02;
    s.q[0] = std::cos(0.3);
    s.q[3] = std::sin(0.3);
    s.button = true;
  });
  const Pose expected{quaternion_exp(Vec3(0, 0.6, 0)), Vec3(0.01, 0.02, 0.03)};
  until([&] {
    const DeviceSample sample = device->read();
    return (sample.X_DH.p - expected.p).norm() < 1e-12 && sample.X_DH.q.angularDistance(expected.q) < 1e-9 &&
           sample.buttons == 1;
  });
  // Right 1 N, up 2 N, toward the person 3 N.
  push_until_felt(*device, service, {1, 2, 3}, {1, -3, 2});
  until([&] { return force_on(service) == Vec3(0, 0, 0); });  // nobody renews it
  EXPECT_EQ(service.see([](const Service::State& s) { return s.misunderstood; }), 0);
}

TEST(Inverse3, AnOlderServiceIsToldForcesInItsWords) {
  Service service;
  service.set([](Service::State& s) { s.old = true; });
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  push_until_felt(*device, service, {1, 0, 0}, {1, 0, 0});
  EXPECT_EQ(service.see([](const Service::State& s) { return s.misunderstood; }), 0);
}

TEST(Inverse3, WithoutAVerseGripItDoesNotTurn) {
  Service service;
  service.set([](Service::State& s) { s.handle = false; });
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  EXPECT_TRUE(device->read().X_DH.q.isApprox(Quat::Identity()));
  EXPECT_EQ(device->read().buttons, 0u);
}

// The tool would turn back at once if it were taken for unturned.
TEST(Inverse3, AVerseGripThatGoesAwayStopsThePoseAndDoesNotUnturnIt) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  const Quat turned = quaternion_exp(Vec3(0, 0.6, 0));
  service.set([](Service::State& s) {
    s.q[0] = std::cos(0.3);
    s.q[3] = std::sin(0.3);
  });
  until([&] { return device->read().X_DH.q.angularDistance(turned) < 1e-9; });
  service.set([](Service::State& s) { s.handle = false; });
  until([&] { return device->read().age > 0.02; });
  EXPECT_LT(device->read().X_DH.q.angularDistance(turned), 1e-9);
  service.set([](Service::State& s) { s.handle = true; });
  until([&] { return device->read().age < 0.02; });
}

TEST(Inverse3, AtTheEndItsMotorsRestAndTheConnectionIsClosed) {
  Service service;
  auto device = started_on(service.port());
  ASSERT_TRUE(device);
  std::atomic<bool> renews{true};
  std::thread hand([&] {
    while (renews) device->write(push_of({0, 4, 0}));
  });
  until([&] { return force_on(service) == Vec3(0, 0, 4); });
  renews = false;
  hand.join();
  const auto forces = [&] { return service.see([](const Service::State& s) { return s.forces; }); };
  const std::uint64_t before = forces();
  device.reset();
  until([&] { return service.see([](const Service::State& s) { return s.sessions; }) == 0; });
  EXPECT_EQ(force_on(service), Vec3(0, 0, 0));
  EXPECT_GE(forces(), before + 5) << "it was told to rest, and not merely left";
}

TEST(Inverse3, AServiceThatFallsSilentMakesTheSampleOld) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  service.set([](Service::State& s) { s.answers = 0; });
  until([&] { return device->read().age > 0.02; });
  until([&] { return !device->read().connected; });  // then it is given up
  service.set([](Service::State& s) { s.answers = -1; });
  until([&] { return device->read().connected && device->read().age < 0.02; });
}

TEST(Inverse3, ConnectionsThatDropInContactAreMadeAgain) {
  auto service = std::make_unique<Service>();
  const int port = service->port();
  const auto device = started_on(port);
  ASSERT_TRUE(device);
  push_until_felt(*device, *service, {0, 0, 2}, {0, -2, 0});
  service.reset();
  until([&] { return !device->read().connected; });
  service = std::make_unique<Service>(port);
  service->set([](Service::State& s) { s.p[0] = 0.05; });
  until([&] { return device->read().connected && device->read().X_DH.p.x() == 0.05; });
  // What was told before is not what is told now.
  until([&] { return service->see([](const Service::State& s) { return s.forces; }) > 3; });
  EXPECT_EQ(force_on(*service), Vec3(0, 0, 0));
}

TEST(Inverse3, UnpluggedFromItsServiceItIsLostAndComesBack) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  service.set([](Service::State& s) { s.arm = false; });
  until([&] { return !device->read().connected; });
  service.set([](Service::State& s) { s.arm = true; });
  until([&] { return device->read().connected; });
}

// Whichever comes first in the list: the run goes on with the one that it began with.
TEST(Inverse3, AnotherOneIsNotTakenForIt) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  service.set([](Service::State& s) { s.another_before = true; });
  const std::uint64_t turns = device->turns();
  until([&] { return device->turns() > turns + 10; });
  EXPECT_LT(device->read().X_DH.p.norm(), 1e-12);
  push_until_felt(*device, service, {0, 1, 0}, {0, 0, 1});
  EXPECT_EQ(service.see([](const Service::State& s) { return s.misunderstood; }), 0) << "no other was pushed";
}

// Nor is it taken while the run's own is unplugged. Each look for that is a connection.
TEST(Inverse3, AnotherOneIsNotTakenInItsPlace) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  service.set([](Service::State& s) {
    s.another_before = true;
    s.arm = false;
    s.opened = 0;
  });
  until([&] { return !device->read().connected; });
  until([&] {
    return device->read().connected || service.see([](const Service::State& s) { return s.opened; }) > 2;
  });
  EXPECT_FALSE(device->read().connected);
  service.set([](Service::State& s) { s.arm = true; });
  until([&] { return device->read().connected; });
  EXPECT_LT(device->read().X_DH.p.norm(), 1e-12);
}

// A connection that is made anew while the handle is asleep: the tool does not turn back meanwhile.
TEST(Inverse3, AVerseGripThatComesLaterThanTheConnectionKeepsItsTurn) {
  auto service = std::make_unique<Service>();
  const int port = service->port();
  const auto turn = [](Service::State& s) {
    s.q[0] = std::cos(0.3);
    s.q[3] = std::sin(0.3);
  };
  service->set(turn);
  const auto device = started_on(port);
  ASSERT_TRUE(device);
  const Quat turned = quaternion_exp(Vec3(0, 0.6, 0));
  until([&] { return device->read().X_DH.q.angularDistance(turned) < 1e-9; });
  service.reset();
  until([&] { return !device->read().connected; });
  service = std::make_unique<Service>(port);
  service->set([&](Service::State& s) {
    turn(s);
    s.handle = false;
  });
  until([&] {
    return device->read().connected || service->see([](const Service::State& s) { return s.forces; }) > 10;
  });
  EXPECT_FALSE(device->read().connected);
  EXPECT_LT(device->read().X_DH.q.angularDistance(turned), 1e-9);
  service->set([](Service::State& s) { s.handle = true; });
  until([&] { return device->read().connected; });
  EXPECT_LT(device->read().X_DH.q.angularDistance(turned), 1e-9);
}

// The run has begun without one: a handle that the service has later is none of its own.
TEST(Inverse3, AVerseGripThatComesLaterThanTheRunTurnsNothing) {
  auto service = std::make_unique<Service>();
  const int port = service->port();
  service->set([](Service::State& s) { s.handle = false; });
  const auto device = started_on(port);
  ASSERT_TRUE(device);
  service.reset();
  until([&] { return !device->read().connected; });
  service = std::make_unique<Service>(port);
  service->set([](Service::State& s) {
    s.q[0] = std::cos(0.3);
    s.q[3] = std::sin(0.3);
    s.p[0] = 0.05;
  });
  until([&] { return device->read().connected && device->read().X_DH.p.x() == 0.05; });
  EXPECT_TRUE(device->read().X_DH.q.isApprox(Quat::Identity()));
}

// Wherever an answer was held up: the pose is as old as the question may be.
TEST(Inverse3, AnAnswerThatComesLateIsAsOldAsItIs) {
  Service service;
  const auto bus = open_first(service.port());
  ASSERT_TRUE(bus) << bus.error().sentence;
  DeviceSample sample;
  service.set([](Service::State& s) { s.answers = 0; });
  EXPECT_EQ((*bus)->exchange({}, sample), ForceBus::Turn::none);
  const auto asked = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  const std::chrono::duration<double> late = std::chrono::steady_clock::now() - asked;
  service.set([](Service::State& s) { s.answers = 1; });
  ForceBus::Turn turn = ForceBus::Turn::none;
  while (turn == ForceBus::Turn::none) turn = (*bus)->exchange({}, sample);
  ASSERT_EQ(turn, ForceBus::Turn::fresh);
  EXPECT_GE(sample.age, late.count());
}

// The messages that are answered are counted off against those that were sent: an answer that never comes
// would make every later pose look older than it is.
TEST(Inverse3, WhereAnswersAreLostTheConnectionIsMadeAnew) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  const auto opened = [&] { return service.see([](const Service::State& s) { return s.opened; }); };
  EXPECT_EQ(opened(), 1);
  service.set([](Service::State& s) { s.swallowed = 60; });
  until([&] { return opened() > 1; });
  until([&] { return device->read().connected && device->read().age < 0.02; });
}

// What is asked stays with who listens here.
TEST(Inverse3, WhoIsSentElsewhereDoesNotGoThere) {
  const int elsewhere = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  ASSERT_EQ(bind(elsewhere, any, size), 0);
  ASSERT_EQ(listen(elsewhere, 8), 0);
  ASSERT_EQ(getsockname(elsewhere, any, &size), 0);
  const std::string place = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/";
  std::atomic<int> asked{0};
  RawListener listener([&](const std::string&) {
    ++asked;
    return "HTTP/1.1 302 Found\r\nLocation: " + place + "\r\nContent-Length: 0\r\n\r\n";
  });
  EXPECT_FALSE(LocalWebSocket::connect(listener.port(), inverse3::kMostBytes, kLongEnough));
  EXPECT_EQ(asked, 1);
  EXPECT_LT(accept(elsewhere, nullptr, nullptr), 0) << "somebody came to where he was sent";
  close(elsewhere);
}

TEST(Inverse3, WhoSaysMoreThanWasAskedForIsLeft) {
  RawListener listener(&stand_in::agreement_to);
  auto link = LocalWebSocket::connect(listener.port(), inverse3::kMostBytes, kLongEnough);
  ASSERT_TRUE(link) << link.error().sentence;
  std::string flood;
  for (int n = 0; n < 300; ++n) flood += "\x81\x02{}";  // each a message of two bytes
  ASSERT_TRUE(listener.say(flood));
  std::string message;
  int count = 0;
  LocalWebSocket::Heard heard;
  while ((heard = (*link)->hear(message, kLongEnough)) == LocalWebSocket::Heard::message) ++count;
  EXPECT_EQ(heard, LocalWebSocket::Heard::gone);
  EXPECT_EQ(count, 128);
}

// As `fulcrum devices --watch` asks it, which no change of the kernel's would have ask.
TEST(Inverse3, ItsServiceIsSeenToComeAndToGo) {
  auto service = std::make_unique<Service>();
  const int port = service->port();
  service.reset();
  const auto listed = [port] {
    DeviceListing listing{.name = "inverse3", .what = "an arm", .reason = inverse3::why_no_inverse3(port)};
    listing.present = listing.reason.empty();
    return std::vector<DeviceListing>{listing};
  };
  DeviceWatch watch(listed, listed);
  EXPECT_FALSE(watch.devices()[0].present);
  EXPECT_TRUE(watch.ask_services().empty());
  EXPECT_TRUE(watch.ask_services().empty()) << "nothing has changed";
  service = std::make_unique<Service>(port);
  EXPECT_TRUE(watch.ask_services().empty()) << "it has said so once";
  const auto told = [&](bool present) {
    const std::vector<DeviceListing> changed = watch.ask_services();
    return !changed.empty() && changed[0].present == present;
  };
  until([&] { return told(true); });
  EXPECT_TRUE(watch.devices()[0].present);
  service.reset();
  until([&] { return told(false); });
}

TEST(Inverse3, WhatIsNonsenseIsNoSample) {
  Service service;
  const auto device = started_on(service.port());
  ASSERT_TRUE(device);
  const std::string deep(40000, '[');
  const std::string huge(300000, ' ');
  const std::string far =
      R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":9,"y":0,"z":0}}}]})";
  for (const std::string& babble : {std::string("{\"inverse3\":"), deep, huge, far}) {
    service.set([&](Service::State& s) { s.babble = babble; });
    until([&] { return device->read().age > 0.05; });
    EXPECT_LT(device->read().X_DH.p.norm(), 1e-12);
    EXPECT_TRUE(device->read().connected);
    service.set([](Service::State& s) { s.babble.clear(); });
    until([&] { return device->read().age < 0.02; });
  }
}

TEST(Inverse3, WhatIsNotReadyIsRefusedWithWhatWouldCureIt) {
  Service service;
  const auto refusal = [&](auto change) {
    service.set(change);
    auto bus = open_first(service.port());
    EXPECT_TRUE(bus) << (bus ? "" : bus.error().sentence);
    if (!bus) return std::string();
    const auto refused = ForceDevice::start(
        DeviceDesc{}, std::move(*bus), [] { return nullptr; });
    return refused ? std::string() : refused.error().sentence;
  };
  EXPECT_NE(refusal([](Service::State& s) { s.calibrated = false; }).find("inkwell"), std::string::npos);
  EXPECT_NE(refusal([](Service::State& s) { s.powered = false; }).find("power supply"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::test
