#pragma once
// A learning record store in this process, at http(s)://localhost:PORT/xapi. It keeps statements as the
// Experience API 1.0.3, part three, asks, refuses what xapi_rules.h does, and misbehaves as it is told.

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/session/certificate.h"
#include "tests/session/stand_in_connection.h"

namespace fulcrum::test {

// How a request goes wrong.
enum class Trouble {
  status,                // it is answered with State::status and nothing is done
  closes,                // no answer, and nothing is done
  closes_after_storing,  // no answer
  holds,                 // no answer, and the connection stays until the client ends it
  drips,                 // the right answer, byte by byte
  huge_body,             // that status, and a body without an end
  huge_head,             // headers without an end
  torn_body,             // that status, and less of the body than was promised
  garbage,               // no HTTP
};

class StandInRecordStore {
public:
  struct State {
    std::string user = "teacher", password = "secret: of 3 words";
    std::map<std::string, std::string> statements{};  // by id
    bool conflicts = false;  // says 409 to a statement that it has, though it is the same
    bool shows = true;       // to who asks for a statement
    int troubles = 0;        // requests that will go wrong; below 0: all
    Trouble trouble = Trouble::status;
    std::string troubled = "PUT";  // which requests
    int status = 500;
    std::string header{}, body{};  // of that status; the header with its end of line
    int puts = 0, gets = 0;        // that came
    // Of each statement that is new, from the store's thread.
    std::function<void(const std::string& statement)> accepted{};
    std::vector<std::string> wrong{};  // what clients did wrong, by our rules
  };

  // Nothing: plain. newest_tls: as OpenSSL has it; 0: any.
  explicit StandInRecordStore(const std::optional<Certificate>& certificate = std::nullopt,
                              int newest_tls = 0);
  ~StandInRecordStore();
  StandInRecordStore(const StandInRecordStore&) = delete;
  StandInRecordStore& operator=(const StandInRecordStore&) = delete;

  int port() const { return port_; }
  std::string address(const std::string& host = "localhost") const;

  void set(auto change) {
    const std::lock_guard lock(mutex_);
    change(state_);
  }
  template <class See>
  auto see(See what) {
    const std::lock_guard lock(mutex_);
    return what(state_);
  }

private:
  struct EndContext {
    void operator()(SSL_CTX* context) const { SSL_CTX_free(context); }
  };
  void serve();
  void talk(StandInConnection& client);
  bool answer(StandInConnection& client, const HttpRequest& request);
  bool make_trouble(StandInConnection& client, const HttpRequest& request, Trouble trouble);
  std::string reply_to(const HttpRequest& request);
  std::string put(const HttpRequest& request, const std::string& id);
  std::string refuse(const std::string& why);

  std::mutex mutex_;
  State state_;
  bool ends_ = false;
  int listener_ = -1, client_ = -1, port_ = 0;
  std::unique_ptr<SSL_CTX, EndContext> tls_;
  std::thread thread_;
};

}  // namespace fulcrum::test
