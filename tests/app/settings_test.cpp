// Settings: the panel as keys and presses see it, and the file that remembers them.

#include "engine/app/settings/settings.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/app/cli/terminal.h"
#include "engine/app/settings/settings_menu.h"
#include "tests/files/size_limit.h"

namespace fulcrum::app {
namespace {

using Key = StartMenu::Key;
using SettingsWish = SettingsMenu::Wish;
using ui::PaletteName;

TEST(SettingsMenu, ChangesEachSettingInARing) {
  SettingsMenu menu({});
  std::vector<float> sizes;
  for (int i = 0; i < 4; ++i) {
    sizes.push_back(menu.settings().look.text);
    EXPECT_EQ(menu.press(Key::right), SettingsWish::changed);
  }
  EXPECT_EQ(sizes, (std::vector<float>{1.0F, 1.25F, 1.5F, 1.0F}));
  EXPECT_EQ(menu.press(Key::left), SettingsWish::changed);
  EXPECT_EQ(menu.settings().look.text, 1.0F);
  EXPECT_EQ(menu.press(Key::down), SettingsWish::none);
  EXPECT_EQ(menu.press(Key::accept), SettingsWish::changed);
  EXPECT_EQ(menu.settings().look.palette, PaletteName::colour_blind);
  EXPECT_EQ(menu.press(Key::down), SettingsWish::none);
  EXPECT_FALSE(menu.settings().picture);
  EXPECT_EQ(menu.press(Key::left), SettingsWish::changed);
  EXPECT_EQ(menu.settings().picture, render::kQualityLevels.size() - 1);
  EXPECT_EQ(menu.press(Key::right), SettingsWish::changed);
  EXPECT_FALSE(menu.settings().picture) << "as measured again";
  EXPECT_EQ(menu.press(Key::down), SettingsWish::none);
  EXPECT_EQ(menu.settings().volume, 1.0F);
  EXPECT_EQ(menu.press(Key::right), SettingsWish::changed);
  EXPECT_EQ(menu.settings().volume, 0.0F);
  EXPECT_EQ(menu.page().rows.back().value, "off");
  EXPECT_EQ(menu.press(Key::left), SettingsWish::changed);
  EXPECT_EQ(menu.press(Key::left), SettingsWish::changed);
  EXPECT_EQ(menu.settings().volume, 0.75F);
}

TEST(SettingsMenu, GoesBackByItsButtonAndByEsc) {
  SettingsMenu menu({});
  EXPECT_EQ(menu.press(Key::up), SettingsWish::none);
  EXPECT_EQ(menu.page().focus, menu.page().rows.size()) << "the button";
  EXPECT_EQ(menu.press(Key::right), SettingsWish::none);
  EXPECT_EQ(menu.press(Key::accept), SettingsWish::back);
  EXPECT_EQ(menu.press(Key::down), SettingsWish::none);
  EXPECT_EQ(menu.press(Key::back), SettingsWish::back);
  EXPECT_EQ(menu.click({menu.page().rows.size(), 0}), SettingsWish::back);
}

TEST(SettingsMenu, ListensToPresses) {
  SettingsMenu menu({});
  EXPECT_EQ(menu.click({0, -1}), SettingsWish::changed);
  EXPECT_EQ(menu.settings().look.text, 1.5F);
  EXPECT_EQ(menu.click({0, 1}), SettingsWish::changed);
  EXPECT_EQ(menu.settings().look.text, 1.0F);
  EXPECT_EQ(menu.click({1, 0}), SettingsWish::changed);
  EXPECT_EQ(menu.settings().look.palette, PaletteName::colour_blind);
  EXPECT_EQ(menu.page().focus, 1U);
}

// A folder of its own for what a person sets. NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet.
class SettingsFile : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_NE(::mkdtemp(folder_.data()), nullptr);
    if (const char* const before = std::getenv("XDG_CONFIG_HOME")) kept_ = before;
    ::setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
    std::filesystem::create_directory(folder_ + "/fulcrum");
  }
  void TearDown() override {
    std::filesystem::remove_all(folder_);
    if (kept_)
      ::setenv("XDG_CONFIG_HOME", kept_->c_str(), 1);
    else
      ::unsetenv("XDG_CONFIG_HOME");
  }

  void write(const std::string& text) const { std::ofstream(file_()) << text; }
  std::string text(const char* end = "") const {
    std::ostringstream all;
    all << std::ifstream(file_() + end).rdbuf();
    return all.str();
  }
  // What is said of a file.
  std::string said_of(const std::string& text) {
    write(text);
    KeptComplaints kept;
    read = read_settings();
    return kept.take();
  }

  Settings read;

private:
  std::string file_() const { return folder_ + "/fulcrum/settings.json"; }
  std::string folder_ = "/tmp/fulcrum-settings-XXXXXX";
  std::optional<std::string> kept_;
};
// NOLINTEND(concurrency-mt-unsafe)

