#include "drivers/inverse3/service_messages.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace fulcrum::inverse3 {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostName = 64;
constexpr double kReach = 1;         // m: nowhere is a handle farther from its arm's base
constexpr double kNormWithin = 0.1;  // of a turn's quaternion from 1

// None: it is no JSON, or too much of it.
std::optional<Json> parsed(std::string_view message) {
  if (message.size() > kMostBytes) return std::nullopt;
  bool deep = false;
  const auto keep = [&deep](int depth, Json::parse_event_t, Json&) {
    deep = deep || depth > kMostDepth;
    return !deep;
  };
  Json whole = Json::parse(message.begin(), message.end(), keep, false);
  if (deep || !whole.is_object()) return std::nullopt;
  return whole;
}

struct Listed {
  std::string_view name;
  const Json* device = nullptr;  // null: it is not in the list
};

// Parts of a message. One that is not there is null; one that is of another kind than it should be spoils the
// whole message, which is told once, at the end.
class Parts {
public:
  bool spoilt() const { return spoilt_; }

  const Json* part(const Json* of, const char* name) {
    if (of == nullptr) return nullptr;
    if (!of->is_object()) return spoil();
    const auto found = of->find(name);
    return found == of->end() ? nullptr : &*found;
  }
  double number(const Json& of, const char* name) {
    const Json* const value = part(&of, name);
    const double number = value != nullptr && value->is_number() ? value->get<double>() : NAN;
    if (!std::isfinite(number)) spoil();
    return number;
  }
  Vec3 vector(const Json& of) { return {number(of, "x"), number(of, "y"), number(of, "z")}; }
  std::string_view text(const Json* value, std::string_view where_absent) {
    if (value == nullptr) return where_absent;
    const auto* const text = value->get_ptr<const std::string*>();
    if (text != nullptr && !text->empty() && text->size() <= kMostName) return *text;
    spoil();
    return {};
  }
  bool flag(const Json* of, const char* name, bool where_absent) {
    const Json* const value = part(of, name);
    if (value == nullptr) return where_absent;
    if (!value->is_boolean()) spoil();
    return value->is_boolean() && value->get<bool>();
  }
  // name: empty takes the first. A name that two devices bear is nobody's.
  Listed listed(const Json& whole, const char* list, const std::string& name) {
    const Json* const devices = part(&whole, list);
    Listed found;
    if (devices == nullptr) return found;
    if (!devices->is_array()) spoil();
    for (const Json& device : *devices) {
      const std::string_view its = text(part(&device, "device_id"), {});
      if (its.empty() || (found.device != nullptr && its == found.name)) spoil();
      if (found.device == nullptr && (name.empty() || its == name)) found = {its, &device};
    }
    return found;
  }

private:
  const Json* spoil() {
    spoilt_ = true;
    return nullptr;
  }
  bool spoilt_ = false;
};

std::string why_unusable(Parts& parts, const Json& arm) {
  const Json* const config = parts.part(&arm, "config");
  const std::string_view kind = parts.text(parts.part(config, "type"), "inverse3");
  if (!kind.starts_with("inverse3")) {
    std::string other = "what is plugged in is another device of its maker's, ";
    return other.append(kind).append(", which is not known here: plug in an Inverse3.");
  }
  const Json* const axes = parts.part(parts.part(config, "basis"), "permutation");
  const Json* const scale = parts.part(parts.part(config, "mount"), "scale");
  const bool own_scale = scale == nullptr || parts.vector(*scale) == Vec3::Ones();
  if (own_scale && parts.text(axes, "XYZ") == "XYZ") return {};
  return "its service is set to other axes or another scale than its own: in Haply Hub, set its basis to XYZ "
         "and the scale of its mount to 1.";
}

void read_arm(Parts& parts, const Json& arm, ServiceSays& says) {
  const Json* const cursor = parts.part(parts.part(&arm, "state"), "cursor_position");
  says.p_SH = cursor != nullptr ? parts.vector(*cursor) : Vec3::Constant(NAN);
  const Json* const status = parts.part(&arm, "status");
  says.calibrated = parts.flag(status, "calibrated", true);
  says.powered = parts.flag(status, "power_supply", true);
  says.unusable = why_unusable(parts, arm);
}

// A VerseGrip by wire has one button, a wireless one three.
void read_handle(Parts& parts, const Json& handle, ServiceSays& says) {
  const Json* const state = parts.part(&handle, "state");
  const Json* const buttons = parts.part(state, "buttons");
  constexpr std::array kButtons{"a", "b", "c"};
  for (std::size_t i = 0; i < kButtons.size(); ++i)
    if (parts.flag(buttons, kButtons[i], false)) says.buttons |= 1u << i;
  if (parts.flag(state, "button", false)) says.buttons |= 1u;
  if (const Json* const turn = parts.part(state, "orientation"); turn != nullptr)
    says.q_SH = Quat(parts.number(*turn, "w"), parts.number(*turn, "x"), parts.number(*turn, "y"),
                     parts.number(*turn, "z"));
}

}  // namespace

std::optional<ServiceSays> decode(std::string_view message, const std::optional<Chosen>& chosen) {
  const std::optional<Json> whole = parsed(message);
  if (!whole) return std::nullopt;
  Parts parts;
  ServiceSays says;
  says.since_3_5 = parts.part(&*whole, "session_id") != nullptr;
  const Listed arm = parts.listed(*whole, "inverse3", chosen ? chosen->arm : "");
  if (arm.device != nullptr) {
    says.of.arm = arm.name;
    read_arm(parts, *arm.device, says);
  }
  for (const char* list : {"verse_grip", "wireless_verse_grip"}) {
    if (chosen && chosen->handle.empty()) break;
    const Listed handle = parts.listed(*whole, list, chosen ? chosen->handle : "");
    if (handle.device == nullptr) continue;
    says.of.handle = handle.name;
    read_handle(parts, *handle.device, says);
    break;
  }
  if (parts.spoilt() || !(says.p_SH.norm() < kReach)) return std::nullopt;
  if (!says.q_SH) return says;
  if (!(std::abs(says.q_SH->norm() - 1) < kNormWithin)) return std::nullopt;
  says.q_SH->normalize();
  return says;
}

std::string encode_force(const std::string& arm, const Vec3& force_S, bool since_3_5) {
  const Vec3 force = force_S.allFinite() ? force_S : Vec3::Zero();
  Json told;
  Json& device = told["inverse3"][0];
  device["device_id"] = arm;
  device["commands"]["set_cursor_force"][since_3_5 ? "vector" : "values"] = {
      {"x", force.x()}, {"y", force.y()}, {"z", force.z()}};
  return told.dump();
}

}  // namespace fulcrum::inverse3
