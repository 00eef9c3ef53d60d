#pragma once
// Runs that never took place, the same for the same seed, and a folder to write them into.

#include <stdlib.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <string_view>

#include "engine/record/tape.h"
#include "haptics/device/device.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::record {

class TemporaryFolder {
public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "fulcrum-record-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

inline void write(const std::filesystem::path& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

class SyntheticRun {
public:
  explicit SyntheticRun(std::uint64_t seed) : random_(seed) {}

  double number() { return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random_())), -62); }
  Vec3 vector() { return {number(), number(), number()}; }
  Pose pose() { return {Quat(number(), number(), number(), number()).normalized(), vector()}; }
  Wrench wrench() { return {vector(), vector()}; }

  DeviceSample sample() {
    return {.X_DH = pose(),
            .age = number() * number(),
            .buttons = static_cast<std::uint32_t>(random_() % 4),
            .connected = random_() % 50 != 0,
            .strip_ohm = random_() % 3 == 0 ? kStripOpen : 1e3 * number()};
  }

  TickRecord record(std::int64_t tick) {
    TickRecord record;
    record.tick = tick;
    record.X_WH = pose();
    record.X_WT = pose();
    record.V_WT = {vector(), vector()};
    record.coupling_F_T_W = wrench();
    record.contact_F_T_W = wrench();
    record.regions = static_cast<std::int32_t>(random_() % 5);
    record.depth_max = number() * 1e-4;
    record.device_F_H_D = wrench();
    for (double& load : record.actuator_load) load = number();
    record.energy_port = number();
    record.energy_unrendered = number();
    record.force_gain = 1;
    return record;
  }

private:
  std::mt19937_64 random_;
};

inline TapeHeader made_up_header() {
  TapeHeader header;
  header.program_version = "0.1.0";
  header.simd = "avx2";
  header.scenario = "piping";
  header.scenario_file = "scenario.yaml";
  header.files = {{"scenario.yaml", "title: \"Röhre\"\n"}, {"devices/simulated.yaml", "max_force: 7.9\n"}};
  header.overrides = {"coupling.stiffness=300", "seed=-4"};
  header.seed = -4;
  header.hand = "expert";
  header.device = "simulated";
  header.tick_s = 0.001;
  header.hashes = {{"scene.glb", std::string(64, 'a')}};
  return header;
}

}  // namespace fulcrum::record