TEST_F(SettingsFile, IsReadAsItWasWritten) {
  KeptComplaints kept;
  EXPECT_EQ(read_settings().look.text, 1.0F) << "there is none at first";
  for (const float size : kTextSizes)
    for (const PaletteName palette : {PaletteName::standard, PaletteName::colour_blind})
      for (std::size_t level = 0; level <= render::kQualityLevels.size(); ++level) {
        Settings settings{{palette, size}, std::nullopt};
        if (level > 0) settings.picture = level - 1;
        settings.volume = kVolumes[level % kVolumes.size()];
        ASSERT_FALSE(write_settings(settings));
        const Settings back = read_settings();
        EXPECT_EQ(back.look.text, size);
        EXPECT_EQ(back.look.palette, palette);
        EXPECT_EQ(back.picture, settings.picture);
        EXPECT_EQ(back.volume, settings.volume);
      }
  EXPECT_EQ(kept.take(), "");
}

TEST_F(SettingsFile, WhatIsWrongIsToldAndTheRestIsTaken) {
  std::string said = said_of(R"({"text_size": 3, "palette": "colour_blind", "picture": "lowest"})");
  EXPECT_NE(said.find("'text_size'"), std::string::npos) << said;
  EXPECT_NE(said.find("from 1 to 1.5"), std::string::npos) << said;
  EXPECT_EQ(read.look.text, 1.0F);
  EXPECT_EQ(read.look.palette, PaletteName::colour_blind);
  EXPECT_EQ(read.picture, render::kQualityLevels.size() - 1);

  said = said_of(R"({"text_size": 1.5, "palette": "green", "picture": 7})");
  EXPECT_NE(said.find("standard, colour_blind"), std::string::npos) << said;
  EXPECT_NE(said.find("automatic, best"), std::string::npos) << said;
  EXPECT_EQ(read.look.text, 1.5F);
  EXPECT_EQ(read.look.palette, PaletteName::standard);
  EXPECT_FALSE(read.picture);

  said = said_of(R"({"volume": 11})");
  EXPECT_NE(said.find("from 0 to 1"), std::string::npos) << said;
  EXPECT_EQ(read.volume, 1.0F);

  said = said_of(R"({"text_sizes": 1.5})");
  EXPECT_NE(said.find("did you mean 'text_size'?"), std::string::npos) << said;
  EXPECT_EQ(read.look.text, 1.0F);
}

TEST_F(SettingsFile, WhatIsNoObjectIsToldAndLeavesAllAsAtFirst) {
  const std::string deep(4000, '[');
  for (const std::string& text : {std::string("{"), std::string("[1]"), std::string("7"), std::string(), deep,
                                  std::string(100000, ' '), std::string("\xff\xfe")}) {
    const std::string said = said_of(text);
    EXPECT_NE(said.find("settings.json"), std::string::npos) << text.substr(0, 20);
    EXPECT_EQ(read.look.text, 1.0F);
    EXPECT_FALSE(read.picture);
  }
  for (const char* text : {R"({"text_size": null})", R"({"text_size": "large"})", R"({"text_size": 1e999})",
                           R"({"text_size": [[]], "palette": {}, "picture": true})"}) {
    EXPECT_NE(said_of(text), "") << text;
    EXPECT_EQ(read.look.text, 1.0F) << text;
  }
}

TEST_F(SettingsFile, WhatCannotBeReadIsKeptBesideWhatReplacesIt) {
  const std::string torn = "{\n \"text_size\": 1.5,\n \"note\": \"mine\"";
  const std::string said = said_of(torn);
  EXPECT_NE(said.find("line 3 is no JSON"), std::string::npos) << said;
  EXPECT_NE(said.find("mend it"), std::string::npos) << said;
  KeptComplaints kept;
  ASSERT_FALSE(write_settings({{PaletteName::colour_blind, 1.25F}, 2}));
  EXPECT_NE(kept.take().find("settings.json.unread"), std::string::npos);
  EXPECT_EQ(text(".unread"), torn);
  EXPECT_EQ(read_settings().look.text, 1.25F);
  EXPECT_EQ(kept.take(), "");

  write("torn again");
  ASSERT_FALSE(write_settings({{PaletteName::colour_blind, 1.25F}, 2}));
  EXPECT_NE(kept.take().find("settings.json.unread-2"), std::string::npos);
  EXPECT_EQ(text(".unread"), torn);
  EXPECT_EQ(text(".unread-2"), "torn again");
}

TEST_F(SettingsFile, WhyItIsNotWrittenIsSaid) {
  const test::SizeLimit none(0);
  const std::optional<Error> failure = write_settings({{PaletteName::standard, 1.25F}, 2});
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->sentence.find("settings.json: the file would grow beyond the allowed size. Raise the "
                                   "limit (ulimit -f)."),
            std::string::npos)
      << failure->sentence;
  EXPECT_EQ(failure->sentence.find("--out"), std::string::npos) << failure->sentence;
}

TEST_F(SettingsFile, WhatOthersWroteIntoItStays) {
  const std::string nested = std::string(1900, '[') + '7' + std::string(1900, ']');
  write(R"({"someone": )" + nested + R"(, "palette": "colour_blind"})");
  ASSERT_FALSE(write_settings({{PaletteName::standard, 1.25F}, 2}));
  EXPECT_NE(text().find("\"someone\""), std::string::npos);
  EXPECT_NE(text().find("\"text_size\": 1.25"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app
