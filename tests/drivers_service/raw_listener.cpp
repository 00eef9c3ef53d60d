#include "tests/drivers_service/raw_listener.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <libwebsockets.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace fulcrum::stand_in {
namespace {

const std::string kEndOfAsking = "\r\n\r\n";

// Empty: the other side has gone, or `ends` has, before it was asked for anything.
std::string asked_at(int client, int ends) {
  std::string asked;
  while (!asked.ends_with(kEndOfAsking)) {
    pollfd ready[] = {{client, POLLIN, 0}, {ends, POLLIN, 0}};
    poll(ready, 2, -1);
    if (ready[1].revents != 0) return {};
    char piece[4096];
    const ssize_t length = recv(client, piece, sizeof piece, 0);
    if (length <= 0) return {};
    asked.append(piece, static_cast<std::size_t>(length));
  }
  return asked;
}

}  // namespace

RawListener::RawListener(Answer answer) : answer_(std::move(answer)) {
  listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const bool listens = bind(listener_, any, size) == 0 && listen(listener_, 8) == 0 &&
                       getsockname(listener_, any, &size) == 0 && pipe(ends_) == 0;
  if (!listens) {
    ADD_FAILURE() << "no port can be listened at";
    return;
  }
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { listen_on(); });
}

RawListener::~RawListener() {
  close(ends_[1]);
  if (thread_.joinable()) thread_.join();
  for (const int file : {ends_[0], listener_, client_.load()})
    if (file >= 0) close(file);
}

void RawListener::listen_on() {
  for (;;) {
    pollfd ready[] = {{listener_, POLLIN, 0}, {ends_[0], POLLIN, 0}};
    poll(ready, 2, -1);
    if (ready[1].revents != 0) return;
    const int client = accept(listener_, nullptr, nullptr);
    const std::string asked = client >= 0 ? asked_at(client, ends_[0]) : std::string();
    if (asked.empty()) {
      if (client >= 0) close(client);
      continue;
    }
    const int before = client_.exchange(client);
    if (before >= 0) close(before);
    say(answer_(asked));
  }
}

bool RawListener::say(const std::string& bytes) {
  return send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

// RFC 6455, 4.2.2: the key with a text of its own, by SHA-1, in base 64.
std::string agreement_to(const std::string& asked) {
  std::string lower(asked);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::string name = "sec-websocket-key:";
  const std::size_t at = asked.find_first_not_of(' ', lower.find(name) + name.size());
  const std::string key =
      asked.substr(at, asked.find('\r', at) - at) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
  unsigned char digest[20];
  char text[40];
  lws_SHA1(reinterpret_cast<const unsigned char*>(key.data()), key.size(), digest);
  lws_b64_encode_string(reinterpret_cast<const char*>(digest), sizeof digest, text, sizeof text);
  return std::string("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n") +
         "Sec-WebSocket-Accept: " + text + kEndOfAsking;
}

}  // namespace fulcrum::stand_in
