#pragma once
// A tape: what went into a run, so that the run can be repeated and compared, tick for tick and bit for bit.
//
// File, little-endian:
//     "FULCTAPE"  u32 version  u32 n  u32 CRC-32C of the 16 bytes before  header: n bytes of JSON  u32
//     CRC-32C of it chunks:     u32 kind  u32 n  u32 CRC-32C of the 8 bytes before  payload: n bytes  u32
//     CRC-32C of it
// Kind "TICK", payload:  u64 index of the first entry  u32 entries  then each entry:
//     f64 q.w q.x q.y q.z p.x p.y p.z age strip_ohm  u32 buttons  u8 connected  i64 lost_before  u64 digest
//     u32 commands  u32 kind  f64 value of each
// Kind "END ", payload:  u64 entries of the whole tape. Nothing follows it.
//
// Versions 2 and 3, which are still read, have digests that are made otherwise: such a tape is repeated, and
// not compared. Version 2 has no strip_ohm: there was no strip.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/device/device.h"
#include "haptics/tick/command.h"

namespace fulcrum::record {

inline constexpr std::string_view kTapeMagic = "FULCTAPE";
inline constexpr std::uint32_t kTapeVersion = 4;
inline constexpr std::uint32_t kOldestTapeVersion = 2;  // that is still read

// Everything that a replay needs besides the samples. All text is UTF-8.
struct TapeHeader {
  std::string program_version;
  std::string simd;                          // the SIMD target that computed the run
  std::string scenario;                      // its name
  std::string scenario_file;                 // the key of the scenario itself in `files`
  std::map<std::string, std::string> files;  // file name -> its text
  std::vector<std::string> overrides;        // --set KEY=VALUE, in the order given
  std::int64_t seed = 1;
  std::string hand;
  std::string device;
  double tick_s = 1e-3;
  std::map<std::string, std::string> hashes;  // content that is not embedded: file name -> SHA-256

  bool operator==(const TapeHeader&) const = default;
};

// One tick's input, and a digest of what came of it.
struct TapeEntry {
  DeviceSample sample;
  std::vector<Command> commands;          // those given this tick, in order
  std::int64_t lost_before = 0;           // ticks lost to an overrun before this one
  std::optional<std::uint64_t> digest{};  // digest() of the resulting TickRecord; none: of an older format
};

struct Tape {
  TapeHeader header;
  std::vector<TapeEntry> entries;
  bool complete = false;  // it has its end; without one the run was killed or the disk was full
};

}  // namespace fulcrum::record
