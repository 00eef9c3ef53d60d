#pragma once
// A port of this machine where a test answers by hand what no websocket library would say. One connection at
// a time; one that asks nothing, as a knock does, is passed over.

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace fulcrum::stand_in {

class RawListener {
public:
  // asked: of a client, up to the empty line; what it returns is sent at once.
  using Answer = std::function<std::string(const std::string& asked)>;

  explicit RawListener(Answer answer);
  ~RawListener();
  RawListener(const RawListener&) = delete;
  RawListener& operator=(const RawListener&) = delete;

  int port() const { return port_; }
  // To the client that was answered last, in one piece. False: there is none.
  bool say(const std::string& bytes);

private:
  void listen_on();

  Answer answer_;
  int listener_ = -1, port_ = 0;
  int ends_[2] = {-1, -1};  // a pipe; whoever closes its one end ends the thread
  std::atomic<int> client_{-1};
  std::thread thread_;
};

// What a websocket's server answers to that.
std::string agreement_to(const std::string& asked);

}  // namespace fulcrum::stand_in
