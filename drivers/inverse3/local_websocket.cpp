#include "drivers/inverse3/local_websocket.h"

#include <arpa/inet.h>
#include <libwebsockets.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <deque>
#include <utility>
#include <vector>

namespace fulcrum::inverse3 {
namespace {

using SocketClock = std::chrono::steady_clock;

constexpr unsigned kMostSockets = 16;      // of a context: one, and those that the library wakes itself by
constexpr std::size_t kMostWaiting = 128;  // messages
constexpr std::chrono::milliseconds kSending{2};  // for a message to leave
constexpr std::chrono::milliseconds kKnock{20};   // for a port to take a connection
constexpr std::size_t kPiece_bytes = 4096;        // of a message, as it comes

void wait_for(int socket, short what, std::chrono::microseconds wait) {
  pollfd ready{socket, what, 0};
  const timespec time{wait.count() / 1'000'000, wait.count() % 1'000'000 * 1000};
  ppoll(&ready, 1, &time, nullptr);
}

// A connection that is closed at once: on this machine it comes about, or is refused, nearly without waiting.
template <class Address>
bool listens(const Address& address) {
  const auto* const any = reinterpret_cast<const sockaddr*>(&address);
  const int socket = ::socket(any->sa_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket < 0) return false;
  bool connected = ::connect(socket, any, sizeof address) == 0;
  if (!connected && errno == EINPROGRESS) {
    wait_for(socket, POLLOUT, kKnock);
    sockaddr_storage peer{};
    socklen_t length = sizeof peer;
    connected = getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &length) == 0;
  }
  close(socket);
  return connected;
}

// Of those that are this machine's own, the one where somebody listens; null: nobody.
const char* loopback_of(int port) {
  sockaddr_in v4{};
  v4.sin_family = AF_INET;
  v4.sin_port = htons(static_cast<std::uint16_t>(port));
  v4.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (listens(v4)) return "127.0.0.1";
  sockaddr_in6 v6{};
  v6.sin6_family = AF_INET6;
  v6.sin6_port = v4.sin_port;
  v6.sin6_addr = in6addr_loopback;
  return listens(v6) ? "::1" : nullptr;
}

}  // namespace

struct LocalWebSocket::Link {
  lws_context* context = nullptr;
  lws* socket = nullptr;
  std::size_t most_bytes = 0;
  bool agreed = false, gone = false;
  std::string unsent;     // empty: nothing
  std::string coming;     // of a message whose end has not come
  bool too_long = false;  // that message
  std::deque<std::string> inbox;

  ~Link() {
    if (context != nullptr) lws_context_destroy(context);
  }
  void serve() { lws_service(context, -1); }  // what is due now, without waiting
  void take(lws* from, const char* piece, std::size_t length) {
    too_long = too_long || coming.size() + length > most_bytes;
    if (!too_long) coming.append(piece, length);
    if (lws_remaining_packet_payload(from) != 0 || lws_is_final_fragment(from) == 0) return;
    gone = gone || inbox.size() >= kMostWaiting;  // nobody asked for so many
    if (gone) return;
    inbox.push_back(too_long ? std::string() : std::move(coming));
    coming.clear();
    too_long = false;
  }
  bool put(lws* to) {
    std::vector<unsigned char> bytes(LWS_PRE + unsent.size());
    std::copy(unsent.begin(), unsent.end(), bytes.begin() + LWS_PRE);
    const int written = lws_write(to, bytes.data() + LWS_PRE, unsent.size(), LWS_WRITE_TEXT);
    const bool all = written >= 0 && static_cast<std::size_t>(written) == unsent.size();
    unsent.clear();
    return all;
  }
  // As the library calls it, in serve(); other than 0 closes the connection.
  static int on_event(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t length) {
    auto* const link = static_cast<Link*>(lws_context_user(lws_get_context(socket)));
    switch (reason) {
      case LWS_CALLBACK_CLIENT_ESTABLISHED:
        link->agreed = true;
        return 0;
      case LWS_CALLBACK_CLIENT_RECEIVE:
        link->take(socket, static_cast<const char*>(in), length);
        return 0;
      case LWS_CALLBACK_CLIENT_HTTP_REDIRECT:
        return -1;  // what is asked stays on this machine
      case LWS_CALLBACK_CLIENT_WRITEABLE:
        return link->unsent.empty() || link->put(socket) ? 0 : -1;
      case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
      case LWS_CALLBACK_CLIENT_CLOSED:
        link->gone = true;
        return 0;
      default:
        return 0;
    }
  }
  void open(const char* address, int port);
};

