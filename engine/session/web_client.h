#pragma once
// Requests to one server on the web and its answers, by libcurl. Used by one thread at a time.
//
// TLS is 1.2 or later, and who has no certificate for the host's name gets no byte of ours. Nobody sends us
// elsewhere, and no proxy sees what is not encrypted.

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "engine/session/credentials.h"
#include "engine/session/web_address.h"

namespace fulcrum::session {

struct Reply {
  long status = 0;
  std::string body{};      // 64 KiB of it at most
  std::string location{};  // where it would send us
  std::int64_t retry_after_s = 0;
};

// There was no reply.
struct Silence {
  enum class Why { unreachable, untrusted, babble, stopped };
  Why why = Why::unreachable;  // untrusted: its certificate; babble: what came is no HTTP
  std::string detail{};        // a clause of libcurl's
};

// Asked ten times a second or more often; true ends what is going on. Empty: nothing does.
using Stop = std::function<bool()>;

class WebClient {
public:
  struct Desc {
    WebAddress address{};
    Credentials credentials{};
    std::string certificates{};            // PEM, whom to trust; empty: whom the system trusts
    std::chrono::milliseconds connect{0};  // at most, for a connection
    std::chrono::milliseconds reply{0};    // at most, for all of a request
  };

  explicit WebClient(Desc desc);
  WebClient(WebClient&&) noexcept;
  WebClient& operator=(WebClient&&) noexcept;
  ~WebClient();

  const WebAddress& address() const { return desc_.address; }

  // resource: what follows the address, from its slash on.
  std::variant<Reply, Silence> get(const std::string& resource, const Stop& stop);
  std::variant<Reply, Silence> put_json(const std::string& resource, const std::string& json,
                                        const Stop& stop);

private:
  struct Connections;
  std::variant<Reply, Silence> send(const std::string& resource, const std::string* json, const Stop& stop);

  Desc desc_;
  std::unique_ptr<Connections> connections_;  // kept from one request to the next
};

}  // namespace fulcrum::session
