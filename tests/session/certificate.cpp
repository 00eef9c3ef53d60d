#include "tests/session/certificate.h"

#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>
#include <openssl/x509v3.h>

#include <memory>
#include <stdexcept>

namespace fulcrum::test {
namespace {

constexpr long kDay_s = 24 * 3600;

struct FreeAny {
  void operator()(BIO* it) const { BIO_free(it); }
  void operator()(EVP_PKEY* it) const { EVP_PKEY_free(it); }
  void operator()(X509* it) const { X509_free(it); }
  void operator()(X509_EXTENSION* it) const { X509_EXTENSION_free(it); }
};
template <class T>
using Own = std::unique_ptr<T, FreeAny>;

void need(bool good) {
  if (!good) throw std::runtime_error("OpenSSL makes no certificate");
}

std::string text_of(BIO* memory) {
  char* text = nullptr;
  const long size = BIO_get_mem_data(memory, &text);
  return {text, static_cast<std::size_t>(size)};
}

void extend(X509* certificate, int what, const std::string& value) {
  const Own<X509_EXTENSION> extension(X509V3_EXT_conf_nid(nullptr, nullptr, what, value.c_str()));
  need(extension && X509_add_ext(certificate, extension.get(), -1) == 1);
}

}  // namespace

Certificate make_certificate(const std::string& names, long valid_s) {
  const Own<EVP_PKEY> key(EVP_EC_gen("P-256"));
  const Own<X509> made(X509_new());
  need(key && made);
  X509* const certificate = made.get();
  X509_NAME* const name = X509_get_subject_name(certificate);
  const auto* const called = reinterpret_cast<const unsigned char*>("stand-in");
  need(X509_set_version(certificate, 2) == 1 &&
       ASN1_INTEGER_set(X509_get_serialNumber(certificate), 1) == 1 &&
       X509_gmtime_adj(X509_getm_notBefore(certificate), -kDay_s) != nullptr &&
       X509_gmtime_adj(X509_getm_notAfter(certificate), valid_s) != nullptr &&
       X509_set_pubkey(certificate, key.get()) == 1 &&
       X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, called, -1, -1, 0) == 1 &&
       X509_set_issuer_name(certificate, name) == 1);
  extend(certificate, NID_basic_constraints, "critical,CA:TRUE");
  extend(certificate, NID_subject_alt_name, names);
  need(X509_sign(certificate, key.get(), EVP_sha256()) > 0);
  const Own<BIO> pem(BIO_new(BIO_s_mem())), key_pem(BIO_new(BIO_s_mem()));
  need(pem && key_pem && PEM_write_bio_X509(pem.get(), certificate) == 1 &&
       PEM_write_bio_PrivateKey(key_pem.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) == 1);
  return {.pem = text_of(pem.get()), .key_pem = text_of(key_pem.get())};
}

}  // namespace fulcrum::test