void LocalWebSocket::Link::open(const char* address, int port) {
  static const lws_protocols kProtocols[] = {{"messages", &Link::on_event, 0, kPiece_bytes, 0, nullptr, 0},
                                             {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
  lws_set_log_level(0, nullptr);  // what goes wrong is said by us
  lws_context_creation_info made{};
  made.port = CONTEXT_PORT_NO_LISTEN;
  made.protocols = kProtocols;
  made.user = this;
  made.fd_limit_per_thread = kMostSockets;
  made.http_proxy_address = "";  // none: left out, it would be taken from the environment
  context = lws_create_context(&made);
  if (context == nullptr) {
    gone = true;
    return;
  }
  lws_client_connect_info to{};
  to.context = context;
  to.address = address;
  to.port = port;
  to.path = "/";
  to.host = "localhost";
  to.ssl_connection = LCCSCF_HTTP_NO_FOLLOW_REDIRECT;
  to.local_protocol_name = kProtocols[0].name;
  to.pwsi = &socket;
  if (lws_client_connect_via_info(&to) == nullptr) gone = true;
}

LocalWebSocket::LocalWebSocket(std::unique_ptr<Link> link) : link_(std::move(link)) {}
LocalWebSocket::~LocalWebSocket() = default;

Result<std::unique_ptr<LocalWebSocket>> LocalWebSocket::connect(int port, std::size_t most_bytes,
                                                                std::chrono::milliseconds wait) {
  const auto until = SocketClock::now() + wait;
  const char* const address = loopback_of(port);
  if (address == nullptr) return Error{"nobody listens at port " + std::to_string(port)};
  auto link = std::make_unique<Link>();
  link->most_bytes = most_bytes;
  link->open(address, port);
  while (!link->agreed && !link->gone && SocketClock::now() < until) {
    link->serve();
    if (!link->agreed && !link->gone)
      wait_for(lws_get_socket_fd(link->socket), POLLIN, std::chrono::milliseconds(1));
  }
  if (!link->agreed || link->gone)
    return Error{"what listens at port " + std::to_string(port) + " does not answer as a websocket"};
  return std::unique_ptr<LocalWebSocket>(new LocalWebSocket(std::move(link)));
}

bool LocalWebSocket::send(std::string message) {
  if (link_->gone) return false;
  link_->unsent = std::move(message);
  lws_callback_on_writable(link_->socket);
  const auto until = SocketClock::now() + kSending;
  do link_->serve();  // an answer to a ping may go first
  while (!link_->unsent.empty() && !link_->gone && SocketClock::now() < until);
  return link_->unsent.empty() && !link_->gone;
}

LocalWebSocket::Heard LocalWebSocket::hear(std::string& message, std::chrono::microseconds wait) {
  const auto until = SocketClock::now() + wait;
  while (link_->inbox.empty()) {
    if (link_->gone) return Heard::gone;
    link_->serve();
    if (!link_->inbox.empty() || link_->gone) continue;
    const auto left = std::chrono::duration_cast<std::chrono::microseconds>(until - SocketClock::now());
    if (left.count() <= 0) return Heard::nothing;
    wait_for(lws_get_socket_fd(link_->socket), POLLIN, left);
  }
  message = std::move(link_->inbox.front());
  link_->inbox.pop_front();
  return Heard::message;
}

}  // namespace fulcrum::inverse3
