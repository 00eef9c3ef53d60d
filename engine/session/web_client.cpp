#include "engine/session/web_client.h"

#include <curl/curl.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <utility>

namespace fulcrum::session {
namespace {

constexpr std::size_t kMostOfBody = std::size_t{1} << 16;     // bytes
constexpr std::size_t kMostOfHeaders = std::size_t{1} << 16;  // bytes
constexpr int kLook_ms = 100;                                 // between two looks at whether to stop

struct EndRequest {
  void operator()(CURL* request) const { curl_easy_cleanup(request); }
};
struct FreeList {
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};

// What has come of a reply.
struct Coming {
  std::string body;
  std::size_t header_bytes = 0;
  bool cut = false;  // there was more of the body than is of use
};

// Taking less than there is ends the transfer.
std::size_t take_body(char* data, std::size_t, std::size_t count, void* to) {
  auto& coming = *static_cast<Coming*>(to);
  const std::size_t room = kMostOfBody - coming.body.size();
  coming.body.append(data, std::min(count, room));
  coming.cut = count > room;
  return std::min(count, room);
}

std::size_t take_header(char*, std::size_t, std::size_t count, void* to) {
  auto& coming = *static_cast<Coming*>(to);
  coming.header_bytes += count;
  return coming.header_bytes <= kMostOfHeaders ? count : 0;
}

Silence::Why why_of(CURLcode code) {
  switch (code) {
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
    case CURLE_SSL_INVALIDCERTSTATUS:
      return Silence::Why::untrusted;
    case CURLE_UNSUPPORTED_PROTOCOL:  // bytes that do not begin as HTTP does
    case CURLE_WEIRD_SERVER_REPLY:
    case CURLE_BAD_CONTENT_ENCODING:
    case CURLE_WRITE_ERROR:  // headers without an end
      return Silence::Why::babble;
    default:
      return Silence::Why::unreachable;
  }
}

// One request, with the options that all have.
class Request {
public:
  explicit Request(const WebClient::Desc& desc) : handle_(curl_easy_init()) {
    if (!handle_) throw std::bad_alloc();
    set(CURLOPT_ERRORBUFFER, error_.data());
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_PROTOCOLS_STR, desc.address.encrypted ? "https" : "http");
    set(CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_1_1));
    set(CURLOPT_FOLLOWLOCATION, 0L);
    // Left out, a proxy would be taken from the environment. It may tunnel what is encrypted, and no more.
    if (!desc.address.encrypted || desc.address.loopback) set(CURLOPT_PROXY, "");
    set(CURLOPT_SSLVERSION, long{CURL_SSLVERSION_TLSv1_2});
    set(CURLOPT_SSL_VERIFYPEER, 1L);
    set(CURLOPT_SSL_VERIFYHOST, 2L);
    if (!desc.certificates.empty()) trust_only(desc.certificates);
    set(CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BASIC));
    set(CURLOPT_USERNAME, desc.credentials.user.c_str());
    set(CURLOPT_PASSWORD, desc.credentials.password.c_str());
    set(CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(desc.connect.count()));
    set(CURLOPT_TIMEOUT_MS, static_cast<long>(desc.reply.count()));
    set(CURLOPT_WRITEFUNCTION, &take_body);
    set(CURLOPT_WRITEDATA, static_cast<void*>(&coming_));
    set(CURLOPT_HEADERFUNCTION, &take_header);
    set(CURLOPT_HEADERDATA, static_cast<void*>(&coming_));
  }

  void ask(const std::string& url, const std::string* json) {
    set(CURLOPT_URL, url.c_str());
    // An empty Expect: libcurl would wait for leave to send.
    for (const char* const header : {"X-Experience-API-Version: 1.0.3", "Expect:", "User-Agent: fulcrum"})
      add(header);
    if (json != nullptr) add("Content-Type: application/json");
    set(CURLOPT_HTTPHEADER, headers_.get());
    if (json == nullptr) return;
    set(CURLOPT_CUSTOMREQUEST, "PUT");
    set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(json->size()));
    set(CURLOPT_POSTFIELDS, json->c_str());
  }

  // Whether libcurl has taken every option: with one less, it would be another request.
  bool as_meant() const { return as_meant_; }
  CURL* handle() const { return handle_.get(); }
  // The system may still look for the host's name: that is not waited for.
  void abandon() { set(CURLOPT_QUICK_EXIT, 1L); }

  std::variant<Reply, Silence> outcome(CURLcode code) {
    if (code != CURLE_OK && !coming_.cut)
      return Silence{why_of(code), error_[0] != '\0' ? error_.data() : curl_easy_strerror(code)};
    Reply reply{.body = std::move(coming_.body)};
    char* location = nullptr;
    curl_off_t retry_after_s = 0;
    curl_easy_getinfo(handle(), CURLINFO_RESPONSE_CODE, &reply.status);
    curl_easy_getinfo(handle(), CURLINFO_REDIRECT_URL, &location);
    curl_easy_getinfo(handle(), CURLINFO_RETRY_AFTER, &retry_after_s);
    if (location != nullptr) reply.location = without_user(location);
    reply.retry_after_s = retry_after_s;
    return reply;
  }

