#pragma once
// An Inverse3 by its maker's service, which runs on this machine and answers each message with where the
// handle is. A force is good for one message: the service lets it go where no other follows, and with the
// connection. How soon it does is not in its manual.

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "drivers/force/force_bus.h"
#include "drivers/inverse3/local_websocket.h"
#include "drivers/inverse3/service_messages.h"
#include "haptics/loop/age_clock.h"

namespace fulcrum::inverse3 {

inline constexpr int kServicePort = 10001;  // of the service's versions since 3.1

// Why none can be opened now; empty: one is there. Takes a sixth of a second at most.
std::string why_no_inverse3(int port = kServicePort);

class Inverse3Bus final : public ForceBus {
public:
  // The arm and the handle that a run goes on with, by their names; none: it has none yet.
  using Own = std::optional<Chosen>;
  // Errors: there is no service, or it has no such device.
  static Result<std::unique_ptr<Inverse3Bus>> open(Own& own, int port = kServicePort);

  Turn exchange(const DeviceCommand& command, DeviceSample& sample) override;
  std::string trouble() const override;

private:
  using Clock = AgeClock;

  Inverse3Bus(std::unique_ptr<LocalWebSocket> service, Chosen chosen, const ServiceSays& first)
      : service_(std::move(service)), chosen_(std::move(chosen)), since_3_5_(first.since_3_5), says_(first) {}
  bool told(const DeviceCommand& command);

  std::unique_ptr<LocalWebSocket> service_;
  Chosen chosen_;
  bool since_3_5_;
  Clock::time_point due_{};                   // of the next turn
  std::deque<Clock::time_point> unanswered_;  // when each was sent, the oldest first
  int late_ = 0;      // turns in a row in which an answer was late though answers came
  ServiceSays says_;  // the last
};

}  // namespace fulcrum::inverse3
