// A report that is written anew: the old one goes when the new one is there, and not before.

#include "engine/app/cli/report_output.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/files/size_limit.h"
#include "tests/files/temporary_folder.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

constexpr std::string_view kFiles[] = {"study.csv", "study.html"};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

RunOptions into(const fs::path& folder, bool force) {
  RunOptions options;
  options.out = folder;
  options.force = force;
  return options;
}

void write_old_report(const TemporaryFolder& folder) {
  folder.write("study.csv", "old");
  folder.write("study.html", "old");
  folder.write("notes.txt", "mine");
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(ReportOutput, AnOldReportStaysUntilTheNewOneIsThere) {
  const TemporaryFolder folder;
  write_old_report(folder);
  const auto place = report_place("study", into(folder / "", true), kFiles);
  ASSERT_TRUE(place);
  EXPECT_EQ(text_of(folder / "study.csv"), "old");
  EXPECT_EQ(text_of(folder / "study.html"), "old");
  ASSERT_TRUE(write_report(*place, {{"study.csv", "new"}}));
  EXPECT_EQ(text_of(folder / "study.csv"), "new");
  EXPECT_FALSE(fs::exists(folder / "study.html")) << "of the old report, and no part of the new one";
  EXPECT_EQ(text_of(folder / "notes.txt"), "mine");
}

TEST(ReportOutput, AnOldReportIsKeptUnlessForced) {
  const TemporaryFolder folder;
  write_old_report(folder);
  EXPECT_FALSE(report_place("study", into(folder / "", false), kFiles));
  const auto place = report_place("study", into(folder / "later", false), kFiles);
  ASSERT_TRUE(place);
  folder.write("later/study.html", "of another program");
  EXPECT_FALSE(write_report(*place, {{"study.csv", "new"}, {"study.html", "new"}}));
  EXPECT_EQ(text_of(folder / "later/study.html"), "of another program");
  EXPECT_EQ(files_in(folder / "later"), 1U);
}

TEST(ReportOutput, AnOldFileStaysWhereTheNewOneDoesNotFit) {
  const TemporaryFolder folder;
  write_old_report(folder);
  const auto place = report_place("study", into(folder / "", true), kFiles);
  ASSERT_TRUE(place);
  testing::internal::CaptureStderr();
  bool written = true;
  {
    const test::SizeLimit small(1000);
    written =
        write_report(*place, {{"study.csv", "new"}, {"study.html", std::string(5000, 'x')}}).has_value();
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_FALSE(written);
  EXPECT_NE(said.find("study.html: the file would grow beyond the allowed size"), said.npos) << said;
  EXPECT_EQ(text_of(folder / "study.html"), "old");
  EXPECT_EQ(files_in(folder / ""), 3U) << "nothing half done is left";
}

TEST(ReportOutput, OneProgramAtATimeWorksForAPlace) {
  const TemporaryFolder folder;
  write_old_report(folder);
  {
    const auto place = report_place("study", into(folder / "", true), kFiles);
    ASSERT_TRUE(place);
    testing::internal::CaptureStderr();
    EXPECT_FALSE(report_place("study", into(folder / "", true), kFiles));
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("another run is writing into "), said.npos) << said;
    EXPECT_TRUE(write_report(*place, {{"study.csv", "new"}}));
  }
  EXPECT_TRUE(report_place("study", into(folder / "", true), kFiles)) << "the first has ended";
}

TEST(ReportOutput, AFolderOfAFilesNameIsRefusedBeforeTheWork) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "study.csv");
  EXPECT_FALSE(report_place("study", into(folder / "", true), kFiles));
}

TEST(ReportOutput, WithoutAPlaceAFolderIsMadeWhenTheReportIsThere) {
  const TemporaryFolder data;
  const char* const before = std::getenv("XDG_DATA_HOME");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("XDG_DATA_HOME", (data / "").c_str(), 1);
  const auto place = report_place("study", into({}, false), kFiles);
  ASSERT_TRUE(place);
  EXPECT_EQ(files_in(data / "fulcrum/reports"), 0U);
  const auto folder = write_report(*place, {{"study.csv", "new"}});
  if (before != nullptr)
    ::setenv("XDG_DATA_HOME", kept.c_str(), 1);
  else
    ::unsetenv("XDG_DATA_HOME");
  ASSERT_TRUE(folder);
  EXPECT_EQ(folder->parent_path(), data / "fulcrum/reports");
  EXPECT_EQ(text_of(*folder / "study.csv"), "new");
}

}  // namespace
}  // namespace fulcrum::app
