#include "engine/record/run_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "synthetic_run.h"

namespace fulcrum::record {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;
using std::chrono::system_clock;

constexpr system_clock::time_point kTime{seconds(1'700'000'000)};  // 2023-11-14 22:13:20 UTC

TEST(RunFolder, DefaultsToTheDataFolderAndIsNewEachTime) {
  const TemporaryFolder home;
  ::setenv("XDG_DATA_HOME", home.path().c_str(), 1);
  const auto first = make_default_run_folder("piping", kTime);
  const auto second = make_default_run_folder("piping", kTime);
  const auto third = make_default_run_folder("../my scene.yaml", kTime);
  ASSERT_TRUE(first && second && third);
  const fs::path runs = home / "fulcrum/runs";
  EXPECT_EQ(*first, runs / "piping-20231114T221320Z");
  EXPECT_EQ(*second, runs / "piping-20231114T221320Z-2");
  EXPECT_EQ(*third, runs / "---my-scene-yaml-20231114T221320Z");
  EXPECT_TRUE(fs::is_directory(*first) && fs::is_directory(*second) && fs::is_directory(*third));
  const auto report = make_default_run_folder("stability", kTime, "reports");
  ASSERT_TRUE(report);
  EXPECT_EQ(*report, home / "fulcrum/reports/stability-20231114T221320Z");
  ::unsetenv("XDG_DATA_HOME");
}

TEST(RunFolder, FallsBackToHomeAndThenToASentence) {
  const TemporaryFolder home;
  const std::string before = ::getenv("HOME") == nullptr ? "" : ::getenv("HOME");
  ::setenv("XDG_DATA_HOME", "not/absolute", 1);
  ::setenv("HOME", home.path().c_str(), 1);
  const auto folder = make_default_run_folder("piping", kTime);
  ASSERT_TRUE(folder);
  EXPECT_EQ(folder->parent_path(), home / ".local/share/fulcrum/runs");
  ::unsetenv("HOME");
  const auto none = make_default_run_folder("piping", kTime);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().sentence.find("--out"), std::string::npos);
  ::setenv("HOME", before.c_str(), 1);
  ::unsetenv("XDG_DATA_HOME");
}

TEST(RunFolder, IsMadeWithItsParents) {
  const TemporaryFolder folder;
  ASSERT_TRUE(prepare_run_folder(folder / "a/b", false));
  EXPECT_TRUE(fs::is_directory(folder / "a/b"));
  EXPECT_TRUE(prepare_run_folder(folder / "a/b", false)) << "an empty folder is as good as a new one";
}

TEST(RunFolder, ResultsAreKeptUnlessForced) {
  const TemporaryFolder folder;
  write(folder / "trace.csv", "old");
  write(folder / "notes.txt", "mine");
  const auto refused = prepare_run_folder(folder.path(), false);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("--force"), std::string::npos) << refused.error().sentence;
  EXPECT_EQ(contents(folder / "trace.csv"), "old");
  ASSERT_TRUE(prepare_run_folder(folder.path(), true));
  EXPECT_FALSE(fs::exists(folder / "trace.csv"));
  EXPECT_EQ(contents(folder / "notes.txt"), "mine");
}

TEST(RunFolder, NobodyElseWritesIntoOneThatIsTaken) {
  const TemporaryFolder folder;
  {
    const auto first = prepare_run_folder(folder.path(), true);
    ASSERT_TRUE(first);
    write(folder / "trace.csv", "of the first");
    const auto second = prepare_run_folder(folder.path(), true);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().sentence, "another run is writing into " + folder.path().string() +
                                           ": wait for its end, or choose another folder with --out.");
    EXPECT_EQ(contents(folder / "trace.csv"), "of the first");
    EXPECT_TRUE(prepare_run_folder(folder / "attempt-2", true)) << "a folder below is another one";
  }
  EXPECT_TRUE(prepare_run_folder(folder.path(), true)) << "the first has ended";
}

TEST(RunFolder, AReportsFilesAreItsOwn) {
  const TemporaryFolder folder;
  constexpr std::string_view files[] = {"stability.csv", "stability.html"};
  write(folder / "trace.csv", "a run's");
  ASSERT_TRUE(prepare_run_folder(folder.path(), false, files));
  write(folder / "stability.html", "old");
  EXPECT_FALSE(prepare_run_folder(folder.path(), false, files));
  ASSERT_TRUE(prepare_run_folder(folder.path(), true, files));
  EXPECT_FALSE(fs::exists(folder / "stability.html"));
  EXPECT_EQ(contents(folder / "trace.csv"), "a run's");
}

TEST(RunFolder, ForceRemovesALinkAndNotWhatItPointsTo) {
  const TemporaryFolder folder, elsewhere;
  write(elsewhere / "precious", "kept");
  fs::create_symlink(elsewhere / "precious", folder / "trace.csv");
  fs::create_symlink("/nowhere", folder / "tape");
  EXPECT_FALSE(prepare_run_folder(folder.path(), false));
  ASSERT_TRUE(prepare_run_folder(folder.path(), true));
  EXPECT_EQ(contents(elsewhere / "precious"), "kept");
  EXPECT_FALSE(fs::exists(fs::symlink_status(folder / "tape")));
}

TEST(RunFolder, ForceLeavesAFolderOfThatName) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "trace.csv");
  EXPECT_FALSE(prepare_run_folder(folder.path(), true));
  EXPECT_TRUE(fs::is_directory(folder / "trace.csv"));
}

TEST(RunFolder, AFileInItsPlaceIsASentence) {
  const TemporaryFolder folder;
  write(folder / "taken", "");
  EXPECT_FALSE(prepare_run_folder(folder / "taken", false));
  EXPECT_FALSE(prepare_run_folder(folder / "taken/below", false));
}

TEST(RunFolder, OneThatCannotBeWrittenIsASentence) {
  EXPECT_FALSE(prepare_run_folder("/proc/fulcrum", false));
  if (::geteuid() == 0) GTEST_SKIP() << "to root every other folder is writable";
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(prepare_run_folder(folder.path(), false));
  fs::permissions(folder.path(), fs::perms::owner_all);
}

}  // namespace
}  // namespace fulcrum::record
