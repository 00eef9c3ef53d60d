// The start page as keys, presses and letters see it.

#include "engine/app/start/start_menu.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/app/cli/terminal.h"
#include "engine/app/start/start_settings.h"
#include "tests/files/size_limit.h"

namespace fulcrum::app {
namespace {

using Key = StartMenu::Key;
using Wish = StartMenu::Wish;
using Part = ui::StartPage::Part;

StartMenu menu_of(const StartChoice& choice = {}) {
  return {{{"ear", "Ear", "Into the ear.", "4 checkpoints"},
           {"piping", "Piping", "Behind the pipes.", "5 checkpoints"},
           {"broken", "Broken", "", "", "line 3: no such key"}},
          {{"mouse", "the mouse"}, {kShown, "the expert shows it"}},
          {"Ana", "P01"},
          choice};
}

void press(StartMenu& menu, std::initializer_list<Key> keys) {
  for (const Key key : keys) EXPECT_EQ(menu.press(key), Wish::none);
}

void write(StartMenu& menu, std::u32string_view name) {
  for (const char32_t letter : name) menu.type(letter);
}

TEST(StartMenu, BeginsWithTheFirstOfEverything) {
  const StartMenu menu = menu_of();
  EXPECT_EQ(menu.choice().scenario, "ear");
  EXPECT_EQ(menu.choice().device, "mouse");
  EXPECT_EQ(menu.choice().participant, "");
  EXPECT_FALSE(menu.choice().left_handed);
  EXPECT_EQ(menu.page().focus, Part::scenario);
  EXPECT_EQ(menu.page().about, "Into the ear.");
}

TEST(StartMenu, RemembersWhatIsStillThere) {
  const StartMenu menu = menu_of({"Ana", kShown, true, "piping"});
  EXPECT_EQ(menu.choice().participant, "Ana");
  EXPECT_EQ(menu.choice().device, kShown);
  EXPECT_TRUE(menu.choice().left_handed);
  EXPECT_EQ(menu.choice().scenario, "piping");
  const StartMenu gone = menu_of({"Bert", "falcon", false, "stick"});
  EXPECT_EQ(gone.choice().participant, "");
  EXPECT_EQ(gone.choice().device, "mouse");
  EXPECT_EQ(gone.choice().scenario, "ear");
}

TEST(StartMenu, GoesRoundEverythingWithTheArrows) {
  StartMenu menu = menu_of();
  std::vector<std::pair<Part, std::size_t>> seen;
  for (int i = 0; i < 9; ++i) {
    seen.emplace_back(menu.page().focus, menu.page().index);
    press(menu, {Key::down});
  }
  const std::vector<std::pair<Part, std::size_t>> all = {
      {Part::scenario, 0}, {Part::scenario, 1}, {Part::scenario, 2}, {Part::setting, 0}, {Part::setting, 1},
      {Part::setting, 2},  {Part::start, 2},    {Part::settings, 2}, {Part::end, 2}};
  EXPECT_EQ(seen, all);
  EXPECT_EQ(menu.page().focus, Part::scenario);
  EXPECT_EQ(menu.choice().scenario, "ear");
  press(menu, {Key::up});
  EXPECT_EQ(menu.page().focus, Part::end);
}

TEST(StartMenu, ChangesSettingsInARing) {
  StartMenu menu = menu_of();
  press(menu, {Key::down, Key::down, Key::down});
  std::vector<std::string> names;
  for (int i = 0; i < 4; ++i) {
    names.push_back(menu.choice().participant);
    press(menu, {Key::right});
  }
  EXPECT_EQ(names, (std::vector<std::string>{"", "Ana", "P01", "P02"})) << "the last one is new";
  EXPECT_EQ(menu.choice().participant, "");
  press(menu, {Key::left});
  EXPECT_EQ(menu.choice().participant, "P02");
  EXPECT_EQ(menu.page().settings[0].value, "P02 (new)");
  press(menu, {Key::down, Key::right});
  EXPECT_EQ(menu.choice().device, kShown);
  press(menu, {Key::down, Key::accept});
  EXPECT_TRUE(menu.choice().left_handed);
}

TEST(StartMenu, StartsAndEnds) {
  StartMenu menu = menu_of();
  EXPECT_EQ(menu.press(Key::accept), Wish::start);
  press(menu, {Key::right});
  EXPECT_EQ(menu.page().focus, Part::start);
  EXPECT_EQ(menu.press(Key::accept), Wish::start);
  press(menu, {Key::right});
  EXPECT_EQ(menu.press(Key::accept), Wish::settings);
  press(menu, {Key::right, Key::right});
  EXPECT_EQ(menu.press(Key::accept), Wish::end) << "the last button has none beside it";
  press(menu, {Key::left, Key::left, Key::left});
  EXPECT_EQ(menu.page().focus, Part::start);
  press(menu, {Key::back});
  EXPECT_EQ(menu.page().focus, Part::scenario);
  EXPECT_EQ(menu.press(Key::back), Wish::end);
}

TEST(StartMenu, TestsTheDeviceThatIsChosen) {
  StartMenu menu = menu_of();
  EXPECT_EQ(menu.click({Part::setting, 1, 0}), Wish::test) << "a press on its name";
  EXPECT_EQ(menu.press(Key::accept), Wish::test);
  EXPECT_NE(menu.page().help.find("tests it"), std::string::npos) << menu.page().help;
  EXPECT_EQ(menu.choice().device, "mouse") << "it is still the one that was chosen";
  press(menu, {Key::right});
  EXPECT_EQ(menu.choice().device, kShown);
  EXPECT_EQ(menu.press(Key::accept), Wish::none);
  EXPECT_NE(menu.page().note.find("nothing to test"), std::string::npos) << menu.page().note;
}

TEST(StartMenu, SaysWhyAScenarioCannotBeUsed) {
  StartMenu menu = menu_of();
  press(menu, {Key::down, Key::down});
  EXPECT_FALSE(menu.page().scenarios[2].usable);
  press(menu, {Key::accept});
  EXPECT_EQ(menu.page().note, "line 3: no such key");
  press(menu, {Key::up});
  EXPECT_EQ(menu.page().note, "") << "until something is chosen";
}

TEST(StartMenu, TakesANameLetterByLetter) {
  StartMenu menu = menu_of();
  press(menu, {Key::down, Key::down, Key::down, Key::accept});
  EXPECT_TRUE(menu.page().settings[0].written);
  write(menu, U"Jürg x");
  press(menu, {Key::erase, Key::erase});
  EXPECT_EQ(menu.page().settings[0].value, "Jürg");
  press(menu, {Key::erase, Key::erase, Key::erase});
  EXPECT_EQ(menu.page().settings[0].value, "J");
  write(menu, U"ü😀");
  press(menu, {Key::erase, Key::accept});
  EXPECT_EQ(menu.choice().participant, "Jü");
  // Those that are known are taken as they are.
  press(menu, {Key::accept});
  write(menu, U"Ana");
  press(menu, {Key::accept});
  EXPECT_EQ(menu.choice().participant, "Ana");
}

TEST(StartMenu, RefusesNamesThatCannotBe) {
  StartMenu menu = menu_of();
  press(menu, {Key::down, Key::down, Key::down, Key::accept});
  write(menu, U"=1+1");
  press(menu, {Key::accept});
  EXPECT_EQ(menu.choice().participant, "");
  EXPECT_NE(menu.page().note, "");
  EXPECT_EQ(menu.page().settings[0].value, "=1+1") << "it may be mended";
  EXPECT_EQ(menu.click({Part::start, 0}), Wish::none) << "a trial would be somebody else's";
  EXPECT_NE(menu.page().note, "");
  press(menu, {Key::back, Key::accept});
  for (int i = 0; i < 1000; ++i) menu.type(U'x');
  menu.type(U'\n');
  menu.type(0x110000);
  press(menu, {Key::accept});
  EXPECT_EQ(menu.choice().participant, "") << "too long";
  press(menu, {Key::back});
  press(menu, {Key::accept, Key::accept});
  EXPECT_EQ(menu.choice().participant, "") << "an empty name is none";
  write(menu, U"typed while nothing is written");
  press(menu, {Key::accept});
  write(menu, U"left");
  press(menu, {Key::back});
  EXPECT_EQ(menu.choice().participant, "");
}

TEST(StartMenu, ListensToPresses) {
  StartMenu menu = menu_of();
  EXPECT_EQ(menu.click({Part::scenario, 1}), Wish::none);
  EXPECT_EQ(menu.choice().scenario, "piping");
  EXPECT_EQ(menu.click({Part::scenario, 1}), Wish::start) << "a second press starts it";
  EXPECT_EQ(menu.click({Part::setting, 1, 1}), Wish::none);
  EXPECT_EQ(menu.choice().device, kShown);
  EXPECT_EQ(menu.click({Part::setting, 0, 0}), Wish::none);
  write(menu, U"Eva");
  EXPECT_EQ(menu.click({Part::start, 0}), Wish::start);
  EXPECT_EQ(menu.choice().participant, "Eva") << "a press elsewhere takes the name";
  EXPECT_EQ(menu.click({Part::settings, 0}), Wish::settings);
  EXPECT_EQ(menu.click({Part::end, 0}), Wish::end);
}

TEST(StartMenu, StandsWithoutAScenario) {
  StartMenu menu({}, {{"mouse", "the mouse"}}, {}, {});
  EXPECT_EQ(menu.press(Key::accept), Wish::none);
  EXPECT_NE(menu.page().about, "");
  for (int i = 0; i < 6; ++i) press(menu, {Key::down});
  EXPECT_EQ(menu.choice().scenario, "");
}

// NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet.
TEST(StartSettings, AreReadBackAndNothingElseIsTaken) {
  std::string folder = "/tmp/fulcrum-start-XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const char* const before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  EXPECT_EQ(read_start_choice().scenario, "");
  ASSERT_FALSE(write_start_choice({"Jü", "spacemouse+dualsense", true, "piping"}));
  const StartChoice choice = read_start_choice();
  EXPECT_EQ(choice.participant, "Jü");
  EXPECT_EQ(choice.device, "spacemouse+dualsense");
  EXPECT_TRUE(choice.left_handed);
  EXPECT_EQ(choice.scenario, "piping");
  {
    const test::SizeLimit none(0);
    EXPECT_FALSE(forget_start_participant("nobody")) << "there is nothing to forget";
    const std::optional<Error> failure = forget_start_participant("Jü");
    ASSERT_TRUE(failure);
    EXPECT_NE(failure->sentence.find("start.json: the file would grow beyond the allowed size. "),
              std::string::npos)
        << failure->sentence;
  }
  EXPECT_EQ(read_start_choice().participant, "Jü");
  for (const char* text :
       {"", "{", "[]", "7", "{\"participant\": 7, \"left_handed\": \"yes\"}",
        "{\"participant\": \"=1\", \"scenario\": null}", "\xff\xfe", "{\"participant\": \"\\u0000\"}"}) {
    std::ofstream(folder + "/fulcrum/start.json") << text;
    EXPECT_EQ(read_start_choice().participant, "") << text;
    EXPECT_FALSE(read_start_choice().left_handed) << text;
  }
  std::filesystem::remove_all(folder);
  if (before == nullptr)
    ::unsetenv("XDG_CONFIG_HOME");
  else
    ::setenv("XDG_CONFIG_HOME", kept.c_str(), 1);
}

// NOLINTEND(concurrency-mt-unsafe)

TEST(KeptComplaints, AreKeptWhileSomebodyWantsThem) {
  complain("before");
  KeptComplaints kept;
  EXPECT_EQ(kept.take(), "");
  complain("One.");
  complain("Two.");
  EXPECT_EQ(kept.take(), "One. Two.");
  EXPECT_EQ(kept.take(), "");
}

}  // namespace
}  // namespace fulcrum::app
