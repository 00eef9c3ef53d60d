#include "tests/device_models/falcon_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fulcrum::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int k9600 = 0x4138, k140000 = 0x15, kFastest = 2;

int nibbles(const FalconModel::Bytes& packet, std::size_t at) {
  int word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word * 16 + (packet[at + i] - 'A');
  return word < 32768 ? word : word - 65536;
}

}  // namespace

FalconModel::FalconModel(Bytes firmware, bool runs)
    : firmware_(std::move(firmware)), processor_(runs ? Processor::runs : Processor::off) {}

FalconModel::Bytes FalconModel::device_descriptor() {
  return {18, 1, 0x10, 0x01, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xCB, 0x00, 0x04, 0, 0, 0, 1};
}

// One interface of the vendor's with two bulk endpoints of 64 bytes, powered by itself.
FalconModel::Bytes FalconModel::configuration_descriptor() {
  return {9, 2, 32,   0, 1,  1,   0,   0xC0, 0,  // configuration 1
          9, 4, 0,    0, 2,  255, 255, 255,  0,  // interface 0
          7, 5, 0x81, 2, 64, 0,   0,             // in
          7, 5, 0x02, 2, 64, 0,   0};            // out
}

bool FalconModel::control(int type, int request, int value, int index) {
  const std::lock_guard lock(mutex_);
  if (type != 0x40 || index != 0) return false;
  switch (request) {
    case 0:
      if (value == 1) said_.clear();
      if (value == 2) heard_.clear();
      return value <= 2;
    case 1:
      if ((value & 0x200) != 0) rts_ = (value & 2) != 0;
      if ((value & 0x100) == 0) return true;
      // Its processor is reset when the line rises.
      if (!dtr_ && (value & 1) != 0) {
        processor_ = Processor::listens;
        heard_.clear();
        taken_.clear();
        homed_ = false;
      }
      dtr_ = (value & 1) != 0;
      return true;
    case 2:
      flow_ = value;
      return true;
    case 3:
      baud_ = value;
      if (processor_ == Processor::loads && baud_ == kFastest && taken_ == firmware_)
        processor_ = Processor::runs;
      return true;
    case 4:
      data_ = value;
      return true;
    case 9:
      latency_ = value;
      return value > 0 && value < 256;
    default:
      return false;
  }
}

void FalconModel::say(Bytes bytes) {
  if (fault_ == Fault::silent) return;
  if (fault_ == Fault::garbles && !bytes.empty()) bytes.back() = static_cast<std::uint8_t>(bytes.back() ^ 32);
  said_.insert(said_.end(), bytes.begin(), bytes.end());
}

void FalconModel::out(std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(mutex_);
  for (const std::uint8_t byte : bytes) hear(byte);
}

void FalconModel::hear(std::uint8_t byte) {
  heard_.push_back(byte);
  const bool line = data_ == 8 && flow_ == 0 && !rts_ && latency_ == 16;
  switch (processor_) {
    case Processor::off:
      break;
    case Processor::listens:
      if (!line || !dtr_ || baud_ != k9600 || fault_ == Fault::never_greets) break;
      if (heard_.size() < 3 || !std::equal(heard_.end() - 3, heard_.end(), Bytes{0x0A, 0x43, 0x0D}.begin()))
        break;
      processor_ = Processor::greeted;
      say(fault_ == Fault::zero_at_first ? Bytes{0, 0x0A, 0x44, 0x2C, 0x0D} : Bytes{0x0A, 0x44, 0x2C, 0x0D});
      break;
    case Processor::greeted:
      if (!line || dtr_ || baud_ != k140000 || byte != 0x41) break;
      processor_ = Processor::loads;
      say({0x41});
      break;
    case Processor::loads:
      if (baud_ != k140000) break;
      taken_.push_back(byte);
      say({byte});
      most_unread_ = std::max(most_unread_, said_.size());
      break;
    case Processor::runs:
      if (baud_ == kFastest && byte == '>') hear_packet();
      break;
  }
}

void FalconModel::hear_packet() {
  const Bytes heard = std::exchange(heard_, {});
  if (heard.size() < 16 || heard[heard.size() - 16] != '<') return;
  const Bytes packet(heard.end() - 16, heard.end());
  for (std::size_t leg = 0; leg < 3; ++leg) motors_[leg] = nibbles(packet, 1 + 4 * leg);
  lights_ = static_cast<unsigned>(packet[13] - 'A');
  ++packets_;
  Bytes answer(16, 'A');
  answer.front() = '<';
  answer.back() = '>';
  const std::array<int, 3> now = counts();
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (std::size_t i = 0; i < 4; ++i)
      answer[1 + 4 * leg + i] = static_cast<std::uint8_t>('A' + ((now[leg] + 65536) % 65536 >> 4 * i) % 16);
  answer[13] = static_cast<std::uint8_t>('A' + (homed_ ? 0x70 : 0) + static_cast<int>(buttons_));
  say(answer);
}

