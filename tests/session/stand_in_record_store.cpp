#include "tests/session/stand_in_record_store.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <openssl/pem.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "tests/session/xapi_rules.h"

namespace fulcrum::test {
namespace {

using Json = nlohmann::json;

std::string http(int status, const std::string& body, const std::string& headers = {}) {
  return "HTTP/1.1 " + std::to_string(status) + " so\r\nX-Experience-API-Version: 1.0.3\r\n" + headers +
         (status == 204 ? "" : "Content-Length: " + std::to_string(body.size()) + "\r\n") + "\r\n" + body;
}

std::string basic(const std::string& user, const std::string& password) {
  const std::string plain = user + ':' + password;
  std::string text(plain.size() * 4 / 3 + 8, '\0');
  const int size =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(plain.data()), static_cast<int>(plain.size()));
  return "Basic " + text.substr(0, static_cast<std::size_t>(size));
}

SSL_CTX* context_of(const Certificate& certificate, int newest_tls) {
  SSL_CTX* const context = SSL_CTX_new(TLS_server_method());
  BIO* const pem = BIO_new_mem_buf(certificate.pem.data(), static_cast<int>(certificate.pem.size()));
  BIO* const key_pem =
      BIO_new_mem_buf(certificate.key_pem.data(), static_cast<int>(certificate.key_pem.size()));
  X509* const own = PEM_read_bio_X509(pem, nullptr, nullptr, nullptr);
  EVP_PKEY* const key = PEM_read_bio_PrivateKey(key_pem, nullptr, nullptr, nullptr);
  const bool good = SSL_CTX_use_certificate(context, own) == 1 && SSL_CTX_use_PrivateKey(context, key) == 1;
  X509_free(own);
  EVP_PKEY_free(key);
  BIO_free(pem);
  BIO_free(key_pem);
  if (!good) throw std::runtime_error("OpenSSL does not take the certificate");
  // What old TLS needs is below what OpenSSL calls safe.
  if (newest_tls != 0) {
    SSL_CTX_set_security_level(context, 0);
    SSL_CTX_set_min_proto_version(context, 0);
    SSL_CTX_set_max_proto_version(context, newest_tls);
  }
  return context;
}

int listening_socket() {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool listens = bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
                       listen(listener, 8) == 0;
  if (!listens) throw std::runtime_error("no port can be listened at");
  return listener;
}

}  // namespace

StandInRecordStore::StandInRecordStore(const std::optional<Certificate>& certificate, int newest_tls)
    : listener_(listening_socket()) {
  if (certificate) tls_.reset(context_of(*certificate, newest_tls));
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { serve(); });
}

StandInRecordStore::~StandInRecordStore() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    shutdown(listener_, SHUT_RDWR);
    if (client_ >= 0) shutdown(client_, SHUT_RDWR);
  }
  thread_.join();
  close(listener_);
}

std::string StandInRecordStore::address(const std::string& host) const {
  return (tls_ ? "https://" : "http://") + host + ':' + std::to_string(port_) + "/xapi";
}

void StandInRecordStore::serve() {
  // OpenSSL writes to clients that are gone.
  sigset_t pipe;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
  for (;;) {
    const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    {
      const std::lock_guard lock(mutex_);
      if (!ends_) client_ = socket;
    }
    if (see([&](State&) { return ends_; })) {
      if (socket >= 0) close(socket);
      return;
    }
    if (socket < 0) continue;
    {
      StandInConnection client(socket, tls_.get());
      if (client.is_open()) talk(client);
    }
    const std::lock_guard lock(mutex_);
    close(std::exchange(client_, -1));
  }
}

void StandInRecordStore::talk(StandInConnection& client) {
  while (const auto request = client.next(listener_))
    if (!answer(client, *request)) return;
}

// False: the connection is to be closed.
bool StandInRecordStore::answer(StandInConnection& client, const HttpRequest& request) {
  std::optional<Trouble> trouble;
  set([&](State& state) {
    ++(request.method == "PUT" ? state.puts : state.gets);
    if (request.method != state.troubled || state.troubles == 0) return;
    trouble = state.trouble;
    if (state.troubles > 0) --state.troubles;
  });
  return trouble ? make_trouble(client, request, *trouble) : client.say(reply_to(request));
}

bool StandInRecordStore::make_trouble(StandInConnection& client, const HttpRequest& request,
                                      Trouble trouble) {
  const auto [status, header, body] =
      see([](State& state) { return std::tuple(state.status, state.header, state.body); });
  const std::string much(4096, 'x');
  std::string right;
  switch (trouble) {
    case Trouble::status:
      return client.say(http(status, body, header));
    case Trouble::closes:
      return false;
    case Trouble::closes_after_storing:
      reply_to(request);
      return false;
    case Trouble::holds:
      client.hear_out();
      return false;
    case Trouble::drips:
      right = reply_to(request);
      return std::ranges::all_of(right, [&](char c) { return client.say({&c, 1}); });
    case Trouble::huge_body:
      client.say("HTTP/1.1 " + std::to_string(status) + " so\r\nContent-Length: 1000000000000\r\n\r\n");
      while (client.say(much)) continue;
      return false;
    case Trouble::huge_head:
      client.say("HTTP/1.1 204 so\r\n");
      while (client.say("X-More: " + much + "\r\n")) continue;
      return false;
    case Trouble::torn_body:
      client.say("HTTP/1.1 " + std::to_string(status) + " so\r\nContent-Length: 1000\r\n\r\n" + body);
      return false;
    case Trouble::garbage:
      client.say("SSH-2.0-stand-in\r\n\r\n");
      return false;
  }
  return false;
}

std::string StandInRecordStore::refuse(const std::string& why) {
  state_.wrong.push_back(why);
  return http(400, why);
}

std::string StandInRecordStore::reply_to(const HttpRequest& request) {
  const std::lock_guard lock(mutex_);
  const auto header = [&](const char* name) {
    const auto found = request.headers.find(name);
    return found == request.headers.end() ? std::string() : found->second;
  };
  const std::string resource = "/xapi/statements?statementId=";
  if (!request.target.starts_with(resource)) return http(404, "nothing is here");
  if (header("authorization") != basic(state_.user, state_.password)) return http(401, "who are you?");
  if (header("x-experience-api-version") != "1.0.3") return refuse("no version");
  const std::string id = request.target.substr(resource.size());
  if (request.method == "PUT") return put(request, id);
  if (request.method != "GET") return http(405, "PUT and GET alone");
  const auto kept = state_.statements.find(id);
  if (kept == state_.statements.end() || !state_.shows) return http(404, "no such statement");
  Json statement = Json::parse(kept->second);
  statement["version"] = "1.0.0";
  return http(200, statement.dump());
}

std::string StandInRecordStore::put(const HttpRequest& request, const std::string& id) {
  const auto type = request.headers.find("content-type");
  if (type == request.headers.end() || type->second != "application/json")
    return refuse("no application/json");
  const std::vector<std::string> faults = xapi_faults(request.body);
  if (!faults.empty()) return refuse(faults.front());
  const Json statement = Json::parse(request.body);
  if (statement.value("id", id) != id) return refuse("the statement has another id than its address");
  const auto [kept, is_new] = state_.statements.try_emplace(id, request.body);
  if (is_new && state_.accepted) state_.accepted(request.body);
  const bool same = is_new || Json::parse(kept->second) == statement;
  return same && (is_new || !state_.conflicts) ? http(204, "") : http(409, "it is there");
}

}  // namespace fulcrum::test
