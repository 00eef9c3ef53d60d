// Results: what goes in comes out, whatever happens meanwhile. The file is looked at with SQLite itself, too.

#include "engine/session/store.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>

#include "engine/session/identity.h"
#include "engine/session/schema.h"
#include "temporary_folder.h"

namespace fulcrum::session {
namespace {

Session session_of(const std::string& participant) {
  return {random_uuid(), participant, "2026-11-25T09:00:00.000Z", "0.1.0"};
}

Trial some_trial(const std::string& scenario, double score) {
  Trial trial;
  trial.uuid = random_uuid();
  trial.scenario = scenario;
  trial.title = "A title with 'quotes' and \"more\"";
  trial.began = "2026-11-25T09:00:01.000Z";
  trial.ended = "2026-11-25T09:00:31.000Z";
  trial.device = "simulated";
  trial.seed = -7;
  trial.whole = true;
  trial.metrics.time = 30;
  trial.metrics.completed = true;
  trial.metrics.smoothness = -5.25;
  trial.metrics.hard_touches = 2;
  trial.events = {{1.5, TrialEvent::Kind::checkpoint, "first"}, {2.5, TrialEvent::Kind::hard_touch, ""}};
  trial.score = score;
  trial.folder = "/tmp/somewhere/" + trial.uuid;
  trial.trace_sha256 = std::string(64, 'a');
  return trial;
}

Store opened(const std::filesystem::path& file) {
  Result<Store> store = Store::open(file);
  if (!store) throw std::runtime_error(store.error().sentence);
  return std::move(*store);
}

std::int64_t ask(const std::filesystem::path& file, const char* query) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  std::int64_t answer = -1;
  sqlite3_exec(
      database, query,
      [](void* to, int, char** text, char**) {
        *static_cast<std::int64_t*>(to) = text[0] == nullptr ? -2 : std::stoll(text[0]);
        return 0;
      },
      &answer, nullptr);
  sqlite3_close(database);
  return answer;
}

void tell(const std::filesystem::path& file, const std::string& text) {
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  char* why = nullptr;
  EXPECT_EQ(sqlite3_exec(database, text.c_str(), nullptr, nullptr, &why), SQLITE_OK) << why;
  sqlite3_free(why);
  sqlite3_close(database);
}

TEST(Store, GivesBackWhatItWasGiven) {
  const TemporaryFolder folder;
  const Session session = session_of("P1");
  Trial trial = some_trial("piping", 87.5);
  trial.hand = "expert";
  {
    Store store = opened(folder / "r.sqlite");
    ASSERT_FALSE(store.add(session, trial));
  }
  const Store store = opened(folder / "r.sqlite");
  const auto trials = store.trials({});
  ASSERT_TRUE(trials);
  ASSERT_EQ(trials->size(), 1U);
  const auto& [again, of] = trials->front();
  EXPECT_EQ(of.uuid, session.uuid);
  EXPECT_EQ(of.participant, "P1");
  EXPECT_EQ(of.program_version, "0.1.0");
  EXPECT_EQ(again.uuid, trial.uuid);
  EXPECT_EQ(again.title, trial.title);
  EXPECT_EQ(again.hand, "expert");
  EXPECT_EQ(again.seed, -7);
  EXPECT_TRUE(again.whole);
  EXPECT_EQ(again.score, 87.5);
  EXPECT_EQ(again.folder, trial.folder);
  EXPECT_EQ(named_values(again.metrics), named_values(trial.metrics));
  ASSERT_EQ(again.events.size(), 2U);
  EXPECT_EQ(again.events[0].text, "first");
  EXPECT_EQ(again.events[1].kind, TrialEvent::Kind::hard_touch);
}

TEST(Store, IsForNobodyElseToRead) {
  const TemporaryFolder folder;
  const Store store = opened(folder / "below/it/r.sqlite");
  for (const auto& entry : std::filesystem::directory_iterator(folder / "below/it")) {
    struct stat status {};
    ASSERT_EQ(::stat(entry.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600U) << entry.path();
  }
}

TEST(Store, FiltersAndKnowsTheBest) {
  const TemporaryFolder folder;
  Store store = opened(folder / "r.sqlite");
  const Session one = session_of("P1"), other = session_of("P2");
  ASSERT_FALSE(store.add(one, some_trial("piping", 40)));
  ASSERT_FALSE(store.add(one, some_trial("piping", 80)));
  ASSERT_FALSE(store.add(one, some_trial("ear", 10)));
  ASSERT_FALSE(store.add(other, some_trial("piping", 90)));
  Trial left = some_trial("piping", 100), shown = some_trial("piping", 100);
  left.whole = false;
  shown.hand = "expert";
  ASSERT_FALSE(store.add(one, left));
  ASSERT_FALSE(store.add(one, shown));
  EXPECT_EQ(store.trials({})->size(), 6U);
  EXPECT_EQ(store.trials({.participant = "P1"})->size(), 5U);
  EXPECT_EQ(store.trials({.participant = "P1", .scenario = "ear"})->size(), 1U);
  EXPECT_EQ(store.trials({.scenario = "piping"})->size(), 5U);
  EXPECT_EQ(*store.best_score("P1", "piping"), 80)
      << "neither one that was left counts, nor one of a simulated hand";
  EXPECT_FALSE(*store.best_score("P2", "ear"));
  const auto participants = store.participants();
  ASSERT_EQ(participants->size(), 2U);
  EXPECT_EQ(participants->front().trials, 5);
  EXPECT_FALSE(participants->front().consents);
}

TEST(Store, SendsOfThoseWhoConsentWhatWasNotSentYet) {
  const TemporaryFolder folder;
  Store store = opened(folder / "r.sqlite");
  const Trial trial = some_trial("piping", 40);
  Trial left = some_trial("piping", 100);
  left.whole = false;
  ASSERT_FALSE(store.add(session_of("P1"), trial));
  ASSERT_FALSE(store.add(session_of("P1"), left));
  ASSERT_FALSE(store.add(session_of("P2"), some_trial("ear", 90)));
  EXPECT_EQ(store.unsent("https://a")->size(), 0U);
  EXPECT_TRUE(*store.set_consent("P1", true));
  EXPECT_FALSE(*store.set_consent("nobody", true));
  ASSERT_EQ(store.unsent("https://a")->size(), 1U);
  EXPECT_TRUE(*store.may_send(trial.uuid, "https://a"));
  ASSERT_FALSE(store.mark_sent(trial.uuid, "https://a", "2026-11-25T10:00:00.000Z"));
  EXPECT_FALSE(*store.may_send(trial.uuid, "https://a"));
  EXPECT_EQ(store.unsent("https://a")->size(), 0U);
  EXPECT_EQ(store.unsent("https://b")->size(), 1U) << "another address has not been sent it";
  EXPECT_TRUE(*store.set_consent("P1", false));
  EXPECT_EQ(store.unsent("https://b")->size(), 0U);
  EXPECT_FALSE(*store.may_send(trial.uuid, "https://b"));
}

TEST(Store, ForgetsAParticipantToTheLastByte) {
  const TemporaryFolder folder;
  const std::string name = "Zaphod-the-unmistakable";
  Store store = opened(folder / "r.sqlite");
  const Trial trial = some_trial("piping", 40);
  ASSERT_FALSE(store.add(session_of(name), trial));
  ASSERT_FALSE(store.add(session_of("P2"), some_trial("ear", 90)));
  ASSERT_FALSE(store.mark_sent(trial.uuid, "https://a", "now"));
  EXPECT_EQ(*store.remove_participant(name, {}), Store::Removal::more_trials);
  EXPECT_EQ(store.trials({})->size(), 2U);
  EXPECT_EQ(*store.remove_participant(name, {trial.uuid}), Store::Removal::done);
  EXPECT_EQ(store.trials({})->size(), 1U);
  for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(bytes.find(name), bytes.npos) << entry.path();
    EXPECT_EQ(bytes.find(trial.uuid), bytes.npos) << entry.path();
  }
  for (const char* table :
       {"SELECT COUNT(*) FROM trial", "SELECT COUNT(*) FROM session",
        "SELECT COUNT(DISTINCT trial) FROM metric", "SELECT COUNT(DISTINCT trial) FROM event"})
    EXPECT_EQ(ask(folder / "r.sqlite", table), 1) << table;
  EXPECT_EQ(ask(folder / "r.sqlite", "SELECT COUNT(*) FROM sent"), 0);
}

TEST(Store, SaysThatAReaderStillHoldsWhatWasRemoved) {
  const TemporaryFolder folder;
  Store store = opened(folder / "r.sqlite");
  const Trial trial = some_trial("piping", 40);
  ASSERT_FALSE(store.add(session_of("P1"), trial));
  sqlite3* reader = nullptr;
  sqlite3_open((folder / "r.sqlite").c_str(), &reader);
  ASSERT_EQ(sqlite3_exec(reader, "BEGIN; SELECT COUNT(*) FROM trial", nullptr, nullptr, nullptr), SQLITE_OK);
  EXPECT_EQ(*store.remove_participant("P1", {trial.uuid}), Store::Removal::still_read);
  sqlite3_close(reader);
  EXPECT_EQ(store.participants()->size(), 0U);
}

TEST(Store, MayBeMovedWithItsRecordings) {
  const TemporaryFolder folder;
  Trial trial = some_trial("piping", 40), elsewhere = some_trial("piping", 50);
  trial.folder = (folder / "one/runs/a").string();
  {
    Store store = opened(folder / "one/r.sqlite");
    ASSERT_FALSE(store.add(session_of("P1"), trial));
    ASSERT_FALSE(store.add(session_of("P1"), elsewhere));
    EXPECT_EQ(store.trials({})->front().trial.folder, trial.folder);
  }
  std::filesystem::rename(folder / "one", folder / "two");
  const Store moved = opened(folder / "two/r.sqlite");
  const auto trials = moved.trials({});
  EXPECT_EQ((*trials)[0].trial.folder, (folder / "two/runs/a").string());
  EXPECT_EQ((*trials)[1].trial.folder, elsewhere.folder);
}

TEST(Store, LiesBehindALink) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "disk");
  std::filesystem::create_directory_symlink(folder / "disk", folder / "home");
  EXPECT_TRUE(Store::open(folder / "home/data/r.sqlite"));
  EXPECT_TRUE(std::filesystem::exists(folder / "disk/data/r.sqlite"));
}

