#pragma once
// A tool that is led down onto a floor and up again by a handle at a known speed.

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "tests/haptics/scenes.h"

namespace fulcrum::test {

inline constexpr double kSpeed = 0.1;  // m/s

// Where the handle is when the tool's origin is at `height` above the floor.
inline Pose handle(const SceneDesc& desc, double height) {
  return desc.mapping.handle_in_device({Quat::Identity(), Vec3(0, height, 0) - desc.tool.X_HT.p});
}

// Down to 1 mm below the floor and back up to 10 mm, at kSpeed, `times` over; after half a second of rest, in
// which the force ramps in.
inline std::vector<TickRecord> knock(const SceneDesc& desc, int times = 1, double height = 0.01) {
  World world = expect(World::build(desc));
  std::vector<TickRecord> records;
  for (int i = 0; i < 600; ++i) records.push_back(step(world, at(handle(desc, height)), {}).record);
  double y = height;
  for (int i = 0; i < times; ++i) {
    for (; y > -1e-3; y -= kSpeed * desc.tick_s)
      records.push_back(step(world, at(handle(desc, y)), {}).record);
    for (int k = 0; k < 200; ++k) records.push_back(step(world, at(handle(desc, y)), {}).record);
    for (; y < height; y += kSpeed * desc.tick_s)
      records.push_back(step(world, at(handle(desc, y)), {}).record);
  }
  return records;
}

// Ticks with an impact, each as often as there are impacts in it.
inline std::vector<std::size_t> struck(const std::vector<TickRecord>& records) {
  std::vector<std::size_t> ticks;
  for (std::size_t i = 0; i < records.size(); ++i)
    for (int k = 0; k < records[i].impact->count; ++k) ticks.push_back(i);
  return ticks;
}

// Every number of a tick that a scene has with its effects and without, bit for bit (-0 is not 0).
inline std::string bytes_of(const TickRecord& record) {
  std::vector<double> numbers;
  for (const Vec3* v :
       {&record.X_WH.p, &record.X_WT.p, &record.V_WT.v, &record.V_WT.w, &record.coupling_F_T_W.force,
        &record.coupling_F_T_W.torque, &record.contact_F_T_W.force, &record.contact_F_T_W.torque,
        &record.device_F_H_D.force, &record.device_F_H_D.torque, &record.shortfall_F_H_D.force,
        &record.shortfall_F_H_D.torque})
    numbers.insert(numbers.end(), v->begin(), v->end());
  numbers.insert(numbers.end(), record.actuator_load.begin(), record.actuator_load.end());
  numbers.push_back(record.energy_port);
  numbers.push_back(record.depth_max);
  numbers.push_back(record.faults);
  std::string bytes(numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

// Of a test for each response.
inline std::string test_name_of(const testing::TestParamInfo<ContactResponse>& given) {
  constexpr const char* names[] = {"Penalty", "Voxel", "Static", "Constraint", "Direct"};
  return names[static_cast<int>(given.param)];
}

}  // namespace fulcrum::test
