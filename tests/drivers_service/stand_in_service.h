#pragma once
// Haply's service as its manual has it, for one Inverse3 and its VerseGrip that a test holds: on connection
// it tells what is plugged in, then it answers each message with where things are. A force is good for one
// message. A message that the manual does not know is counted, and has no other effect.

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

struct lws;
struct lws_context;

namespace fulcrum::stand_in {

class Service {
public:
  // What is plugged in, and how the service is. Guarded by set() and see().
  struct State {
    bool arm = true, handle = true;
    bool another_before = false;  // another Inverse3, which is listed first
    int answers = -1;             // that it still gives; below 0: to every message
    int swallowed = 0;            // messages that will never be answered
    std::string babble{};         // in place of each answer
    std::string greets{};         // in place of what is plugged in
    bool calibrated = true, powered = true;
    std::string kind = "inverse3", basis = "XYZ";
    double scale = 1;
    bool old = false;                // 3.4: no session, and a force is `values`
    double p[3] = {0, -0.12, 0.15};  // x right, y away, z up
    double q[4] = {1, 0, 0, 0};      // w x y z
    bool button = false;
    // What the service knows of its client.
    double force[3] = {0, 0, 0};
    std::uint64_t forces = 0;  // messages with one
    int misunderstood = 0, sessions = 0, opened = 0;
  };

  // port: 0 takes a free one.
  explicit Service(int port = 0);
  ~Service();  // every connection is dropped
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  int port() const { return port_; }
  void set(auto change) {
    {
      const std::lock_guard lock(mutex_);
      change(state_);
    }
    wake();
  }
  template <class See>
  auto see(See what) {
    const std::lock_guard lock(mutex_);
    return what(state_);
  }

  // The library's thread.
  void opened(lws* socket);
  void closed(lws* socket);
  void heard(lws* socket, const char* piece, std::size_t length);
  bool answer(lws* socket);
  void woken();

private:
  void wake();
  std::string says(bool whole) const;
  void take(const std::string& message);

  std::mutex mutex_;
  State state_;
  lws* client_ = nullptr;  // the newest
  std::string coming_;
  int owed_ = 0;  // answers
  bool greet_ = false;
  lws_context* context_ = nullptr;
  int port_ = 0;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace fulcrum::stand_in
