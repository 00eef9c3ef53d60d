// A new file of some content, and what becomes of one that cannot be written to its end.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/files/block_file.h"
#include "tests/files/temporary_folder.h"

namespace fulcrum {
namespace {

std::string written_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(NewFile, IsWrittenAndAnOldOneStays) {
  const TemporaryFolder folder;
  const auto path = folder / "t.csv";
  EXPECT_FALSE(write_new_file(path, "a\n1\n"));
  const std::optional<Error> again = write_new_file(path, "b\n");
  ASSERT_TRUE(again);
  EXPECT_NE(again->sentence.find("t.csv"), std::string::npos);
  EXPECT_EQ(written_text(path), "a\n1\n");
}

TEST(NewFile, ThatCannotBeWrittenToItsEndIsNone) {
  const TemporaryFolder folder;
  const auto path = folder / "t.csv";
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::optional<Error> failure = write_new_file(path, std::string(5000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->sentence.find("t.csv"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace fulcrum
