#include "drivers/joycon/joycon_protocol.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "drivers/hid/hid_bytes.h"
#include "drivers/joycon/joycon_rumble.h"

namespace fulcrum::joycon {
namespace {

constexpr std::uint8_t kState = 0x30, kAnswer = 0x21, kKeyAlone = 0x3F;  // reports that come
constexpr std::uint8_t kVibrate = 0x10, kAsk = 0x01;                     // and go
constexpr std::size_t kWholeReport = 49;
constexpr std::size_t kLeftStick = 6, kRightStick = 9, kAcknowledged = 13, kQuestion = 14, kAnswerAt = 15;
constexpr std::size_t kReadAt = kAnswerAt + 5;  // behind address and length
constexpr std::uint8_t kReadFlash = 0x10;

// An order or a question, and what goes with it.
struct Question {
  std::uint8_t number;
  std::uint8_t length;
  std::array<std::uint8_t, 5> with;
};
constexpr Question kQuestions[] = {
    {0x03, 1, {kState}},                      // say all, all the time
    {0x48, 1, {1}},                           // the actuators may be told
    {0x30, 1, {1}},                           // the first light shines
    {kReadFlash, 5, {0x3D, 0x60, 0, 0, 18}},  // the sticks as their maker measured them
    {kReadFlash, 5, {0x10, 0x80, 0, 0, 22}},  // and as their owner did, where he did
};
constexpr unsigned kSayAll = 0, kMakers = 3, kOwners = 4;
constexpr std::uint32_t kAllAnswered = (1U << std::size(kQuestions)) - 1;
constexpr std::uint16_t kOwnerMeasured = 0xA1B2;

constexpr std::uint32_t kKeysOfRight = 0x0016FF, kKeysOfLeft = 0xFF2900;  // of the three bytes
constexpr std::uint32_t kR = 1U << 6, kZR = 1U << 7, kL = 1U << 22, kZL = 1U << 23;

std::uint32_t keys_of(Side side) {
  return (side != Side::left ? kKeysOfRight : 0) | (side != Side::right ? kKeysOfLeft : 0);
}

double down(std::uint32_t keys, std::uint32_t key) {
  return (keys & key) != 0 ? 1 : 0;
}

}  // namespace

bool JoyConProtocol::decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept {
  if (report.empty()) return false;
  if (report[0] == kKeyAlone) answered_ &= ~(1U << kSayAll);  // it has forgotten
  if ((report[0] != kState && report[0] != kAnswer) || report.size() < kWholeReport) return false;
  if (report[0] == kAnswer) hear(report);
  const std::uint32_t keys =
      (hid::u16_at(report, 3) | static_cast<std::uint32_t>(report[5]) << 16) & keys_of(side_);
  axes = {.buttons = keys};
  if (side_ != Side::right) {
    const auto [right, up] = pushed(left_, report.subspan<kLeftStick, 3>());
    axes.way = {right, up, 0};
  }
  if (side_ != Side::left) {
    const auto [right, up] = pushed(right_, report.subspan<kRightStick, 3>());
    axes.turn = {-up, right, 0};
  }
  axes.way.z() = down(keys, kZL) - down(keys, kZR);
  axes.turn.z() = down(keys, kL) - down(keys, kR);
  return true;
}

// An answer counts for the question that is being asked, refused or not: what it cannot do it is not asked
// again. Others may ask it, too, such as Linux's own driver: a flash that is read elsewhere is not for us.
void JoyConProtocol::hear(std::span<const std::uint8_t> report) noexcept {
  const std::uint32_t answered = answered_;
  const auto asked = static_cast<unsigned>(std::countr_one(answered));
  if (asked >= std::size(kQuestions)) return;
  const Question& question = kQuestions[asked];
  if (report[kQuestion] != question.number) return;
  const bool done = (report[kAcknowledged] & 0x80) != 0;
  if (done && question.number == kReadFlash) {
    if (!std::equal(question.with.begin(), question.with.end(), report.begin() + kAnswerAt)) return;
    const auto read = report.subspan<kReadAt, 22>();
    if (asked == kMakers) {
      calibrate(left_, read.first<9>(), Side::left);
      calibrate(right_, read.subspan<9, 9>(), Side::right);
    }
    if (asked == kOwners && hid::u16_at(read, 0) == kOwnerMeasured)
      calibrate(left_, read.subspan<2, 9>(), Side::left);
    if (asked == kOwners && hid::u16_at(read, 11) == kOwnerMeasured)
      calibrate(right_, read.subspan<13, 9>(), Side::right);
  }
  answered_ |= 1U << asked;
}

std::size_t JoyConProtocol::begin(std::uint8_t number, Report& report) noexcept {
  report[0] = number;
  report[1] = count_;
  count_ = (count_ + 1) & 0x0F;
  std::ranges::copy(actuators_, report.begin() + 2);
  return 2 + actuators_.size();
}

std::size_t JoyConProtocol::encode(const ChannelDrives& drives, Report& report) noexcept {
  std::ranges::copy(rumble_of(carrier_Hz_, drives[0]), actuators_.begin());
  std::ranges::copy(rumble_of(carrier_Hz_, drives[1]), actuators_.begin() + 4);
  return begin(kVibrate, report);
}

// Every other turn: the answer has time to come, and the channels have theirs.
std::size_t JoyConProtocol::ask(Report& report) noexcept {
  const std::uint32_t answered = answered_;
  if (answered == kAllAnswered || std::exchange(asked_, !asked_)) return 0;
  const Question& question = kQuestions[std::countr_one(answered)];
  const std::size_t at = begin(kAsk, report);
  report[at] = question.number;
  std::copy_n(question.with.begin(), question.length, report.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  return at + 1 + question.length;
}

std::span<const hid::HidId> pair_ids() {
  static constexpr hid::HidId all[] = {{0x057e, 0x2006}, {0x057e, 0x2007}};
  return all;
}

std::span<const hid::HidId> ids(Side side) {
  static constexpr hid::HidId pro[] = {{0x057e, 0x2009}};
  if (side == Side::both) return pro;
  return pair_ids().subspan(side == Side::left ? 0 : 1, 1);
}

}  // namespace fulcrum::joycon
