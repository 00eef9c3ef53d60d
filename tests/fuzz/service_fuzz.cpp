// Reference: none; any bytes as what Haply's service says of an Inverse3.
// Invariants: what is taken has a place within reach, a turn that is one and names that fit into a command;
// what was chosen stays chosen; and a command is JSON that holds the name as it was said and the force, or
// none where that is no number.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "drivers/inverse3/service_messages.h"

namespace fulcrum {
namespace {

void require(bool good) {
  if (!good) std::abort();
}

void look_at(const inverse3::ServiceSays& says) {
  require(says.p_SH.allFinite() && says.p_SH.norm() < 1);
  require(!says.q_SH || std::abs(says.q_SH->norm() - 1) < 1e-9);
  require(!says.q_SH || !says.of.handle.empty());
  require(says.of.arm.size() <= 64 && says.of.handle.size() <= 64 && says.buttons < 8);
}

void tell(const std::string& arm, const Vec3& force, bool since_3_5) {
  const auto told = nlohmann::json::parse(inverse3::encode_force(arm, force, since_3_5));
  const auto& device = told.at("inverse3").at(0);
  const auto& newtons = device.at("commands").at("set_cursor_force").at(since_3_5 ? "vector" : "values");
  require(device.at("device_id") == arm);
  const Vec3 expected = force.allFinite() ? force : Vec3::Zero();
  require(newtons.at("x") == expected.x() && newtons.at("y") == expected.y() &&
          newtons.at("z") == expected.z());
}

}  // namespace
}  // namespace fulcrum

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulcrum;
  const std::string_view message(reinterpret_cast<const char*>(data), size);
  const auto first = inverse3::decode(message, std::nullopt);
  if (!first) return 0;
  require(size <= inverse3::kMostBytes);
  look_at(*first);
  Vec3 force = Vec3::Zero();
  if (size >= 24) std::memcpy(force.data(), data, 24);
  if (!first->of.arm.empty()) tell(first->of.arm, force, first->since_3_5);
  const auto again = inverse3::decode(message, first->of);
  require(again && (first->of.arm.empty() || again->of.arm == first->of.arm));
  look_at(*again);
  return 0;
}
