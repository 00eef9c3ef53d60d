#pragma once
// A websocket to a program on this machine, as messages. Only the loopback addresses are ever asked, as
// numbers: no name is looked up, and no proxy is heeded. Used by one thread at a time.

#include <chrono>
#include <memory>
#include <string>

#include "haptics/math/result.h"

namespace fulcrum::inverse3 {

class LocalWebSocket {
public:
  // wait: for the other side to agree, at most. Errors: nobody listens at that port, or who listens does not
  // speak it. most_bytes: of a message that comes; a longer one comes as an empty one.
  static Result<std::unique_ptr<LocalWebSocket>> connect(int port, std::size_t most_bytes,
                                                         std::chrono::milliseconds wait);
  ~LocalWebSocket();
  LocalWebSocket(const LocalWebSocket&) = delete;
  LocalWebSocket& operator=(const LocalWebSocket&) = delete;

  // False: the system did not take it, and nothing more is to be sent.
  bool send(std::string message);
  enum class Heard { message, nothing, gone };
  // The next message, in the order in which they came; waits for one.
  Heard hear(std::string& message, std::chrono::microseconds wait);

private:
  struct Link;
  explicit LocalWebSocket(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace fulcrum::inverse3
