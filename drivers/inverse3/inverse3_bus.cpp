#include "drivers/inverse3/inverse3_bus.h"

#include <algorithm>
#include <optional>
#include <thread>

namespace fulcrum::inverse3 {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kServiceTurn{1};
constexpr milliseconds kAnswer{5};                 // that a turn waits for
constexpr milliseconds kSilence{500};              // after which the connection is given up and made anew
constexpr milliseconds kLook{50}, kOpening{1000};  // for the connection, and as long for its first message
constexpr int kMostAnswers = 64;                   // that are read in a turn
// An answer that never comes would make every later pose look older than it is. So many turns in a row with
// one as late as this, and the connection is made anew.
constexpr milliseconds kLate{20};
constexpr int kMostLate = 100;

// D's origin in S: the middle of the workspace, where the manual's own examples lead the handle.
const Vec3 kMiddle_S{0, -0.12, 0.15};

// From S to D, which has x right, y up, z toward the person; and back.
Vec3 ours(const Vec3& v) {
  return {v.x(), v.z(), -v.y()};
}
Vec3 theirs(const Vec3& v) {
  return {v.x(), -v.z(), v.y()};
}
// The handle's axes are turned as the frame is, so that unturned they are D's.
Quat ours(const Quat& q) {
  const Vec3 axis = ours(Vec3(q.vec()));
  return {q.w(), axis.x(), axis.y(), axis.z()};
}

std::string trouble_of(const ServiceSays& says, bool has_handle) {
  if (!says.powered) return "it has no power: plug in its power supply, and switch it on.";
  if (!says.calibrated)
    return "it is not calibrated: put its handle into the inkwell of its base until its light says that it "
           "is done.";
  if (has_handle && !says.q_SH)
    return "its VerseGrip does not say how it is turned: wake it by moving it, or charge it.";
  return {};
}

struct Opened {
  std::unique_ptr<LocalWebSocket> service;
  ServiceSays first;
};

// chosen: none takes the first. wait: for each of two steps.
Result<Opened> connected(int port, milliseconds wait, const std::optional<Chosen>& chosen) {
  Result<std::unique_ptr<LocalWebSocket>> service = LocalWebSocket::connect(port, kMostBytes, wait);
  if (!service)
    return Error{
        "its maker's service does not run here (" + service.error().sentence +
        "): start Haply Hub, or install it; it brings the service, of which 3.1 or newer is needed."};
  std::string message;
  if ((*service)->hear(message, wait) != LocalWebSocket::Heard::message)
    return Error{"its maker's service says nothing: start Haply Hub again."};
  const std::optional<ServiceSays> first = decode(message, chosen);
  if (!first)
    return Error{
        "what its maker's service says is not understood: install a version of Haply Hub from 3.1 to 3.5."};
  if (first->of.arm.empty())
    return Error{"its maker's service runs, and none is plugged in: plug one in, and switch it on."};
  if (!first->unusable.empty()) return Error{first->unusable};
  return Opened{std::move(*service), *first};
}

}  // namespace

std::string why_no_inverse3(int port) {
  const Result<Opened> opened = connected(port, kLook, std::nullopt);
  return opened ? "" : opened.error().sentence;
}

Result<std::unique_ptr<Inverse3Bus>> Inverse3Bus::open(Own& own, int port) {
  Result<Opened> opened = connected(port, kOpening, own);
  if (!opened) return opened.error();
  if (!own) own = opened->first.of;
  return std::unique_ptr<Inverse3Bus>(new Inverse3Bus(std::move(opened->service), *own, opened->first));
}

bool Inverse3Bus::told(const DeviceCommand& command) {
  unanswered_.push_back(Clock::now());
  return service_->send(encode_force(chosen_.arm, theirs(command.F_H_D.force), since_3_5_));
}

// An answer follows each message, in their order. So the pose is at most as old as the message that it
// answers, wherever the answer was held up, be it in this process.
ForceBus::Turn Inverse3Bus::exchange(const DeviceCommand& command, DeviceSample& sample) {
  std::this_thread::sleep_until(due_);
  due_ = std::max(due_ + kServiceTurn, Clock::now());
  if (!told(command)) return Turn::lost;  // what cannot be told to rest is not to be pushed with
  std::string message;
  std::optional<ServiceSays> says;
  Clock::time_point asked = Clock::now();
  milliseconds wait = kAnswer;
  int count = 0;
  for (; count < kMostAnswers; ++count) {
    const LocalWebSocket::Heard heard = service_->hear(message, wait);
    if (heard == LocalWebSocket::Heard::gone) return Turn::lost;
    if (heard == LocalWebSocket::Heard::nothing) break;
    wait = milliseconds(0);
    if (!unanswered_.empty()) {
      asked = unanswered_.front();
      unanswered_.pop_front();
    }
    says = decode(message, chosen_);
  }
  const Clock::duration late =
      unanswered_.empty() ? Clock::duration::zero() : Clock::now() - unanswered_.front();
  late_ = late > kLate && says ? late_ + 1 : 0;
  if (late > kSilence || late_ > kMostLate) return Turn::lost;
  if (!says || count == kMostAnswers) return Turn::none;  // of so many the newest is none
  if (says->of.arm.empty()) return Turn::lost;
  says_ = *says;
  if (!trouble().empty()) return Turn::none;
  sample.X_DH.p = ours(says->p_SH - kMiddle_S);
  if (says->q_SH) sample.X_DH.q = ours(*says->q_SH);  // what does not tell its turn keeps the one that it had
  sample.age = std::chrono::duration<double>(Clock::now() - asked).count();
  sample.buttons = says->buttons;
  return Turn::fresh;
}

std::string Inverse3Bus::trouble() const {
  return trouble_of(says_, !chosen_.handle.empty());
}

}  // namespace fulcrum::inverse3