TEST(Store, ClosesAFileThatWasOpenToOthers) {
  const TemporaryFolder folder;
  std::ofstream(folder / "r.sqlite").close();
  ::chmod((folder / "r.sqlite").c_str(), 0644);
  const Store store = opened(folder / "r.sqlite");
  struct stat status {};
  ASSERT_EQ(::stat((folder / "r.sqlite").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600U);
}

TEST(Store, KnowsAChangedTask) {
  const TemporaryFolder folder;
  Store store = opened(folder / "r.sqlite");
  Trial easy = some_trial("piping", 100);
  easy.changes = "dwell=0";
  ASSERT_FALSE(store.add(session_of("P1"), easy));
  ASSERT_FALSE(store.add(session_of("P1"), some_trial("piping", 60)));
  EXPECT_EQ(*store.best_score("P1", "piping"), 60);
  EXPECT_EQ(store.trials({})->front().trial.changes, "dwell=0");
  ASSERT_TRUE(*store.set_consent("P1", true));
  EXPECT_EQ(store.unsent("https://a")->size(), 1U);
}

TEST(Store, AGuidedTrialIsNoBestAndIsNotSent) {
  const TemporaryFolder folder;
  Store store = opened(folder / "r.sqlite");
  Trial guided = some_trial("piping", 100);
  guided.metrics.guided = true;
  ASSERT_FALSE(store.add(session_of("P1"), guided));
  ASSERT_FALSE(store.add(session_of("P1"), some_trial("piping", 60)));
  EXPECT_EQ(*store.best_score("P1", "piping"), 60);
  EXPECT_TRUE(store.trials({})->front().trial.metrics.guided);
  EXPECT_EQ(store.trials({})->front().trial.metrics.time, 30);
  EXPECT_FALSE(store.trials({})->back().trial.metrics.guided);
  ASSERT_TRUE(*store.set_consent("P1", true));
  ASSERT_EQ(store.unsent("https://a")->size(), 1U);
  EXPECT_EQ(store.unsent("https://a")->front().trial.score, 60);
  EXPECT_FALSE(*store.may_send(guided.uuid, "https://a"));
}

// Of an earlier program: P1, who agreed to be told of, and a session without a trial.
void begin_store_of_version(int version, const std::filesystem::path& file) {
  std::ofstream(file).close();
  {
    sql::Database database(file);
    migrate(database, version);
    ASSERT_EQ(schema_version(database), version);
  }
  tell(file,
       "INSERT INTO participant VALUES (1, 'P1', 1, '2026-01-01T00:00:00.000Z');"
       "INSERT INTO session VALUES (1, 's', 1, '2026-01-01T00:00:00.000Z', '0.1.0');");
}

TEST(Store, TakesOneOfVersion2) {
  const TemporaryFolder folder;
  const auto file = folder / "r.sqlite";
  ASSERT_NO_FATAL_FAILURE(begin_store_of_version(2, file));
  tell(file,
       "INSERT INTO trial (id, session, scenario, title, began, ended, device, hand, left_handed, seed, "
       "whole, "
       "score, folder, trace_sha256, uuid) "
       "VALUES (1, 1, 'piping', 't', 'b', 'e', 'simulated', '', 0, 1, 1, 55.5, '/f', 'h', 'u');"
       "INSERT INTO sent VALUES (1, 'https://a', 'then');");
  Store store = opened(file);
  EXPECT_EQ(ask(file, "PRAGMA user_version"), kSchemaVersion);
  const auto trials = store.trials({});
  ASSERT_EQ(trials->size(), 1U);
  EXPECT_EQ(trials->front().trial.uuid, "u");
  EXPECT_FALSE(trials->front().trial.metrics.guided) << "none was, before there was such a thing";
  EXPECT_EQ(*store.best_score("P1", "piping"), 55.5);
  EXPECT_EQ(store.unsent("https://a")->size(), 0U);
  EXPECT_EQ(store.unsent("https://b")->size(), 1U);
}

TEST(Store, TakesOneOfVersion1) {
  const TemporaryFolder folder;
  const auto file = folder / "r.sqlite";
  ASSERT_NO_FATAL_FAILURE(begin_store_of_version(1, file));
  tell(file,
       "INSERT INTO trial VALUES (1, 1, 'piping', 't', 'b', 'e', 'simulated', '', 0, 1, 1, 55.5, '/f', 'h'),"
       "(2, 1, 'ear', 't', 'c', 'e', 'simulated', '', 0, 1, 0, NULL, '/g', '');"
       "INSERT INTO metric VALUES (1, 'time_s', 12.5); INSERT INTO event VALUES (1, 0, 1.5, 'checkpoint', "
       "'x');");
  Store store = opened(file);
  EXPECT_EQ(ask(file, "PRAGMA user_version"), kSchemaVersion);
  const auto trials = store.trials({});
  ASSERT_EQ(trials->size(), 2U);
  EXPECT_EQ((*trials)[0].trial.score, 55.5);
  EXPECT_EQ((*trials)[0].trial.metrics.time, 12.5);
  EXPECT_EQ((*trials)[0].trial.events.size(), 1U);
  EXPECT_FALSE((*trials)[1].trial.score);
  EXPECT_NE((*trials)[0].trial.uuid, (*trials)[1].trial.uuid);
  EXPECT_EQ((*trials)[0].trial.uuid.size(), 36U);
  EXPECT_EQ(store.unsent("https://a")->size(), 1U);
  ASSERT_FALSE(store.add(session_of("P1"), some_trial("piping", 1)));
}

TEST(Store, RefusesWhatItDoesNotKnow) {
  const TemporaryFolder folder;
  { const Store store = opened(folder / "newer.sqlite"); }
  tell(folder / "newer.sqlite", "PRAGMA user_version = 4");
  const auto newer = Store::open(folder / "newer.sqlite");
  ASSERT_FALSE(newer);
  EXPECT_NE(newer.error().sentence.find("version 4"), std::string::npos);
  EXPECT_EQ(ask(folder / "newer.sqlite", "PRAGMA user_version"), 4);
  tell(folder / "newer.sqlite", "PRAGMA user_version = -1");
  EXPECT_FALSE(Store::open(folder / "newer.sqlite"));

  std::ofstream(folder / "text.sqlite") << std::string(5000, 'x');
  const auto text = Store::open(folder / "text.sqlite");
  ASSERT_FALSE(text);
  EXPECT_NE(text.error().sentence.find("damaged"), std::string::npos) << text.error().sentence;
  std::filesystem::create_directory(folder / "folder.sqlite");
  EXPECT_FALSE(Store::open(folder / "folder.sqlite"));
  ASSERT_EQ(::mkfifo((folder / "pipe.sqlite").c_str(), 0600), 0);
  EXPECT_FALSE(Store::open(folder / "pipe.sqlite"));
  std::filesystem::create_symlink(folder / "elsewhere", folder / "link.sqlite");
  EXPECT_FALSE(Store::open(folder / "link.sqlite"));
  EXPECT_FALSE(std::filesystem::exists(folder / "elsewhere"));
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Store, ChangesNothingOfAFileThatIsNotItsOwn) {
  const TemporaryFolder folder;
  const auto file = folder / "r.sqlite";
  const auto stays = [&](const char* says) {
    ASSERT_EQ(::chmod(file.c_str(), 0644), 0);
    const std::string before = bytes_of(file);
    const auto refused = Store::open(file);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence.find(says), std::string::npos) << refused.error().sentence;
    EXPECT_EQ(bytes_of(file), before);
    EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0644));
  };
  for (const char* of_another :
       {"CREATE TABLE bookmarks (a)", "PRAGMA user_version = 3", "PRAGMA application_id = 7"}) {
    tell(file, of_another);
    stays("not one of Fulcrum's");
  }
  std::filesystem::remove(file);
  { const Store store = opened(file); }
  tell(file, "PRAGMA journal_mode = DELETE; PRAGMA user_version = 4");
  stays("version 4");
}

