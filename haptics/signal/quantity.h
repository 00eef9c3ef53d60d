#pragma once
// How a record tells what it holds. Beside each struct of a tick's record stands
//
//     template <class V>
//     void describe(V& values, const Record& record);
//
// which binds every field by name, so that one that is forgotten does not compile, and hands each to the
// visitor with its name, unit, frame and meaning. The trace's columns, its rows and the tape's digest are
// written by visitors (engine/record: trace_columns.cpp, digest.cpp): no value can be in one and be missing
// from another.
//
// A visitor has
//     time(Quantity, std::int64_t tick)       simulated time
//     number(Quantity, double)
//     count(Quantity, std::int64_t)           whole numbers, choices, yes and no
//     vector(Quantity, const Vec3&)           three columns: /x, /y, /z
//     pose(Quantity, const Pose&)             seven: /p/x to /p/z, and the quaternion /q/w, /q/x, /q/y, /q/z
//     wrench(Quantity, const Wrench&)         six: /force/x to /force/z, /torque/x to /torque/z
//     length(Quantity, const Vec3&)           one column, though the digest sees all three
//     each(Quantity, std::span<const double>, std::span<const std::string> names)   one for each name
//     unseen(const T&)                        has no column; the digest alone sees it
//     names()                                 of the device's parts: RecordNames

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum {

struct Quantity {
  std::string_view
      name;  // of its column, a tree by '/'; its first part is an effect's key in a scenario, or its name
  std::string_view unit;     // "1" for a count or a ratio; empty for a pose or a wrench, which have their own
  std::string_view frame;    // that it is expressed in; empty where there is none
  std::string_view meaning;  // a sentence; for a pose or a wrench without its full stop
};

// The names of those parts of a device that have a column each.
struct RecordNames {
  std::vector<std::string> motors{};    // in the order of PlainRecord::actuator_load: Actuators::name()
  std::vector<std::string> channels{};  // in the order of VibrotactileCommand::level
};

}  // namespace fulcrum
