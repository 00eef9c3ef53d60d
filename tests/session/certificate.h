#pragma once
// A certificate that vouches for itself, made while the test runs.

#include <string>

namespace fulcrum::test {

struct Certificate {
  std::string pem{};
  std::string key_pem{};
};

// names: as OpenSSL has them, "DNS:localhost,IP:127.0.0.1". valid_s: from a day ago until then.
Certificate make_certificate(const std::string& names, long valid_s = 3600);

}  // namespace fulcrum::test
