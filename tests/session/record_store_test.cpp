#include "engine/session/record_store.h"

#include <gtest/gtest.h>
#include <openssl/ssl.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "engine/session/xapi.h"
#include "tests/files/temporary_folder.h"
#include "tests/session/example_statement.h"
#include "tests/session/stand_in_record_store.h"

namespace fulcrum::session {
namespace {

using Kind = PutOutcome::Kind;
using std::chrono::milliseconds;
using test::StandInRecordStore;
using test::Trouble;

const std::string kId = test::example_statement().uuid;
const std::string kThisMachine = "DNS:localhost,IP:127.0.0.1";

std::string example_json() {
  return statement_json(test::example_statement(), "https://school.example");
}

class RecordStoreOfStandIn : public testing::Test {
protected:
  RecordStoreOfStandIn() { write_private("who", "teacher:secret: of 3 words\n"); }

  void write_private(const std::string& name, const std::string& text) {
    folder_.write(name, text);
    EXPECT_EQ(::chmod((folder_ / name).c_str(), 0600), 0);
  }

  Result<RecordStore> open(const std::string& url,
                           const std::optional<std::string>& certificates = std::nullopt) {
    const std::optional<std::filesystem::path> trusted =
        certificates ? std::optional(folder_ / *certificates) : std::nullopt;
    return RecordStore::open(url, folder_ / "who", trusted, patience_);
  }

  // What became of the example.
  std::string put_to(const std::string& url, const std::optional<std::string>& certificates = std::nullopt,
                     const Stop& stop = {}) {
    auto store = open(url, certificates);
    return store ? put_again(*store, stop) : "not opened: " + store.error().sentence;
  }
  static std::string put_again(RecordStore& store, const Stop& stop = {}) {
    const auto outcome = store.put(kId, example_json(), stop);
    return outcome ? words(*outcome) : "error: " + outcome.error().sentence;
  }
  static std::string words(const PutOutcome& outcome) {
    constexpr const char* kWords[] = {"stored", "already there", "refused: ", "try again: ", "stopped"};
    return kWords[static_cast<int>(outcome.kind)] + outcome.why;
  }

  // With the trouble in so many requests.
  std::string put_in_trouble(StandInRecordStore& store, Trouble trouble, int requests, int status = 500,
                             const std::string& header = {}, const std::string& body = {}) {
    store.set([&](auto& state) {
      state.trouble = trouble;
      state.troubles = requests;
      state.status = status;
      state.header = header;
      state.body = body;
    });
    return put_to(store.address());
  }

  static int puts(StandInRecordStore& store) {
    return store.see([](auto& state) { return state.puts; });
  }
  static std::size_t kept(StandInRecordStore& store) {
    return store.see([](auto& state) { return state.statements.size(); });
  }