TEST(Store, SaysWhatIsWrongWithADamagedFile) {
  const TemporaryFolder folder;
  const auto file = folder / "r.sqlite";
  {
    Store store = opened(file);
    for (int i = 0; i < 40; ++i) ASSERT_FALSE(store.add(session_of("P1"), some_trial("piping", i)));
  }
  std::mt19937 random(1);
  const auto size = std::filesystem::file_size(file);
  for (int turn = 0; turn < 60; ++turn) {
    const auto broken = folder / "broken.sqlite";
    std::filesystem::copy_file(file, broken, std::filesystem::copy_options::overwrite_existing);
    {
      std::fstream bytes(broken, std::ios::in | std::ios::out | std::ios::binary);
      for (int i = 0; i < 40; ++i) {
        bytes.seekp(static_cast<std::streamoff>(random() % size));
        bytes.put(static_cast<char>(random()));
      }
    }
    if (turn % 3 == 0) std::filesystem::resize_file(broken, random() % size);
    // Whatever it makes of it is a result or a sentence.
    const auto store = Store::open(broken);
    if (!store) {
      EXPECT_FALSE(store.error().sentence.empty());
      continue;
    }
    const auto trials = store->trials({});
    if (!trials) EXPECT_FALSE(trials.error().sentence.empty());
  }
}