private:
  template <class T>
  void set(CURLoption option, T value) {
    // In parentheses it is the function: the macro of that name checks types, and wants to know the option.
    as_meant_ = (curl_easy_setopt)(handle_.get(), option, value) == CURLE_OK && as_meant_;
  }
  void add(const char* header) {
    curl_slist* const longer = curl_slist_append(headers_.get(), header);
    if (longer == nullptr) throw std::bad_alloc();
    static_cast<void>(headers_.release());
    headers_.reset(longer);
  }
  // Without a folder of the system's beside it.
  void trust_only(const std::string& pem) {
    curl_blob blob{const_cast<char*>(pem.data()), pem.size(), CURL_BLOB_NOCOPY};
    set(CURLOPT_CAINFO_BLOB, &blob);
    set(CURLOPT_CAPATH, static_cast<const char*>(nullptr));
  }

  std::array<char, CURL_ERROR_SIZE> error_{};
  Coming coming_;
  std::unique_ptr<curl_slist, FreeList> headers_;
  std::unique_ptr<CURL, EndRequest> handle_;
  bool as_meant_ = true;
};

}  // namespace

struct WebClient::Connections {
  CURLM* multi = curl_multi_init();
  Connections() {
    if (multi == nullptr) throw std::bad_alloc();
  }
  ~Connections() { curl_multi_cleanup(multi); }
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;

  // Nothing: it was stopped.
  std::optional<CURLcode> perform(const Stop& stop) const {
    for (;;) {
      int running = 0;
      if (curl_multi_perform(multi, &running) != CURLM_OK) return CURLE_FAILED_INIT;
      if (running == 0) break;
      if (stop && stop()) return std::nullopt;
      curl_multi_poll(multi, nullptr, 0, kLook_ms, nullptr);
    }
    int left = 0;
    const CURLMsg* const message = curl_multi_info_read(multi, &left);
    return message != nullptr && message->msg == CURLMSG_DONE ? message->data.result : CURLE_FAILED_INIT;
  }
};

WebClient::WebClient(Desc desc) : desc_(std::move(desc)) {
  static const CURLcode kReady = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (kReady != CURLE_OK) throw std::bad_alloc();
  connections_ = std::make_unique<Connections>();
}
WebClient::WebClient(WebClient&&) noexcept = default;
WebClient& WebClient::operator=(WebClient&&) noexcept = default;
WebClient::~WebClient() = default;

std::variant<Reply, Silence> WebClient::get(const std::string& resource, const Stop& stop) {
  return send(resource, nullptr, stop);
}

std::variant<Reply, Silence> WebClient::put_json(const std::string& resource, const std::string& json,
                                                 const Stop& stop) {
  return send(resource, &json, stop);
}

std::variant<Reply, Silence> WebClient::send(const std::string& resource, const std::string* json,
                                             const Stop& stop) {
  Request request(desc_);
  request.ask(desc_.address.text + resource, json);
  if (!request.as_meant())
    return Silence{Silence::Why::untrusted, "this libcurl lacks what a safe connection needs"};
  if (curl_multi_add_handle(connections_->multi, request.handle()) != CURLM_OK) throw std::bad_alloc();
  const std::optional<CURLcode> code = connections_->perform(stop);
  if (!code) request.abandon();
  curl_multi_remove_handle(connections_->multi, request.handle());
  if (!code) return Silence{Silence::Why::stopped, {}};
  return request.outcome(*code);
}

}  // namespace fulcrum::session
