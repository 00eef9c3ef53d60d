#pragma once
// A client's connection to the stand-in of a learning record store: HTTP/1.1, plain or by TLS.

#include <openssl/ssl.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::test {

struct HttpRequest {
  std::string method{}, target{};
  std::map<std::string, std::string> headers{};  // their names in small letters
  std::string body{};
};

class StandInConnection {
public:
  // tls: null, or the server's. The socket stays the caller's.
  StandInConnection(int socket, SSL_CTX* tls);

  bool is_open() const { return open_; }  // TLS was agreed on
  // Waits for what comes next. Nothing: the client is gone, or says nothing while another knocks at
  // `listener`.
  std::optional<HttpRequest> next(int listener);
  // False: the client is gone.
  bool say(std::string_view bytes);
  // Until the client ends the connection.
  void hear_out();

private:
  struct EndTls {
    void operator()(SSL* tls) const { SSL_free(tls); }
  };
  bool waits_no_longer(int listener) const;
  bool more();  // of what the client says

  int socket_;
  std::unique_ptr<SSL, EndTls> tls_;
  bool open_ = true;
  std::string heard_;
};

}  // namespace fulcrum::test