// A child keeps trial upon trial, and says of each that it is kept; then it is killed, wherever it is.
void kill_while_keeping(int times) {
  const TemporaryFolder folder;
  const auto file = folder / "r.sqlite";
  std::mt19937 random(2);
  std::set<std::string> kept;
  for (int turn = 0; turn < times; ++turn) {
    int told[2];
    ASSERT_EQ(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      Store store = opened(file);
      for (;;) {
        const Trial trial = some_trial("piping", 50);
        if (store.add(session_of("P1"), trial)) ::_exit(1);
        if (::write(told[1], trial.uuid.data(), trial.uuid.size()) != 36) ::_exit(1);
      }
    }
    ::close(told[1]);
    // After a number of trials and a moment more, so that any part of the next may be under way.
    const int wanted = 1 + static_cast<int>(random() % 5);
    char uuid[36];
    for (int i = 0; i < wanted && ::read(told[0], uuid, sizeof uuid) == sizeof uuid; ++i)
      kept.emplace(uuid, 36);
    ::usleep(static_cast<useconds_t>(random() % 5000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    while (::read(told[0], uuid, sizeof uuid) == sizeof uuid) kept.emplace(uuid, 36);
    ::close(told[0]);

    const Store store = opened(file);
    std::set<std::string> found;
    for (const auto trials = store.trials({}); const StoredTrial& stored : *trials) {
      found.insert(stored.trial.uuid);
      EXPECT_EQ(stored.trial.events.size(), 2U);
      EXPECT_EQ(stored.trial.metrics.smoothness, -5.25);
    }
    for (const std::string& one : kept) EXPECT_TRUE(found.contains(one)) << one;
    EXPECT_LE(found.size(), kept.size() + 1 + static_cast<std::size_t>(turn)) << "at most the one under way";
  }
}

// Another program that looks at the results and ends while this one has two stores open, as a start page has.
TEST(Store, LosesNothingToAReaderThatEnds) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "r.sqlite";
  // Forked before any store is open here: it must know nothing of this process's.
  int go[2];
  ASSERT_EQ(::pipe(go), 0);
  const pid_t reader = ::fork();
  if (reader == 0) {
    char told = 0;
    const bool goes = ::read(go[0], &told, 1) == 1;
    ::_exit(goes && ask(file, "SELECT COUNT(*) FROM trial") == 1 ? 0 : 1);
  }
  Store store = opened(file);
  ASSERT_FALSE(store.add(session_of("P1"), some_trial("piping", 40)));
  const Store page = opened(file);
  ASSERT_EQ(page.trials({})->size(), 1U);
  ASSERT_EQ(::write(go[1], "g", 1), 1);
  int status = -1;
  ::waitpid(reader, &status, 0);
  EXPECT_EQ(status, 0);
  ::close(go[0]);
  ::close(go[1]);
  ASSERT_FALSE(store.add(session_of("P1"), some_trial("piping", 50)));
  EXPECT_TRUE(std::filesystem::exists(folder / "r.sqlite-wal"));
  EXPECT_EQ(opened(file).trials({})->size(), 2U);
}

TEST(Store, LosesNothingToAKill) {
  kill_while_keeping(20);
}

TEST(Store, LosesNothingToKillsLong) {
  kill_while_keeping(200);
}

}  // namespace
}  // namespace fulcrum::session
