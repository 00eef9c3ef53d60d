// What a World refuses.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "haptics/math/number_text.h"
#include "haptics/scene/coupling_gains.h"
#include "haptics/world/figures.h"
#include "haptics/world/world.h"

namespace fulcrum {
namespace {

// Of m / T^2. The coupling's part of what the tick can hold; the contact's comes on top (contact/penalty.h).
constexpr double kCouplingShare = 0.25;

// Of the coupling's largest force: what the weight may take of it where the tool has no inertia.
constexpr double kLargestSag = 0.9;

Error refuse_gain(const char* key, double given, const char* unit, double largest, double tick_s) {
  return {std::string(key) + " is " + number_text(given) + " " + unit + ", and with this tool a tick of " +
          number_text(tick_s * 1e3) + " ms can hold at most " + number_text(largest) +
          ": lower it, raise the tick rate or the tool's mass, or name the integrator implicit_euler."};
}

bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

std::optional<Error> refuse_mechanism(const DeviceDesc& device) {
  if (device.kinematics != Kinematics::arms) return std::nullopt;
  if (auto error = Mechanism::refuse(device.mechanism)) return error;
  const int motors = Mechanism::motors(device.mechanism);
  if (device.renders_torque != (motors >= 6))
    return Error{
        "The device '" + device.name + "' has " + std::to_string(motors) +
        " motors: with six or more it renders torque, with fewer it does not. Set renders_torque so."};
  return std::nullopt;
}

std::optional<Error> refuse_channels(const DeviceDesc& device) {
  if (!device.vibrotactile) return std::nullopt;
  const std::vector<ChannelDesc>& channels = device.vibrotactile->channels;
  if (channels.size() > kMaxChannels || !device.vibrotactile->find("left") ||
      !device.vibrotactile->find("right"))
    return Error{"The device '" + device.name + "' has " + std::to_string(channels.size()) +
                 " vibrotactile channels: it needs 'left' and 'right', and may have " +
                 std::to_string(kMaxChannels) + " in all."};
  return std::nullopt;
}

std::optional<Error> refuse_levels(const ContactDesc& contact) {
  if (!contact.levels.empty() && contact.response == ContactResponse::constraint)
    return Error{
        "A constraint has no stiffness to choose: leave contact.levels out, or name another response."};
  return std::nullopt;
}

std::optional<Error> refuse_holding_point(const SceneDesc& desc) {
  const HoldingPointDesc& holding = *desc.holding_point;
  if (!within(holding.place, holding.low, holding.high))
    return Error{"holding_point.place is " + number_text(holding.place) +
                 " m and must lie on the stick, from 'low' to 'high'."};
  return std::nullopt;
}

// Held elsewhere than at its centre of mass the tool gives way more easily there, and its motions mix.
std::optional<Error> refuse_grip(const SceneDesc& desc, double smallest_inertia) {
  const Vec3 p_TG = longest_grip(desc);
  const double mass = RigidBody(desc.tool.mass, desc.tool.inertia_T).least_mass_at(p_TG);
  const double rate_squared =
      desc.coupling.stiffness / mass + desc.coupling.angular_stiffness / smallest_inertia;
  const double largest = kCouplingShare / (desc.tick_s * desc.tick_s);
  if (rate_squared <= largest) return std::nullopt;
  return Error{"Held up to " + number_text(p_TG.norm() * 1e3) +
               " mm from its centre of mass the tool can bear no more than " +
               number_text(100 * largest / rate_squared) +
               " % of the coupling's stiffness at this tick rate: lower coupling.stiffness and "
               "coupling.angular_stiffness, raise tick_rate_Hz, or name the integrator implicit_euler."};
}

// The first part of a column's name: whose it is.
std::string_view owner(std::string_view column) {
  return column.substr(0, column.find('/'));
}

// The visitor of describe() that knows whose the columns are.
class Owners {
public:
  void time(const Quantity& what, std::int64_t) { add(what); }
  void number(const Quantity& what, double) { add(what); }
  void count(const Quantity& what, std::int64_t) { add(what); }
  void vector(const Quantity& what, const Vec3&) { add(what); }
  void length(const Quantity& what, const Vec3&) { add(what); }
  void pose(const Quantity& what, const Pose&) { add(what); }
  void wrench(const Quantity& what, const Wrench&) { add(what); }
  void each(const Quantity& what, std::span<const double>, std::span<const std::string>) { add(what); }
  void unseen(const auto&) {}
  const RecordNames& names() const { return names_; }

