// Where a Falcon's firmware is looked for, and what is refused.

#include "drivers/falcon/falcon_firmware.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace fulcrum::test {
namespace {

class FalconFirmware : public testing::Test {
protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("falcon_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "fulcrum");
    unsetenv("FULCRUM_FALCON_FIRMWARE");
    setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("FULCRUM_FALCON_FIRMWARE");
    unsetenv("XDG_CONFIG_HOME");
    std::filesystem::remove_all(folder);
  }
  static void put(const std::filesystem::path& file, std::size_t length) {
    std::ofstream(file, std::ios::binary) << std::string(length, '\xfe');
  }
  std::filesystem::path folder;
};

TEST_F(FalconFirmware, OneThatIsMissingIsSaidWithWhereItComesFromAndGoes) {
  const auto none = falcon::find_firmware();
  ASSERT_FALSE(none);
  for (const std::string& part : {(folder / "fulcrum" / "falcon_firmware.bin").string(),
                                  std::string("FULCRUM_FALCON_FIRMWARE"), std::string("libnifalcon")})
    EXPECT_NE(none.error().sentence.find(part), std::string::npos) << none.error().sentence;
}

TEST_F(FalconFirmware, ItIsReadFromItsPlaceOrFromWhereItIsNamed) {
  put(folder / "fulcrum" / "falcon_firmware.bin", 100);
  const auto found = falcon::find_firmware();
  ASSERT_TRUE(found) << found.error().sentence;
  EXPECT_EQ(*found, std::vector<std::uint8_t>(100, 0xfe));
  put(folder / "other.bin", 50);
  setenv("FULCRUM_FALCON_FIRMWARE", (folder / "other.bin").c_str(), 1);
  EXPECT_EQ(falcon::find_firmware()->size(), 50u);
}

TEST_F(FalconFirmware, WhatIsNoneIsRefused) {
  const auto refusal = [](const std::filesystem::path& file) {
    setenv("FULCRUM_FALCON_FIRMWARE", file.c_str(), 1);
    const auto found = falcon::find_firmware();
    return found ? "" : found.error().sentence;
  };
  put(folder / "empty", 0);
  put(folder / "most", 256 * 1024);
  put(folder / "large", 256 * 1024 + 1);
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(refusal(folder / "empty").find("it is empty"), std::string::npos);
  EXPECT_EQ(refusal(folder / "most"), "");
  EXPECT_NE(refusal(folder / "large").find("larger than 256 KiB"), std::string::npos);
  EXPECT_NE(refusal(folder / "pipe").find("it is a pipe"), std::string::npos);
  EXPECT_NE(refusal(folder).find("it is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder / "nothing").find("No such file"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::test
