// Devices whose makers' libraries are loaded while running, against libraries that are built here and do what
// the manuals say. Whatever is waited for is waited for until it is seen.

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "drivers/registry.h"
#include "haptics/math/rotation.h"
#include "tests/drivers_vendor/stand_in.h"

namespace fulcrum::test {
namespace {

struct Maker {
  const char* device;  // as --device takes it
  const char* library;
  double unit;  // m
  // Right, up and toward the person in the library's frame.
  int axis[3];
};
constexpr Maker kMakers[] = {{"omega6", "libdhd.so", 1, {1, 2, 0}}, {"touch", "libHD.so", 1e-3, {0, 1, 2}}};

std::ostream& operator<<(std::ostream& out, const Maker& maker) {
  return out << maker.device;
}

class Vendor : public testing::TestWithParam<Maker> {
protected:
  void SetUp() override {
    void* const library = dlopen(GetParam().library, RTLD_NOW);
    ASSERT_NE(library, nullptr) << dlerror();
    const auto find = reinterpret_cast<stand_in::Handle* (*)()>(dlsym(library, "stand_in_handle"));
    ASSERT_NE(find, nullptr) << "this is not the stand-in";
    held = find();
    set([](stand_in::Handle& h) {
      h.there = h.calibrated = true;
      h.buttons = 0;
      for (int i = 0; i < 3; ++i) {
        h.p[i] = 0;
        for (int j = 0; j < 3; ++j) h.turn[i][j] = i == j ? 1 : 0;
      }
    });
  }
  void set(auto change) {
    const std::lock_guard lock(held->mutex);
    change(*held);
  }
  template <class See>
  auto see(See what) {
    const std::lock_guard lock(held->mutex);
    return what(*held);
  }
  Vec3 force() {
    return see([](const stand_in::Handle& h) {
      const int* axis = GetParam().axis;
      return Vec3(h.force[axis[0]], h.force[axis[1]], h.force[axis[2]]);
    });
  }
  static Result<OpenDevice> open() {
    return open_device(GetParam().device, {.desc = DeviceDesc{}, .X_DH = Pose{}});
  }

  stand_in::Handle* held = nullptr;
};

void wait_for(auto seen) {
  while (!seen()) std::this_thread::yield();
}

bool is_near(const Pose& a, const Pose& b) {
  return (a.p - b.p).norm() < 1e-12 && rotation_vector(a.q * b.q.conjugate()).norm() < 1e-9;
}

TEST_P(Vendor, IsListedAsThereOrSaysWhyNot) {
  const auto listed = [] {
    for (const DeviceListing& device : list_devices(""))
      if (device.name == GetParam().device) return device;
    return DeviceListing{};
  };
  EXPECT_TRUE(listed().present) << listed().reason;
  set([](stand_in::Handle& h) { h.there = false; });
  EXPECT_FALSE(listed().present);
  EXPECT_NE(listed().reason.find("plug one in"), std::string::npos) << listed().reason;
  EXPECT_FALSE(open());
}

TEST_P(Vendor, ItsPoseIsReadInOurFrameAndItsForceGivenInTheirs) {
  const auto opened = open();
  ASSERT_TRUE(opened) << opened.error().sentence;
  Device& device = *opened->device;
  const Maker& maker = GetParam();
  const Pose X_DH{quaternion_exp(Vec3(0.3, -0.5, 0.7)), Vec3(0.01, -0.02, 0.03)};
  const Mat3 R = X_DH.q.toRotationMatrix();
  set([&](stand_in::Handle& h) {
    h.buttons = 2;
    for (int i = 0; i < 3; ++i) {
      h.p[maker.axis[i]] = X_DH.p[i] / maker.unit;
      for (int j = 0; j < 3; ++j) h.turn[maker.axis[i]][maker.axis[j]] = R(i, j);
    }
  });
  wait_for([&] { return is_near(device.read().X_DH, X_DH); });
  EXPECT_EQ(device.read().buttons, 2u);
  EXPECT_TRUE(device.read().connected);

  DeviceCommand command;
  command.F_H_D.force = Vec3(1, -2, 0.5);
  wait_for([&] {
    device.write(command);
    return force() == Vec3(1, -2, 0.5);
  });
  wait_for([&] { return force() == Vec3(0, 0, 0); });  // nobody renews it
}

TEST_P(Vendor, UnpluggedInContactItIsLostAndComesBack) {
  const auto opened = open();
  ASSERT_TRUE(opened) << opened.error().sentence;
  Device& device = *opened->device;
  set([](stand_in::Handle& h) { h.there = false; });
  wait_for([&] { return !device.read().connected; });
  set([](stand_in::Handle& h) { h.there = true; });
  wait_for([&] { return device.read().connected; });
}

TEST_P(Vendor, AtTheEndItsMotorsAreOffAndItIsClosed) {
  const auto count = [](const stand_in::Handle& h) { return h.opened - h.closed; };
  const int open_before = see(count);
  {
    const auto opened = open();
    ASSERT_TRUE(opened) << opened.error().sentence;
    DeviceCommand command;
    command.F_H_D.force = Vec3(0, 3, 0);
    wait_for([&] {
      opened->device->write(command);
      return force().y() == 3;
    });
  }
  EXPECT_EQ(force(), Vec3(0, 0, 0));
  EXPECT_FALSE(see([](const stand_in::Handle& h) { return h.powered; }));
  EXPECT_EQ(see(count), open_before);
}

TEST_P(Vendor, WithoutCalibrationItIsRefusedWithWhatWouldCureIt) {
  set([](stand_in::Handle& h) { h.calibrated = false; });
  const auto refused = open();
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("not calibrated"), std::string::npos) << refused.error().sentence;
}

INSTANTIATE_TEST_SUITE_P(Each, Vendor, testing::ValuesIn(kMakers),
                         [](const auto& each) { return std::string(each.param.device); });

}  // namespace
}  // namespace fulcrum::test
