#include "engine/assets/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <new>
#include <vector>

namespace fulcrum {

struct Sha256::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  State() {
    if (context == nullptr) throw std::bad_alloc();
  }
  ~State() { EVP_MD_CTX_free(context); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  // SHA-256 is part of every OpenSSL build; what can fail here is memory.
  void start() {
    if (EVP_DigestInit_ex(context, EVP_sha256(), nullptr) != 1) throw std::bad_alloc();
  }
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
  state_->start();
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::update(std::span<const std::byte> bytes) {
  EVP_DigestUpdate(state_->context, bytes.data(), bytes.size());
}

std::string Sha256::finish_hex() {
  std::array<unsigned char, 32> digest{};
  EVP_DigestFinal_ex(state_->context, digest.data(), nullptr);
  state_->start();
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string hex;
  for (const unsigned char byte : digest) {
    hex += kDigits[byte >> 4];
    hex += kDigits[byte & 15u];
  }
  return hex;
}

std::string sha256_hex(std::span<const std::byte> bytes) {
  Sha256 hasher;
  hasher.update(bytes);
  return hasher.finish_hex();
}

Result<std::string> sha256_hex(RegularFile file) {
  Sha256 hasher;
  std::vector<char> buffer(1 << 16);
  for (;;) {
    const Result<std::size_t> got = file.read_on(buffer.data(), buffer.size());
    if (!got) return got.error();
    if (*got == 0) return hasher.finish_hex();
    hasher.update(std::as_bytes(std::span(buffer).first(*got)));
  }
}

}  // namespace fulcrum