bool FalconModel::has_more() const {
  const std::lock_guard lock(mutex_);
  return !said_.empty();
}

FalconModel::Bytes FalconModel::in() {
  const std::lock_guard lock(mutex_);
  Bytes packet{0x01, 0x60};
  const std::size_t most = fault_ == Fault::one_by_one ? 1 : 62;
  const auto count = static_cast<std::ptrdiff_t>(std::min(said_.size(), most));
  packet.insert(packet.end(), said_.begin(), said_.begin() + count);
  said_.erase(said_.begin(), said_.begin() + count);
  return packet;
}

// The angle at which a leg's arm, 60 mm, ends where its shin reaches the grip: law of cosines in the plane in
// which the arm turns, in which the shin is as long as its slant leaves it.
std::array<double, 3> FalconModel::angles_at(const Vec3& p_D) const {
  std::array<double, 3> angles{};
  const double directions[] = {105, -15, -135};
  for (std::size_t leg = 0; leg < 3; ++leg) {
    const double c = std::cos(directions[leg] * kDegree), s = std::sin(directions[leg] * kDegree);
    const double outward = c * p_D.x() + s * p_D.y() - 0.040 + 0.01443;
    const double sideways = c * p_D.y() - s * p_D.x() + 0.02309 - 0.025;
    const double forward = p_D.z() + 0.125;
    const double shin = std::sqrt(0.1025 * 0.1025 - sideways * sideways) + 2 * 0.01125;
    const double away = std::hypot(outward, forward);
    const double corner = std::acos((0.060 * 0.060 + away * away - shin * shin) / (2 * 0.060 * away));
    angles[leg] = std::atan2(forward, outward) - corner;
  }
  return angles;
}

std::array<int, 3> FalconModel::counts() const {
  if (fault_ == Fault::impossible) return {30000, -30000, 12};
  const std::array<double, 3> angles = angles_at(p_D_);
  std::array<int, 3> counts{};
  for (std::size_t leg = 0; leg < 3; ++leg)
    counts[leg] = static_cast<int>(std::lround((angles[leg] / kDegree - 35) / 0.036435)) + (homed_ ? 0 : 777);
  return counts;
}

void FalconModel::hold(const Vec3& p_D) {
  const std::lock_guard lock(mutex_);
  p_D_ = p_D;
}

void FalconModel::press(unsigned buttons) {
  const std::lock_guard lock(mutex_);
  buttons_ = buttons;
}

bool FalconModel::home() {
  const std::lock_guard lock(mutex_);
  homed_ = homed_ || (processor_ == Processor::runs && (lights_ & 1) != 0);
  return homed_;
}

void FalconModel::lose_home() {
  const std::lock_guard lock(mutex_);
  homed_ = false;
}

void FalconModel::switch_off_and_on() {
  const std::lock_guard lock(mutex_);
  processor_ = Processor::off;
  said_.clear();
  motors_ = {};
  homed_ = false;
}

// A motor's value is -10000 times its leg's torque in N m. What the torques do in a small way of the hand is
// what the force does.
Vec3 FalconModel::force_D() const {
  const std::lock_guard lock(mutex_);
  Vec3 force = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double step = 1e-6;
    const auto after = angles_at(p_D_ + step * Vec3::Unit(axis));
    const auto before = angles_at(p_D_ - step * Vec3::Unit(axis));
    for (std::size_t leg = 0; leg < 3; ++leg)
      force[axis] += -1e-4 * motors_[leg] * (after[leg] - before[leg]) / (2 * step);
  }
  return force;
}

std::array<int, 3> FalconModel::motors() const {
  const std::lock_guard lock(mutex_);
  return motors_;
}

unsigned FalconModel::lights() const {
  const std::lock_guard lock(mutex_);
  return lights_;
}

bool FalconModel::runs() const {
  const std::lock_guard lock(mutex_);
  return processor_ == Processor::runs;
}

int FalconModel::packets() const {
  const std::lock_guard lock(mutex_);
  return packets_;
}

std::size_t FalconModel::most_unread() const {
  const std::lock_guard lock(mutex_);
  return most_unread_;
}

void FalconModel::have(Fault fault) {
  const std::lock_guard lock(mutex_);
  fault_ = fault;
}

}  // namespace fulcrum::test