  bool know(std::string_view name) const { return std::ranges::find(owners_, name) != owners_.end(); }

private:
  void add(const Quantity& what) { owners_.push_back(owner(what.name)); }
  std::vector<std::string_view> owners_;
  RecordNames names_;
};

// Columns of effects from outside: as many as there is room for, each with a name of its own.
std::optional<Error> refuse_own_columns(TickRecord blank) {
  const OwnRecord own = std::exchange(blank.own, {});
  if (!own.fits())
    return Error{"The effects from outside have more than " + std::to_string(OwnRecord::kMaxValues) +
                 " values in a tick's record together, which is all that there is room for: leave some out."};
  Owners owners;
  describe(owners, blank);
  const std::span<const OwnRecord::Value> values = own.values();
  for (auto each = values.begin(); each != values.end(); ++each) {
    const std::string name(each->what->name);
    if (owners.know(owner(name)))
      return Error{"An effect from outside names a value '" + name + "', and columns that begin with '" +
                   std::string(owner(name)) + "' are there already: begin it with the effect's own name."};
    if (std::any_of(values.begin(), each, [&](const auto& other) { return other.what->name == name; }))
      return Error{"Two values of effects from outside are named '" + name +
                   "': name one of them otherwise."};
  }
  return std::nullopt;
}

}  // namespace

Result<World> World::build(SceneDesc desc, std::vector<std::unique_ptr<Effect>> own) {
  if (!desc.tool_features && (!desc.tool_shell || desc.tool_shell->size() == 0))
    return Error{"The tool has no pointshell, so nothing could touch: give a model with the role 'tool'."};
  if (!desc.scene_features && !desc.scene_field)
    return Error{
        "The scene has no distance field, so nothing could be touched: give a model with the role 'scene'."};
  if (!desc.tool_shell != !desc.scene_field)
    return Error{
        "The tool's pointshell needs the scene's distance field, and the other way about: give both or "
        "neither."};
  if (!desc.scene_field && detects_impacts(desc))
    return Error{
        "Impacts are told apart by the scene's distance field: give it, and the tool's pointshell, beside "
        "the features."};
  if (auto error = refuse_figures(desc)) return *error;
  const ToolDesc& tool = desc.tool;
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(tool.inertia_T);
  const double smallest_inertia = principal.eigenvalues()[0];
  if (!(smallest_inertia > 0))
    return Error{
        "The tool's principal moments of inertia must be positive: check its density and that its mesh "
        "encloses a volume."};
  if (has_friction(desc.contact) && !coupled(desc.contact.response))
    return Error{
        "Under the response direct the tool is where the hand wants it, and nothing rubs: name another "
        "response, or leave friction out."};
  if (!coupled(desc.contact.response) && !desc.device.renders_force)
    return Error{"Under the response direct the device's force alone keeps the tool out, and '" +
                 desc.device.name + "' has none: name another response."};
  if (auto error = refuse_mechanism(desc.device)) return *error;
  if (desc.device.strip) {
    if (auto error = refuse_strip(*desc.device.strip)) return *error;
  }
  if (!desc.scene_edges != !desc.tool_field)
    return Error{
        "The scene's edges need a field of the tool, and the other way about: give both or neither."};
  if (desc.scene_edges && desc.contact.response != ContactResponse::constraint)
    return Error{
        "The scene's edges are there for the response constraint alone: name that response, or leave "
        "them out."};
  if (!desc.tool_features != !desc.scene_features)
    return Error{"Contact on triangles needs the tool's features and the scene's: give both or neither."};
  if (desc.tool_features && desc.contact.response != ContactResponse::constraint)
    return Error{
        "Contact on triangles is there for the response constraint alone: name that response, or leave the "
        "features out."};
  if (desc.tool_features && desc.scene_edges)
    return Error{"Contact on triangles measures the scene's edges itself: leave them out."};
  const double rate_squared = 1.0 / (desc.tick_s * desc.tick_s);
  const bool any_gain = desc.integrator == Integrator::implicit_euler || massless(desc.contact.response);
  const double largest_k = kCouplingShare * tool.mass * rate_squared;
  if (!any_gain && desc.coupling.stiffness > largest_k)
    return refuse_gain("coupling.stiffness", desc.coupling.stiffness, "N/m", largest_k, desc.tick_s);
  const double largest_kr = kCouplingShare * smallest_inertia * rate_squared;
  if (!any_gain && desc.coupling.angular_stiffness > largest_kr)
    return refuse_gain("coupling.angular_stiffness", desc.coupling.angular_stiffness, "N m/rad", largest_kr,
                       desc.tick_s);
  if (desc.holding_point) {
    if (auto error = refuse_holding_point(desc)) return *error;
    if (!any_gain && moves_grip(desc.contact.response)) {
      if (auto error = refuse_grip(desc, smallest_inertia)) return *error;
    }
  }
  if (auto error = refuse_levels(desc.contact)) return *error;
  if (coupled(desc.contact.response) && massless(desc.contact.response) &&
      tool_weight(tool) > kLargestSag * desc.coupling.max_force)
    return Error{"The tool weighs " + number_text(tool_weight(tool)) + " N, which a coupling of at most " +
                 number_text(desc.coupling.max_force) +
                 " N cannot carry: raise coupling.max_force or set tool.weight to false."};
  if (auto error = refuse_channels(desc.device)) return *error;
  if (auto error = refuse_effects(desc, desc)) return *error;
  World world(std::move(desc));
  for (std::unique_ptr<Effect>& effect : own) {
    if (!effect) return Error{"An effect from outside is null: make it before the World is built."};
    world.effects_.push_back(std::move(effect));
  }
  if (auto error = refuse_own_columns(world.blank_record())) return *error;
  return world;
}

}  // namespace fulcrum
