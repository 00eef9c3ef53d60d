#include "engine/files/put_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <vector>

#include "engine/files/descriptor.h"
#include "engine/files/regular_file.h"
#include "tests/files/size_limit.h"
#include "tests/files/temporary_folder.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

using Put = bool (*)(const fs::path&, Pieces);
constexpr Put kBothWays[] = {put_file, put_file_by_part};

std::span<const std::byte> bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

std::string text_of(const fs::path& file) {
  return *RegularFile::open(file)->first_bytes(1 << 30);
}

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename().string());
  return found;
}

TEST(PutFile, WritesReplacesAndMakesFolders) {
  for (const Put put : kBothWays) {
    const TemporaryFolder folder;
    const std::string one = "one", two = "two";
    EXPECT_TRUE(put(folder / "a/b/file", {bytes(one), bytes(two)}));
    EXPECT_EQ(text_of(folder / "a/b/file"), "onetwo");
    EXPECT_TRUE(put(folder / "a/b/file", {bytes(two)}));
    EXPECT_EQ(text_of(folder / "a/b/file"), "two");
    EXPECT_EQ(names(folder / "a/b"), std::set<std::string>{"file"});
  }
}

TEST(PutFile, ReplacesAPipeAndALink) {
  for (const Put put : kBothWays) {
    const TemporaryFolder folder;
    const std::string text = "text";
    folder.write("elsewhere", "kept");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("elsewhere", folder / "link");
    EXPECT_TRUE(put(folder / "pipe", {bytes(text)}));
    EXPECT_TRUE(put(folder / "link", {bytes(text)}));
    EXPECT_EQ(text_of(folder / "pipe"), text);
    EXPECT_EQ(text_of(folder / "link"), text);
    EXPECT_EQ(text_of(folder / "elsewhere"), "kept");
  }
}

TEST(PutFile, SaysWhatItCannot) {
  for (const Put put : kBothWays) {
    const TemporaryFolder folder;
    const std::string text = "text";
    folder.write("file", "kept");
    EXPECT_FALSE(put(folder / "file/below", {bytes(text)}));
    fs::create_directories(folder / "full/below");
    EXPECT_FALSE(put(folder / "full", {bytes(text)}));
    EXPECT_EQ(names(folder / ""), (std::set<std::string>{"file", "full"}));
  }
}

TEST(PutFile, SaysWhyItCannot) {
  for (const Put put : kBothWays) {
    const TemporaryFolder folder;
    const std::string text = "text";
    folder.write("file", "kept");
    EXPECT_FALSE(put(folder / "file/below", {bytes(text)}));
    EXPECT_EQ(errno, ENOTDIR);
    EXPECT_FALSE(put("/proc/self/below/file", {bytes(text)}));
    EXPECT_EQ(errno, ENOENT);
    const test::SizeLimit none(0);
    EXPECT_FALSE(put(folder / "new", {bytes(text)}));
    EXPECT_EQ(errno, EFBIG);
    EXPECT_EQ(names(folder / ""), std::set<std::string>{"file"});
  }
}

TEST(PutFile, RemovesPartsThatNobodyWrites) {
  for (const Put put : kBothWays) {
    const TemporaryFolder folder;
    const std::string text = "text";
    folder.write("a.field.123.part", "half");
    folder.write("b.field.124.part", "half");
    fs::create_symlink("b.field.124.part", folder / "link.part");
    const Descriptor writing(::open((folder / "b.field.124.part").c_str(), O_WRONLY | O_CLOEXEC));
    ASSERT_EQ(::flock(writing.number(), LOCK_EX), 0);
    EXPECT_TRUE(put(folder / "file", {bytes(text)}));
    EXPECT_EQ(names(folder / ""), (std::set<std::string>{"b.field.124.part", "file", "link.part"}));
  }
}

// The child writes file after file until it goes.
TEST(PutFile, KilledLeavesNothingBehind) {
  for (const Put put : kBothWays) {
    const TemporaryFolder folder;
    const std::string text(1 << 22, 'x');
    for (int kill_number = 0; kill_number < 20; ++kill_number) {
      int ready[2];
      ASSERT_EQ(::pipe(ready), 0);
      const pid_t child = ::fork();
      if (child == 0) {
        for (int i = 0;; ++i) {
          put(folder / ("file" + std::to_string(i % 3)), {bytes(text), bytes(text)});
          if (::write(ready[1], "x", 1) != 1) ::_exit(1);
        }
      }
      char signal;
      for (int i = 0; i <= kill_number % 4; ++i) ASSERT_EQ(::read(ready[0], &signal, 1), 1);
      ::usleep(static_cast<useconds_t>(kill_number) * 300);  // somewhere within the next file
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
      ::close(ready[0]);
      ::close(ready[1]);
      for (const std::string& name : names(folder / "")) {
        if (put == put_file_by_part && name.ends_with(".part")) continue;
        EXPECT_EQ(fs::file_size(folder / name), 2 * text.size()) << name;
      }
    }
    const std::string last = "last";
    EXPECT_TRUE(put(folder / "file0", {bytes(last)}));
    for (const std::string& name : names(folder / "")) EXPECT_FALSE(name.ends_with(".part")) << name;
  }
}

// Many write and read one place: whoever reads finds all of a file or none.
TEST(PutFile, IsSeenWholeByOthers) {
  const TemporaryFolder folder;
  const fs::path file = folder / "file";
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      const std::string text(1 << 18, static_cast<char>('a' + i));
      bool good = true;
      for (int n = 0; n < 100; ++n) {
        good = put_file(file, {bytes(text)}) && good;
        if (const auto opened = RegularFile::open(file)) {
          const std::string seen = *opened->first_bytes(1 << 20);
          good = good && seen == std::string(text.size(), seen.empty() ? '?' : seen[0]);
        }
      }
      ::_exit(good ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(names(folder / ""), std::set<std::string>{"file"});
}

}  // namespace
}  // namespace fulcrum
