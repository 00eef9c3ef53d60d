// fulcrum_stand_in_record_store [--tls DIR] [--fail N] FILE
//
// A learning record store for scripts. It prints its port, appends each new statement to FILE, a line each,
// and ends at the end of its input, so that it never outlives the script:
//
//   coproc store { fulcrum_stand_in_record_store FILE; }
//   read -r port <&"${store[0]}"
//
// Then it is at http://localhost:$port/xapi. Who pushes is `teacher`, with the password `secret: of 3 words`.
//   --tls DIR  https, with a certificate for localhost that is put into DIR/certificate.pem
//   --fail N   the first N statements are answered with 503

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>

#include "tests/session/stand_in_record_store.h"

namespace {

struct RecordStoreOptions {
  std::string tls{}, file{};
  int fail = 0;
};

RecordStoreOptions options_of(int count, char** words) {
  RecordStoreOptions options;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const bool has_value = i + 1 < count;
    if (word == "--tls" && has_value)
      options.tls = words[++i];
    else if (word == "--fail" && has_value)
      options.fail = std::atoi(words[++i]);
    else
      options.file = word;
  }
  return options;
}

}  // namespace

int main(int count, char** words) {
  using namespace fulcrum::test;
  const RecordStoreOptions options = options_of(count, words);
  std::ofstream file(options.file, std::ios::app);
  if (!file) {
    std::cerr << "fulcrum_stand_in_record_store [--tls DIR] [--fail N] FILE\n";
    return 2;
  }
  std::optional<Certificate> certificate;
  if (!options.tls.empty()) {
    certificate = make_certificate("DNS:localhost,IP:127.0.0.1");
    std::ofstream(options.tls + "/certificate.pem") << certificate->pem;
  }
  StandInRecordStore store(certificate);
  store.set([&](auto& state) {
    state.accepted = [&](const std::string& statement) { file << statement << std::endl; };
    state.troubles = options.fail;
    state.status = 503;
  });
  std::cout << store.port() << std::endl;
  for (std::string line; std::getline(std::cin, line);) continue;
  return 0;
}