  test::TemporaryFolder folder_;
  Patience patience_{.attempts = 3, .first_wait = milliseconds(1)};
};

void expect_begins(const std::string& text, const std::string& beginning) {
  EXPECT_EQ(text.substr(0, beginning.size()), beginning) << text;
}

void expect_says(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(RecordStoreOfStandIn, KeepsAStatementOnce) {
  StandInRecordStore lrs;
  auto store = open(lrs.address());
  ASSERT_TRUE(store);
  EXPECT_EQ(put_again(*store), "stored");
  EXPECT_EQ(put_again(*store), "stored");
  lrs.set([](auto& state) { state.conflicts = true; });
  EXPECT_EQ(put_again(*store), "already there");
  EXPECT_EQ(kept(lrs), 1u);
  EXPECT_EQ(lrs.see([](auto& state) { return state.statements.at(kId); }), example_json());
  EXPECT_TRUE(lrs.see([](auto& state) { return state.wrong.empty(); }));
}

TEST_F(RecordStoreOfStandIn, IsReachedByEitherName) {
  StandInRecordStore lrs;
  EXPECT_EQ(put_to(lrs.address("127.0.0.1") + "/"), "stored");
  EXPECT_EQ(put_to(lrs.address("localhost")), "stored");
}

TEST_F(RecordStoreOfStandIn, IsAskedAgainWhileItIsUnwell) {
  for (const int status : {500, 502, 503, 504, 408, 429}) {
    StandInRecordStore lrs;
    EXPECT_EQ(put_in_trouble(lrs, Trouble::status, 2, status), "stored") << status;
    EXPECT_EQ(puts(lrs), 3);
    EXPECT_EQ(kept(lrs), 1u);
  }
}

TEST_F(RecordStoreOfStandIn, IsLeftForLaterWhenItStaysUnwell) {
  StandInRecordStore lrs;
  const std::string said = put_in_trouble(lrs, Trouble::status, -1, 503, {}, "no\x1b[2J\nroom");
  expect_begins(said, "try again: The learning record store at " + lrs.address() +
                          " is busy or unwell (503: no [2J room)");
  EXPECT_EQ(puts(lrs), 3);
  EXPECT_EQ(kept(lrs), 0u);
}

TEST_F(RecordStoreOfStandIn, MayAskForMoreTimeThanWeHave) {
  StandInRecordStore lrs;
  expect_begins(put_in_trouble(lrs, Trouble::status, -1, 503, "Retry-After: 3600\r\n"), "try again: ");
  EXPECT_EQ(puts(lrs), 1);
  StandInRecordStore other;
  EXPECT_EQ(put_in_trouble(other, Trouble::status, 1, 503, "Retry-After: -99999999999999999999\r\n"),
            "stored");
}

TEST_F(RecordStoreOfStandIn, MayCloseBeforeItAnswers) {
  StandInRecordStore lrs;
  EXPECT_EQ(put_in_trouble(lrs, Trouble::closes, 2), "stored");
  expect_begins(put_in_trouble(lrs, Trouble::closes, -1), "try again: ");
  EXPECT_EQ(kept(lrs), 1u);
}

TEST_F(RecordStoreOfStandIn, MayStoreAndNotSaySo) {
  for (const bool conflicts : {false, true}) {
    StandInRecordStore lrs;
    lrs.set([&](auto& state) { state.conflicts = conflicts; });
    EXPECT_EQ(put_in_trouble(lrs, Trouble::closes_after_storing, 1), conflicts ? "already there" : "stored");
    EXPECT_EQ(puts(lrs), 2);
    EXPECT_EQ(kept(lrs), 1u);
  }
}

TEST_F(RecordStoreOfStandIn, MayBeSlow) {
  StandInRecordStore lrs;
  EXPECT_EQ(put_in_trouble(lrs, Trouble::drips, 1), "stored");
  patience_.reply = milliseconds(50);
  expect_begins(put_in_trouble(lrs, Trouble::holds, -1), "try again: ");
}

TEST_F(RecordStoreOfStandIn, MayBeAway) {
  std::string address;
  {
    StandInRecordStore lrs;
    address = lrs.address();
  }
  const std::string said = put_to(address);
  expect_begins(said, "try again: ");
  expect_says(said, "Nothing is lost");
}

TEST_F(RecordStoreOfStandIn, ComesBackOnTheSameConnectionOrANewOne) {
  StandInRecordStore lrs;
  auto first = open(lrs.address()), second = open(lrs.address());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(put_again(*first), "stored");
    EXPECT_EQ(put_again(*second), "stored");
  }
}

TEST_F(RecordStoreOfStandIn, KnowsWhoMayWrite) {
  StandInRecordStore lrs;
  write_private("who", "teacher:guess");
  const std::string said = put_to(lrs.address());
  expect_begins(
      said, "error: The learning record store at " + lrs.address() + " does not know the credentials (401)");
  expect_says(said, (folder_ / "who").string());
  EXPECT_EQ(said.find("guess"), std::string::npos);
  EXPECT_EQ(puts(lrs), 1);
  expect_says(put_in_trouble(lrs, Trouble::status, 1, 403), "store statements (403)");
}

TEST_F(RecordStoreOfStandIn, RefusesAStatement) {
  for (const int status : {400, 413, 422}) {
    StandInRecordStore lrs;
    const std::string said =
        put_in_trouble(lrs, Trouble::status, -1, status, {}, "too long: " + std::string(5000, 'x'));
    expect_begins(said, "refused: The learning record store at " + lrs.address() + " refuses statement " +
                            kId + " (" + std::to_string(status) + ": too long: xxx");
    EXPECT_LT(said.size(), 500u);
    EXPECT_EQ(puts(lrs), 1);
  }
  StandInRecordStore lrs;
  auto store = open(lrs.address());
  expect_says(words(*store->put(kId, "{}")), "(400: actor: is missing)");
}

TEST_F(RecordStoreOfStandIn, MayBeSomethingElse) {
  StandInRecordStore lrs;
  expect_begins(put_to(lrs.address() + "/elsewhere"), "error: There is no learning record store at");
  expect_says(put_in_trouble(lrs, Trouble::status, 1, 405),
              "does not answer as a learning record store (405)");
  expect_says(put_in_trouble(lrs, Trouble::garbage, -1), "does not speak HTTP");
  expect_says(put_in_trouble(lrs, Trouble::huge_head, -1), "does not speak HTTP");
  EXPECT_EQ(kept(lrs), 0u);
}

// Many a server says 200 to whatever it is told: what it does not show is not there.
TEST_F(RecordStoreOfStandIn, IsNotBelievedWithoutLooking) {
  StandInRecordStore lrs;
  expect_says(put_in_trouble(lrs, Trouble::status, -1, 200, {}, "welcome"),
              "answers as no learning record store does (200: welcome), and does not show it (404)");
  expect_says(put_in_trouble(lrs, Trouble::status, -1, 409, {}, "again?"), "does not show it (404)");
  EXPECT_EQ(put_in_trouble(lrs, Trouble::status, 0), "stored");
  EXPECT_EQ(put_in_trouble(lrs, Trouble::status, 1, 200), "stored");
  EXPECT_EQ(put_in_trouble(lrs, Trouble::status, 1, 412), "already there");
}

TEST_F(RecordStoreOfStandIn, MustShowTheSameStatement) {
  const std::string other_id = "00000000-0000-4000-8000-000000000000";
  for (const std::string& shown :
       {std::string(), std::string("[]"), "\"" + kId + "\"", std::string("{\"id\": 5}"),
        "{\"id\": \"" + other_id + "\"}", "{\"statements\": [{\"id\": \"" + kId + "\"}]}",
        "[" + std::string(60'000, '['), "{\"id\": \"" + kId}) {
    StandInRecordStore lrs;
    put_to(lrs.address());
    lrs.set([](auto& state) {
      state.conflicts = true;
      state.troubled = "GET";
    });
    const std::string said = put_in_trouble(lrs, Trouble::status, -1, 200, {}, shown);
    expect_begins(said, "refused: ");
    expect_says(said, "(409: it is there), and does not show it (200)");
  }
}

TEST_F(RecordStoreOfStandIn, MayBeUnwellWhenItIsAskedWhatItHas) {
  StandInRecordStore lrs;
  put_to(lrs.address());
  lrs.set([](auto& state) {
    state.conflicts = true;
    state.troubled = "GET";
  });
  EXPECT_EQ(put_in_trouble(lrs, Trouble::status, 1, 500), "already there");
  EXPECT_EQ(put_in_trouble(lrs, Trouble::status, 2, 404), "already there");
  EXPECT_EQ(put_in_trouble(lrs, Trouble::closes, 2), "already there");
  expect_begins(put_in_trouble(lrs, Trouble::status, -1, 500), "try again: ");
  expect_says(put_in_trouble(lrs, Trouble::status, -1, 403), "whether the credentials may read");
  expect_says(put_in_trouble(lrs, Trouble::huge_body, -1, 200), "does not show it (200)");
}

TEST_F(RecordStoreOfStandIn, MaySayMoreThanAnybodyReads) {
  StandInRecordStore lrs;
  const std::string said = put_in_trouble(lrs, Trouble::huge_body, -1, 400);
  expect_begins(said, "refused: ");
  EXPECT_LT(said.size(), 500u);
  EXPECT_EQ(put_in_trouble(lrs, Trouble::huge_body, 2, 500), "stored");
  EXPECT_EQ(put_in_trouble(lrs, Trouble::torn_body, 2, 400), "stored");
}

TEST_F(RecordStoreOfStandIn, DoesNotSendUsElsewhere) {
  StandInRecordStore lrs, elsewhere;
  for (const int status : {301, 302, 303, 307, 308}) {
    const std::string said = put_in_trouble(lrs, Trouble::status, 1, status,
                                            "Location: " + elsewhere.address() + "/statements?x=y\r\n");
    expect_begins(said, "error: " + lrs.address() + " sends on to '" + elsewhere.address() + "' (");
  }
  EXPECT_EQ(puts(elsewhere), 0);
  expect_says(put_in_trouble(lrs, Trouble::status, 1, 302), "sends on to ''");
  // Within one store, and without who asked.
  expect_says(put_in_trouble(lrs, Trouble::status, 1, 308, "Location: /other/statements?x\r\n"),
              "sends on to 'http://localhost:");
  expect_says(put_in_trouble(lrs, Trouble::status, 1, 308, "Location: http://a:b@c.org/statements\r\n"),
              "sends on to 'http://c.org'");
}

TEST_F(RecordStoreOfStandIn, StopsAtOnce) {
  StandInRecordStore lrs;
  EXPECT_EQ(put_to(lrs.address(), std::nullopt, [] { return true; }), "stopped");
  EXPECT_EQ(puts(lrs), 0);
  // In the middle of a request that would never end,
  lrs.set([](auto& state) {
    state.trouble = Trouble::holds;
    state.troubles = -1;
  });
  EXPECT_EQ(put_to(lrs.address(), std::nullopt, [&] { return puts(lrs) == 1; }), "stopped");
  // and between two of them.
  patience_.first_wait = std::chrono::hours(10);
  lrs.set([](auto& state) { state.trouble = Trouble::status; });
  EXPECT_EQ(put_to(lrs.address(), std::nullopt, [&] { return puts(lrs) == 2; }), "stopped");
}

TEST_F(RecordStoreOfStandIn, IsToldOfNothingThatIsNoUuid) {
  StandInRecordStore lrs;
  auto store = open(lrs.address());
  for (const std::string& id :
       {std::string(), kId + "&attachments=true", kId.substr(1), "../" + kId, kId + "\r\nX: y",
        std::string("6f1c2a34 9d5e-4b0a-8c11-0123456789ab"), std::string(36, '-')})
    expect_begins(words(*store->put(id, example_json())), "refused: A statement's id is not a UUID: ");
  EXPECT_EQ(puts(lrs), 0);
}

TEST_F(RecordStoreOfStandIn, ProvesThatItIs) {
  const test::Certificate own = test::make_certificate(kThisMachine);
  folder_.write("own.pem", own.pem);
  StandInRecordStore lrs(own);
  EXPECT_EQ(put_to(lrs.address("localhost"), "own.pem"), "stored");
  EXPECT_EQ(put_to(lrs.address("127.0.0.1"), "own.pem"), "stored");
  expect_begins(put_in_trouble(lrs, Trouble::status, 0),
                "error: What is at " + lrs.address() + " does not prove that it is (");
}

TEST_F(RecordStoreOfStandIn, IsNotAnotherThanItsCertificateNames) {
  const test::Certificate own = test::make_certificate(kThisMachine);
  const test::Certificate stale = test::make_certificate(kThisMachine, -60);
  const test::Certificate foreign = test::make_certificate("DNS:elsewhere.example,DNS:localhost.example");
  folder_.write("own.pem", own.pem);
  folder_.write("stale.pem", stale.pem);
  folder_.write("foreign.pem", foreign.pem);
  StandInRecordStore lrs(own), late(stale), other(foreign);
  for (const std::string& said : {put_to(lrs.address(), "foreign.pem"), put_to(late.address(), "stale.pem"),
                                  put_to(other.address(), "foreign.pem")})
    expect_says(said, "does not prove that it is (");
  EXPECT_EQ(puts(lrs) + puts(late) + puts(other), 0);
}

TEST_F(RecordStoreOfStandIn, FailsEncryptedAsItDoesPlain) {
  const test::Certificate own = test::make_certificate(kThisMachine);
  folder_.write("own.pem", own.pem);
  for (const Trouble trouble :
       {Trouble::closes, Trouble::closes_after_storing, Trouble::status, Trouble::drips}) {
    StandInRecordStore lrs(own);
    lrs.set([&](auto& state) {
      state.trouble = trouble;
      state.troubles = 2;
      state.conflicts = true;
    });
    const std::string said = put_to(lrs.address(), "own.pem");
    EXPECT_EQ(said, trouble == Trouble::closes_after_storing ? "already there" : "stored");
    EXPECT_EQ(kept(lrs), 1u);
  }
}

TEST_F(RecordStoreOfStandIn, IsToldNothingByOldTls) {
  const test::Certificate own = test::make_certificate(kThisMachine);
  folder_.write("own.pem", own.pem);
  StandInRecordStore old(own, TLS1_1_VERSION), new_enough(own, TLS1_2_VERSION);
  expect_begins(put_to(old.address(), "own.pem"), "try again: ");
  EXPECT_EQ(puts(old), 0);
  EXPECT_EQ(put_to(new_enough.address(), "own.pem"), "stored");
}

TEST_F(RecordStoreOfStandIn, SpeaksAsItsAddressSays) {
  const test::Certificate own = test::make_certificate(kThisMachine);
  folder_.write("own.pem", own.pem);
  StandInRecordStore plain, encrypted(own);
  patience_.connect = milliseconds(50);  // each waits for the other to begin
  const std::string port = std::to_string(plain.port());
  expect_begins(put_to("https://localhost:" + port + "/xapi", "own.pem"), "try again: ");
  const std::string plainly = put_to("http://localhost:" + std::to_string(encrypted.port()) + "/xapi");
  EXPECT_NE(plainly, "stored");
  EXPECT_EQ(kept(plain) + kept(encrypted), 0u);
}

// NOLINTBEGIN(concurrency-mt-unsafe): the stand-in's threads do not look at the environment.
TEST_F(RecordStoreOfStandIn, IsNotReachedThroughProxiesThatSeeIt) {
  StandInRecordStore lrs, proxy;
  ASSERT_EQ(setenv("http_proxy", proxy.address().c_str(), 1), 0);
  ASSERT_EQ(setenv("all_proxy", proxy.address().c_str(), 1), 0);
  EXPECT_EQ(put_to(lrs.address()), "stored");
  unsetenv("http_proxy");
  unsetenv("all_proxy");
  EXPECT_EQ(puts(proxy), 0);
}

// NOLINTEND(concurrency-mt-unsafe)

TEST_F(RecordStoreOfStandIn, IsToldNothingInTheClear) {
  for (const char* const url :
       {"http://lrs.example/xapi", "http://127.0.0.2/xapi", "http://localhost.example/xapi"})
    expect_begins(put_to(url),
                  "not opened: The learning record store at " + std::string(url) + " would be told");
  expect_begins(put_to("https://anna:secret@lrs.example/"),
                "not opened: The address of the learning record store is refused: it names");
  expect_begins(put_to("nonsense"),
                "not opened: The address of the learning record store is refused: it is not in the form");
}

TEST_F(RecordStoreOfStandIn, IsOpenedWithFilesThatAreGood) {
  expect_says(put_to("https://localhost/", "none.pem"), "Cannot read");
  folder_.write("empty.pem", "");
  folder_.write("key.pem", test::make_certificate(kThisMachine).key_pem);
  expect_says(put_to("https://localhost/", "empty.pem"), "There is no certificate in");
  expect_says(put_to("https://localhost/", "key.pem"), "There is no certificate in");
  ::chmod((folder_ / "who").c_str(), 0644);
  expect_says(put_to("https://localhost/"), "chmod 600 ");
}

TEST_F(RecordStoreOfStandIn, IsNotTrustedByATornCertificate) {
  const test::Certificate own = test::make_certificate(kThisMachine);
  folder_.write("torn.pem", own.pem.substr(0, own.pem.size() / 2));
  StandInRecordStore lrs(own);
  expect_says(put_to(lrs.address(), "torn.pem"), "does not prove that it is (");
}

}  // namespace
}  // namespace fulcrum::session
