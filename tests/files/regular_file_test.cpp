#include "engine/files/regular_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/files/temporary_folder.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

// What the file has, or why it was not opened.
std::string said(const Result<RegularFile>& file) {
  return file ? *file->first_bytes(100) : file.error().sentence;
}

TEST(RegularFile, GivesItsBytes) {
  const TemporaryFolder folder;
  folder.write("a", "one and two");
  EXPECT_EQ(said(RegularFile::open(folder / "a")), "one and two");
  EXPECT_EQ(RegularFile::open(folder / "a")->size(), 11u);
  EXPECT_EQ(*RegularFile::open(folder / "a")->first_bytes(3), "one");
  EXPECT_EQ(*RegularFile::open(folder / "a")->first_bytes(0), "");
  auto file = RegularFile::open(folder / "a");
  char bytes[8];
  EXPECT_EQ(*file->read_on(bytes, 8), 8u);
  EXPECT_EQ(*file->read_on(bytes, 8), 3u);
  EXPECT_EQ(*file->read_on(bytes, 8), 0u);
  const std::string large(1 << 20, 'x');
  folder.write("large", large);
  EXPECT_EQ(*RegularFile::open(folder / "large")->first_bytes(1 << 24), large);
}

TEST(RegularFile, OfTheSystemHasNoSizeBeforehand) {
  const auto text = RegularFile::open("/proc/self/status")->first_bytes(1 << 20);
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("Name:"), std::string::npos);
}

// None of these may be waited for: a pipe without a writer never answers.
TEST(RegularFile, IsNothingElse) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  (folder / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  fs::create_symlink("pipe", folder / "to_pipe");
  fs::create_symlink("to_itself", folder / "to_itself");
  EXPECT_EQ(said(RegularFile::open(folder / "pipe")), "it is a pipe, not a file");
  EXPECT_EQ(said(RegularFile::open(folder / "to_pipe")), "it is a pipe, not a file");
  EXPECT_EQ(said(RegularFile::open_within(folder / "", "pipe")), "it is a pipe, not a file");
  EXPECT_EQ(said(RegularFile::open(folder / "socket")), "it is a socket, not a file");
  EXPECT_EQ(said(RegularFile::open(folder / "")), "it is a folder, not a file");
  EXPECT_EQ(said(RegularFile::open("/dev/zero")), "it is a device, not a file");
  EXPECT_EQ(said(RegularFile::open(folder / "none")), "No such file or directory");
  EXPECT_EQ(said(RegularFile::open(folder / "to_itself")), "Too many levels of symbolic links");
  ::close(socket);
}

TEST(RegularFile, LiesWhereItMay) {
  const TemporaryFolder top;
  top.write("secret", "secret");
  top.write("inside/a", "a");
  top.write("inside/deeper/b", "b");
  top.write("inside_too/c", "c");
  const fs::path folder = top / "inside";
  fs::create_symlink("deeper/b", folder / "link");
  fs::create_symlink(folder / "a", folder / "absolute");
  fs::create_symlink("../inside/a", folder / "out_and_back");
  fs::create_symlink("../secret", folder / "out");
  fs::create_symlink("..", folder / "up");
  fs::create_symlink("/etc", folder / "etc");
  fs::create_symlink("inside", top / "to_inside");
  for (const char* name : {"a", "deeper/../a", "absolute", "out_and_back", "../inside/a", "./a"})
    EXPECT_EQ(said(RegularFile::open_within(folder, name)), "a") << name;
  EXPECT_EQ(said(RegularFile::open_within(folder, folder / "a")), "a");
  EXPECT_EQ(said(RegularFile::open_within(folder, "link")), "b");
  EXPECT_EQ(said(RegularFile::open_within(top / "to_inside", "a")), "a");  // the folder itself may be a link
  EXPECT_EQ(said(RegularFile::open_within("/", "/etc/hostname")), said(RegularFile::open("/etc/hostname")));
  for (const char* name : {"../secret", "out", "up/secret", "deeper/../../secret", "etc/passwd",
                           "/etc/passwd", "../inside_too/c", "..", "."})
    EXPECT_EQ(said(RegularFile::open_within(folder, name)),
              "it leads out of the folder " + folder.string() + "; copy the file there")
        << name;
  EXPECT_EQ(said(RegularFile::open_within(folder / "none", "a")), "No such file or directory");
  EXPECT_EQ(said(RegularFile::open_within(folder, "none")), "No such file or directory");
}

TEST(RegularFile, ThatMayNotBeReadSaysSo) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  folder.write("locked", "x");
  fs::permissions(folder / "locked", fs::perms::none);
  EXPECT_EQ(said(RegularFile::open(folder / "locked")), "Permission denied");
}

}  // namespace
}  // namespace fulcrum
