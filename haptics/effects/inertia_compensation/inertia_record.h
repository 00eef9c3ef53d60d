#pragma once
// Compensation of a device's inertia, as the trace and the panel see it.

#include <cstdint>

#include "haptics/math/linear.h"
#include "haptics/math/names_of.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

enum class InertiaMethod : std::int32_t { none, arm, acceleration };
template <>
inline constexpr std::array<std::string_view, 3> names_of<InertiaMethod>{"none", "arm", "acceleration"};

// What one tick leaves behind.
struct InertiaRecord {
  InertiaMethod method = InertiaMethod::none;
  double gain = 0;                     // of m a, that was in use
  bool faded = false;                  // it would have given more energy than it may
  Vec3 acceleration_D = Vec3::Zero();  // (3) m/s^2, of the handle, as estimated
  Vec3 force_D = Vec3::Zero();         // (3) N on the handle, what was commanded of it
  Vec3 torque_D = Vec3::Zero();        // (3) N m, what the method arm changed
  double energy = 0;                   // J, the account of acceleration, see InertiaCompensation
  double arm_energy = 0;               // J, that of arm
};

template <class V>
void describe(V& values, const InertiaRecord& record) {
  const auto& [method, gain, faded, acceleration_D, force_D, torque_D, energy, arm_energy] = record;
  values.count({"inertia_compensation/method", "1", "", "0 none, 1 arm, 2 acceleration."},
               static_cast<std::int64_t>(method));
  values.number({"inertia_compensation/gain", "1", "", "Of the device's mass times acceleration, in use."},
                gain);
  values.unseen(faded);  // the fault bit tells
  values.vector({"inertia_compensation/acceleration", "m/s^2", "D", "Of the handle, as estimated."},
                acceleration_D);
  values.vector({"inertia_compensation/force", "N", "D", "Commanded on the handle for the device's inertia."},
                force_D);
  values.vector(
      {"inertia_compensation/torque", "N m", "D", "What the method arm adds to the torque on the handle."},
      torque_D);
  values.number({"inertia_compensation/energy", "J", "",
                 "What compensation gave, less what is in the handle's motion and what damping has taken."},
                energy);
  values.number({"inertia_compensation/arm_energy", "J", "",
                 "What the torque of the method arm gave to the hand, forgotten over a second."},
                arm_energy);
}

}  // namespace fulcrum
