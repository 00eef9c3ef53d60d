#include "tests/session/stand_in_connection.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cctype>

namespace fulcrum::test {
namespace {

const std::string kEmptyLine = "\r\n\r\n";

HttpRequest parsed(const std::string& head) {
  HttpRequest request;
  const std::size_t method = head.find(' '), target = head.find(' ', method + 1);
  request.method = head.substr(0, method);
  request.target = head.substr(method + 1, target - method - 1);
  for (std::size_t at = head.find("\r\n"); at < head.size();) {
    const std::size_t begin = at + 2, end = std::min(head.find("\r\n", begin), head.size());
    const std::size_t colon = head.find(':', begin);
    std::string name = head.substr(begin, colon - begin);
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (colon < end) request.headers[name] = head.substr(colon + 2, end - colon - 2);
    at = end;
  }
  return request;
}

}  // namespace

StandInConnection::StandInConnection(int socket, SSL_CTX* tls) : socket_(socket) {
  if (tls == nullptr) return;
  tls_.reset(SSL_new(tls));
  open_ = tls_ && SSL_set_fd(tls_.get(), socket) == 1 && SSL_accept(tls_.get()) == 1;
}

// Keeps a client that has nothing to say only as long as nobody else wants in.
bool StandInConnection::waits_no_longer(int listener) const {
  if (!heard_.empty() || (tls_ && SSL_pending(tls_.get()) > 0)) return false;
  pollfd ready[] = {{socket_, POLLIN, 0}, {listener, POLLIN, 0}};
  poll(ready, 2, -1);
  return ready[0].revents == 0;
}

bool StandInConnection::more() {
  char piece[4096];
  const ssize_t length =
      tls_ ? SSL_read(tls_.get(), piece, sizeof piece) : recv(socket_, piece, sizeof piece, 0);
  if (length > 0) heard_.append(piece, static_cast<std::size_t>(length));
  return length > 0;
}

std::optional<HttpRequest> StandInConnection::next(int listener) {
  if (waits_no_longer(listener)) return std::nullopt;
  while (heard_.find(kEmptyLine) == heard_.npos)
    if (!more()) return std::nullopt;
  const std::size_t end = heard_.find(kEmptyLine);
  HttpRequest request = parsed(heard_.substr(0, end));
  const std::string& size = request.headers["content-length"];
  const std::size_t whole = end + kEmptyLine.size() + (size.empty() ? 0 : std::stoul(size));
  while (heard_.size() < whole)
    if (!more()) return std::nullopt;
  request.body = heard_.substr(end + kEmptyLine.size(), whole - end - kEmptyLine.size());
  heard_.erase(0, whole);
  return request;
}

void StandInConnection::hear_out() {
  while (more()) continue;
}

bool StandInConnection::say(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = tls_ ? SSL_write(tls_.get(), bytes.data(), static_cast<int>(bytes.size()))
                                 : send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace fulcrum::test
