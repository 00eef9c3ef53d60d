#pragma once
// A learning record store, which keeps statements of what people have done (Experience API 1.0.3, part
// three). A statement is put under an id of its own: sent again, it is there once.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/session/web_client.h"
#include "haptics/math/result.h"

namespace fulcrum::session {

// What has become of one statement.
struct PutOutcome {
  enum class Kind {
    stored,
    already_there,  // it was stored before
    refused,        // it is not wanted, and never will be; others may be
    try_again,      // the store is away or unwell: later, this one and all others
    stopped,        // it may have been stored or not: sent again, it does no harm
  };
  Kind kind = Kind::try_again;
  std::string why{};  // a sentence, of refused and try_again
};

// How long a put() tries.
struct Patience {
  int attempts = 4;
  std::chrono::milliseconds first_wait{500};  // doubled after each
  std::chrono::milliseconds connect{10'000};
  std::chrono::milliseconds reply{30'000};
};

class RecordStore {
public:
  // url: the store's address, to which /statements is added. https, or http to this machine alone: anywhere
  // else credentials and results would be there for all to read. certificates: PEM, whom to trust in place of
  // whom the system trusts. Nothing is sent yet.
  static Result<RecordStore> open(const std::string& url, const std::filesystem::path& credentials,
                                  const std::optional<std::filesystem::path>& certificates = std::nullopt,
                                  const Patience& patience = {});

  // uuid: the statement's own id. Errors are about the store, and hold for every other statement as well: it
  // is somebody else, the credentials are not its own, it is no such store.
  Result<PutOutcome> put(const std::string& uuid, const std::string& statement_json, const Stop& stop = {});

  const std::string& address() const { return client_.address().text; }

private:
  struct Answer;
  RecordStore(WebClient client, std::filesystem::path credentials, const Patience& patience);
  Answer put_once(const std::string& uuid, const std::string& statement_json, const Stop& stop);
  Answer look_for(const std::string& uuid, const Reply& put, const Stop& stop);
  Answer answer_to(const std::string& uuid, const Reply& reply) const;
  Answer answer_to(const Silence& silence) const;

  WebClient client_;
  std::filesystem::path credentials_;
  Patience patience_;
};

}  // namespace fulcrum::session
