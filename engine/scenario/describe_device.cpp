#include <algorithm>

#include "engine/scenario/describe.h"
#include "engine/scenario/words.h"

namespace fulcrum::scenario {

namespace {

constexpr Range kAngle = from_to(-6.2831853, 6.2831853);
constexpr Range kResistance = from_to(0, 1e7);

void describe_joint(KeyVisitor& visitor, JointDesc& joint, std::string_view name) {
  joint.name = name;
  visitor.vector({"axis", "", "its direction, all angles 0; turns are right-handed", true}, joint.axis_K,
                 from_to(-1, 1));
  visitor.vector({"point", "m", "on its axis, all angles 0", true}, joint.point_K, kPosition);
  visitor.number({"home", "rad", "its angle where the handle is at the device's origin"}, joint.home, kAngle);
  visitor.number({"low", "rad", "its stop on one side"}, joint.low, kAngle);
  visitor.number({"high", "rad", "its stop on the other side"}, joint.high, kAngle);
  visitor.number({"max_torque", "N m", "of its motor, at the joint", true}, joint.max_torque,
                 from_to(0, 1000));
  visitor.boolean({"through_parallelogram", "", "its motor sits before the joint in front of it"},
                  joint.through_parallelogram);
}

void describe_arm(KeyVisitor& visitor, ArmDesc& arm, std::string_view name) {
  arm.name = name;
  visitor.named({"joints", "", "from the base to the handle, by name: three, or six", true}, 1,
                [&](std::string_view joint, KeyVisitor& each) {
                  describe_joint(each, arm.joints.emplace_back(), joint);
                });
  visitor.vector({"end", "m", "where the arm ends, all angles 0", true}, arm.end_K, kPosition);
}

void describe_spin(KeyVisitor& visitor, SpinDesc& spin) {
  visitor.word({"name", "", "of the motor", true}, spin.name);
  visitor.number({"ratio", "", "turns of the handle for one of the motor"}, spin.ratio, above_to(0, 1000));
  visitor.number({"max_torque", "N m", "of the motor", true}, spin.max_torque, from_to(0, 1000));
}

void describe_structure(KeyVisitor& visitor, StructureDesc& structure) {
  visitor.number({"tip_stiffness", "N/m", "at the handle's origin", true}, structure.tip_stiffness,
                 above_to(0, 1e9));
  visitor.vector({"angular_stiffness", "N m/rad", "about the handle's axes there", true},
                 structure.angular_stiffness_H, above_to(0, 1e9));
}

void describe_channel(KeyVisitor& visitor, ChannelDesc& channel, std::string_view name) {
  channel.name = name;
  visitor.choice_of({"kind", "",
                     "rumble: a motor that is told an amplitude; pcm: a voice coil or an audio channel, that "
                     "is told samples; tone: an actuator that is told a frequency and an amplitude",
                     true},
                    channel.kind);
  visitor.number(
      {"largest", "m/s^2", "amplitude of the acceleration at full drive; pcm: at the resonance", true},
      channel.largest, above_to(0, 1000));
  visitor.number({"rate_Hz", "", "pcm: of the samples"}, channel.rate_Hz, from_to(1000, 192000));
  visitor.number({"resonance_Hz", "", "pcm: of the vibrator, which needs it"}, channel.resonance_Hz,
                 from_to(0, 20000));
  visitor.number({"quality", "", "pcm: of the resonance, above 0.5; it needs it"}, channel.quality,
                 from_to(0, 1000));
  visitor.number({"lag", "s", "rumble and tone: time constant of the amplitude"}, channel.lag,
                 from_to(0, 10));
  const bool pcm = channel.kind == ChannelKind::pcm;
  visitor.rule("resonance_Hz", !pcm || channel.resonance_Hz > 0, "must be positive for the kind pcm");
  visitor.rule("quality", !pcm || channel.quality > 0.5, "must be above 0.5 for the kind pcm");
}

void describe_strip(KeyVisitor& visitor, HoldingStripDesc& strip) {
  visitor.number({"low_place", "m", "where it begins, along the handle's x axis from its origin", true},
                 strip.low_place, kPosition);
  visitor.number({"high_place", "m", "where it ends", true}, strip.high_place, kPosition);
  visitor.number({"low_ohm", "ohm", "where it begins, as calibrated"}, strip.low_ohm, kResistance);
  visitor.number({"high_ohm", "ohm", "where it ends, as calibrated"}, strip.high_ohm, kResistance);
  visitor.number({"closing_force", "N", "a press from which on it is closed"}, strip.closing_force,
                 from_to(0, 100));
  visitor.number({"opening_force", "N", "a press below which it is open again"}, strip.opening_force,
                 from_to(0, 100));
  visitor.number({"noise_ohm", "rms", "of the simulated strip"}, strip.noise_ohm, kResistance);
  visitor.number({"dropout_rate", "1/s", "of the simulated strip: how often contact is lost"},
                 strip.dropout_rate, from_to(0, 1000));
  visitor.number({"dropout_length", "s", "of the simulated strip: how long contact is lost, in the mean"},
                 strip.dropout_length, from_to(0, 100));
  visitor.number(
      {"tolerance", "",
       "of the simulated strip: by how much of its length its true ends differ at most from the calibration"},
      strip.tolerance, from_to(0, 1));
}

}  // namespace

void describe_device_file(KeyVisitor& visitor, DeviceDesc& device) {
  visitor.version({"fulcrum", "", "version of the file's format", true}, kFormatVersion);
  visitor.text({"name", "", "as panels and results show it", true}, device.name);
  visitor.choice_of(
      {"kinematics", "", "none: no motors; cartesian: one for each axis; arms: as 'arms' and 'spin' say"},
      device.kinematics);
  visitor.boolean({"renders_force", "", "it can push"}, device.renders_force);
  visitor.boolean({"renders_torque", "", "it can twist"}, device.renders_torque);
  visitor.boolean({"senses_rotation", "", "it knows how its handle is turned"}, device.senses_rotation);
  visitor.number({"max_force", "N", "on the handle"}, device.max_force, from_to(0, 1000));
  visitor.number({"max_torque", "N m", "on the handle"}, device.max_torque, from_to(0, 100));
  visitor.number({"handle_mass", "kg", "apparent, at the handle"}, device.handle_mass, above_to(0, 100));
  visitor.each_axis({"handle_inertia", "kg m^2", "apparent, about the handle's axes, or one for all"},
                    device.handle_inertia, above_to(0, 10));
  visitor.number({"handle_weight", "N", "what the mechanism leaves uncompensated"}, device.handle_weight,
                 from_to(0, 1000));
  visitor.number({"bandwidth_Hz", "", "of the forces and torques that it renders"}, device.bandwidth_Hz,
                 above_to(0, 20000));
  visitor.number({"damping", "N s/m", "of the mechanism"}, device.damping, from_to(0, 1000));
  visitor.each_axis({"angular_damping", "N m s/rad", "of the mechanism, about each axis"},
                    device.angular_damping, from_to(0, 100));
  visitor.number({"friction", "N", "Coulomb, on each axis"}, device.friction, from_to(0, 100));
  visitor.number({"angular_friction", "N m", "Coulomb, on each axis"}, device.angular_friction,
                 from_to(0, 10));
  visitor.number({"encoder_step", "m", "smallest difference of position that is seen"}, device.encoder_step,
                 from_to(0, 0.01));
  visitor.number({"encoder_step_rad", "", "smallest difference of orientation that is seen"},
                 device.encoder_step_rad, from_to(0, 0.1));
  visitor.number({"sample_rate_Hz", "",
                  "of a device that has its own: how old a sample is, is in the trace; 0: one for each tick"},
                 device.sample_rate_Hz, from_to(0, 1e6));
  visitor.number(
      {"firmware_watchdog", "s",
       "after which its firmware lets its motors go where no command comes; 0: it is not known to"},
      device.firmware_watchdog, from_to(0, 60));
  visitor.vector({"workspace", "m", "half extents about the device's origin"}, device.workspace,
                 above_to(0, 10));
  visitor.mapping(
      {"base", "",
       "the frame of 'arms', in the device's: it turns its axes to right, up and towards the person"},
      [&](KeyVisitor& inner) {
        inner.rotation({"orientation", "", "[w, x, y, z]"}, device.mechanism.q_DK);
      });
  visitor.named(
      {"arms", "", "of kinematics 'arms', by name: one or two, the first holds the handle's origin"}, 0,
      [&](std::string_view name, KeyVisitor& each) {
        describe_arm(each, device.mechanism.arms.emplace_back(), name);
      });
  visitor.mapping(
      {"structure", "", "how stiff its structure and motors are: bounds the walls that it renders"},
      [&](KeyVisitor& inner) { describe_structure(inner, device.structure.emplace()); });
  visitor.mapping({"spin", "", "a motor that turns the handle about the line between two arms' ends"},
                  [&](KeyVisitor& inner) { describe_spin(inner, device.mechanism.spin.emplace()); });
  visitor.named({"channels", "",
                 "vibrators, by name: 'left' and 'right', on either side along x, and two more at most"},
                0, [&](std::string_view name, KeyVisitor& each) {
                  if (!device.vibrotactile) device.vibrotactile.emplace();
                  describe_channel(each, device.vibrotactile->channels.emplace_back(), name);
                });
  if (device.vibrotactile) {
    const VibrotactileDesc& vibrators = *device.vibrotactile;
    visitor.rule(
        "channels",
        vibrators.find("left") && vibrators.find("right") && vibrators.channels.size() <= kMaxChannels,
        "must have 'left' and 'right', and two more at most");
    visitor.rule("channels", std::ranges::all_of(vibrators.channels, is_word, &ChannelDesc::name),
                 "must have names of letters, digits, '_' and '-': each becomes a part of a file's name");
  }
  visitor.mapping(
      {"strip", "", "along the handle, that knows where the hand holds: a membrane potentiometer"},
      [&](KeyVisitor& inner) { describe_strip(inner, device.strip.emplace()); });
}

}  // namespace fulcrum::scenario
