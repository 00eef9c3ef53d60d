#include "engine/session/web_address.h"

#include <curl/curl.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string_view>

namespace fulcrum::session {
namespace {

constexpr std::size_t kLongestAddress = 2000;  // bytes

struct FreeUrl {
  void operator()(CURLU* url) const { curl_url_cleanup(url); }
};
using Url = std::unique_ptr<CURLU, FreeUrl>;

// Empty: there is none.
std::string part_of(const Url& url, CURLUPart part) {
  char* text = nullptr;
  if (curl_url_get(url.get(), part, &text, 0) != CURLUE_OK) return {};
  std::string copy = text;
  curl_free(text);
  return copy;
}

bool is_hex_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

bool escapes_are_whole(std::string_view text) {
  for (std::size_t at = text.find('%'); at != text.npos; at = text.find('%', at + 1))
    if (at + 2 >= text.size() || !is_hex_digit(text[at + 1]) || !is_hex_digit(text[at + 2])) return false;
  return true;
}

// Empty: each of its bytes may be there.
std::string wrong_bytes(std::string_view typed) {
  const auto is_foreign = [](char c) {
    return c <= ' ' || c > '~' || std::string_view("\"<>\\^`{|}").find(c) != std::string_view::npos;
  };
  if (typed.empty() || typed.size() > kLongestAddress)
    return "it must have 1 to " + std::to_string(kLongestAddress) + " characters";
  if (std::ranges::any_of(typed, is_foreign) || !escapes_are_whole(typed))
    return "it has characters that no address has; write them as %XX, and a host of other letters as xn--...";
  if (typed.find_first_of("?#") != typed.npos) return "it has a '?' or a '#'; leave out what begins there";
  return {};
}

}  // namespace

// The parser is the one that connects later: no address means one host here and another there.
Result<WebAddress> web_address(const std::string& typed) {
  if (const std::string wrong = wrong_bytes(typed); !wrong.empty()) return Error{wrong};
  // libcurl would take one slash or three as well.
  const std::size_t host_at = typed.find("://") + 3;
  const Error unformed{"it is not in the form https://HOST/PATH"};
  if (host_at < 3 || host_at >= typed.size() || typed[host_at] == '/') return unformed;
  const Url url(curl_url());
  if (!url) throw std::bad_alloc();
  const CURLUcode fault = curl_url_set(url.get(), CURLUPART_URL, typed.c_str(), CURLU_DISALLOW_USER);
  if (fault == CURLUE_USER_NOT_ALLOWED)
    return Error{"it names a user; leave that out, since who you are belongs into the file of credentials"};
  const std::string scheme = part_of(url, CURLUPART_SCHEME);
  std::string host = part_of(url, CURLUPART_HOST);
  std::ranges::transform(host, host.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (fault != CURLUE_OK || (scheme != "https" && scheme != "http") || host.empty() ||
      !part_of(url, CURLUPART_ZONEID).empty())
    return unformed;
  std::string text = part_of(url, CURLUPART_URL);
  while (text.ends_with('/')) text.pop_back();
  const bool loopback = host == "localhost" || host == "127.0.0.1" || host == "[::1]";
  return WebAddress{.text = std::move(text), .encrypted = scheme == "https", .loopback = loopback};
}

std::string without_user(const char* address) {
  const Url url(curl_url());
  if (!url) throw std::bad_alloc();
  if (curl_url_set(url.get(), CURLUPART_URL, address, 0) != CURLUE_OK ||
      curl_url_set(url.get(), CURLUPART_USER, nullptr, 0) != CURLUE_OK ||
      curl_url_set(url.get(), CURLUPART_PASSWORD, nullptr, 0) != CURLUE_OK)
    return {};
  return part_of(url, CURLUPART_URL);
}

}  // namespace fulcrum::session
