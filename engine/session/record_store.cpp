#include "engine/session/record_store.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "engine/files/file_error.h"
#include "engine/files/plain_text.h"
#include "engine/files/regular_file.h"

namespace fulcrum::session {
namespace {

using PutClock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::uint64_t kMostCertificates = std::uint64_t{1} << 24;  // bytes; all that Debian trusts has 2^18
constexpr std::size_t kMostQuoted = 200;                             // bytes of what a server says
constexpr milliseconds kPutLook{50};                                 // between two looks at whether to stop
constexpr milliseconds kLongestWait{10'000};  // who asks for more is left for another time

// RFC 4122, 3: what the address of a statement may hold.
bool has_uuid_form(std::string_view text) {
  constexpr std::string_view kForm = "xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx";
  return std::ranges::equal(
      text, kForm, [](unsigned char c, char form) { return form == '-' ? c == '-' : std::isxdigit(c) != 0; });
}

bool same_uuid(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool is_statement_of(const std::string& body, const std::string& uuid) {
  const auto statement = nlohmann::json::parse(body, nullptr, false);
  if (!statement.is_object()) return false;
  const auto id = statement.find("id");
  return id != statement.end() && id->is_string() && same_uuid(id->get_ref<const std::string&>(), uuid);
}

std::string statement_of(const std::string& uuid) {
  return "/statements?statementId=" + uuid;
}

// "503", or "503: out of space".
std::string said_by(const Reply& reply) {
  const std::string number = std::to_string(reply.status);
  return reply.body.empty() ? number : number + ": " + short_text(reply.body, kMostQuoted);
}

bool is_passing(long status) {
  return status == 408 || status == 425 || status == 429 || (status >= 500 && status <= 599);
}

// Of the one statement, and not of what asks.
bool is_about_statement(long status) {
  return status == 400 || status == 409 || status == 412 || status == 413 || status == 422;
}

// False: it was stopped.
bool waited_to_put(milliseconds wait, const Stop& stop) {
  const auto until = PutClock::now() + wait;
  for (auto now = PutClock::now(); now < until; now = PutClock::now()) {
    if (stop && stop()) return false;
    std::this_thread::sleep_for(std::min<PutClock::duration>(until - now, kPutLook));
  }
  return true;
}

Result<std::string> read_certificates(const std::filesystem::path& path) {
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return read_error(path, file.error());
  Result<std::string> bytes = file->first_bytes(kMostCertificates + 1);
  if (!bytes) return read_error(path, bytes.error());
  if (bytes->size() > kMostCertificates || bytes->find("-----BEGIN CERTIFICATE-----") == std::string::npos)
    return Error{
        "There is no certificate in " + plain_text(path.string()) +
        ". Give a file of certificates in the form PEM, as the learning record store's keeper has it."};
  return bytes;
}

}  // namespace

struct RecordStore::Answer {
  Result<PutOutcome> outcome;
  bool again = false;     // the same may end otherwise in a moment
  milliseconds asked{0};  // how long the store wants to be left alone
};

RecordStore::RecordStore(WebClient client, std::filesystem::path credentials, const Patience& patience)
    : client_(std::move(client)), credentials_(std::move(credentials)), patience_(patience) {}

Result<RecordStore> RecordStore::open(const std::string& url, const std::filesystem::path& credentials,
                                      const std::optional<std::filesystem::path>& certificates,
                                      const Patience& patience) {
  const Result<WebAddress> address = web_address(url);
  if (!address)
    return Error{"The address of the learning record store is refused: " + address.error().sentence + "."};
  if (!address->encrypted && !address->loopback)
    return Error{
        "The learning record store at " + address->text +
        " would be told credentials and results for all on the way to read. Use its https address; http "
        "is for this machine alone (http://localhost)."};
  const Result<Credentials> who = read_credentials(credentials);
  if (!who) return who.error();
  const Result<std::string> trusted = certificates ? read_certificates(*certificates) : std::string();
  if (!trusted) return trusted.error();
  return RecordStore(WebClient({.address = *address,
                                .credentials = *who,
                                .certificates = *trusted,
                                .connect = patience.connect,
                                .reply = patience.reply}),
                     credentials, patience);
}

Result<PutOutcome> RecordStore::put(const std::string& uuid, const std::string& statement_json,
                                    const Stop& stop) {
  if (!has_uuid_form(uuid))
    return PutOutcome{PutOutcome::Kind::refused, "A statement's id is not a UUID: '" +
                                                     short_text(uuid, kMostQuoted) +
                                                     "'. The results that it is from have been changed."};
  milliseconds wait = patience_.first_wait;
  for (int attempt = 1; !stop || !stop(); ++attempt) {
    Answer answer = put_once(uuid, statement_json, stop);
    if (!answer.again || attempt >= patience_.attempts || answer.asked > kLongestWait)
      return std::move(answer.outcome);
    if (!waited_to_put(std::max(wait, answer.asked), stop)) break;
    wait = std::min(wait * 2, kLongestWait);
  }
  return PutOutcome{PutOutcome::Kind::stopped};
}

RecordStore::Answer RecordStore::put_once(const std::string& uuid, const std::string& statement_json,
                                          const Stop& stop) {
  const auto heard = client_.put_json(statement_of(uuid), statement_json, stop);
  if (const auto* const silence = std::get_if<Silence>(&heard)) return answer_to(*silence);
  const Reply& reply = std::get<Reply>(heard);
  if (reply.status == 204) return {PutOutcome{PutOutcome::Kind::stored}};
  // Part three, 2.1.1: a store that has the statement may say so. Any other server may say 200, to anything.
  if (reply.status == 409 || reply.status == 412 || reply.status / 100 == 2)
    return look_for(uuid, reply, stop);
  return answer_to(uuid, reply);
}

// Whether the store has what it seems to have.
RecordStore::Answer RecordStore::look_for(const std::string& uuid, const Reply& put, const Stop& stop) {
  const auto heard = client_.get(statement_of(uuid), stop);
  if (const auto* const silence = std::get_if<Silence>(&heard)) return answer_to(*silence);
  const Reply& reply = std::get<Reply>(heard);
  const bool took_it = put.status / 100 == 2;
  if (reply.status == 200 && is_statement_of(reply.body, uuid))
    return {PutOutcome{took_it ? PutOutcome::Kind::stored : PutOutcome::Kind::already_there}};
  if (is_passing(reply.status)) return answer_to(uuid, reply);
  // It may have got it a moment ago, and show it in the next (part three, 2.1.1).
  const bool again = reply.status == 404;
  const std::string shown =
      " (" + said_by(put) + "), and does not show it (" + std::to_string(reply.status) + ")";
  if (took_it)
    return {Error{"What is at " + address() + " answers as no learning record store does" + shown +
                  ". Check the address."},
            again};
  return {
      PutOutcome{PutOutcome::Kind::refused,
                 "The learning record store at " + address() + " says that it has statement " + uuid + shown +
                     ". Have its keeper look whether it was voided, and whether the credentials may read "
                     "statements."},
      again};
}

RecordStore::Answer RecordStore::answer_to(const std::string& uuid, const Reply& reply) const {
  const std::string store = "The learning record store at " + address();
  if (is_passing(reply.status))
    return {PutOutcome{PutOutcome::Kind::try_again, store + " is busy or unwell (" + said_by(reply) +
                                                        "). Nothing is lost; push again later."},
            true, std::chrono::seconds(std::clamp<std::int64_t>(reply.retry_after_s, 0, 1'000'000))};
  if (is_about_statement(reply.status))
    return {PutOutcome{PutOutcome::Kind::refused, store + " refuses statement " + uuid + " (" +
                                                      said_by(reply) + "). Ask its keeper why."}};
  if (reply.status == 401)
    return {Error{store + " does not know the credentials (401). Check the first line of " +
                  plain_text(credentials_.string()) + ", USER:PASSWORD."}};
  if (reply.status == 403)
    return {
        Error{store +
              " does not let the credentials store statements (403). Ask its keeper for those that may write "
              "statements and read their own."}};
  if (reply.status == 404)
    return {Error{"There is no learning record store at " + address() +
                  " (404). Check the address: it ends before /statements."}};
  if (reply.status / 100 == 3)
    return {Error{address() + " sends on to '" +
                  short_text(reply.location.substr(0, reply.location.find("/statements")), kMostQuoted) +
                  "' (" + std::to_string(reply.status) +
                  "), and credentials do not go where nobody has sent them. If the store is there, give that "
                  "address."}};
  return {Error{"What is at " + address() + " does not answer as a learning record store (" + said_by(reply) +
                "). Check the address."}};
}

RecordStore::Answer RecordStore::answer_to(const Silence& silence) const {
  const std::string detail = short_text(silence.detail, kMostQuoted);
  switch (silence.why) {
    case Silence::Why::stopped:
      return {PutOutcome{PutOutcome::Kind::stopped}};
    case Silence::Why::untrusted:
      return {
          Error{"What is at " + address() + " does not prove that it is (" + detail +
                "), and was told nothing. If the store's certificate is from an authority of your own, give "
                "that authority's."}};
    case Silence::Why::babble:
      return {Error{"What is at " + address() + " does not speak HTTP (" + detail + "). Check the address."}};
    case Silence::Why::unreachable:
      break;
  }
  return {PutOutcome{PutOutcome::Kind::try_again,
                     "The learning record store at " + address() + " does not answer (" + detail +
                         "). Nothing is lost; check the network, and push again later."},
          true};
}

}  // namespace fulcrum::session
