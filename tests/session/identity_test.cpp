#include "engine/session/identity.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace fulcrum::session {
namespace {

TEST(Identity, TakesPseudonyms) {
  for (const char* name : {"P07", "a", "Müller 3", "被験者7", "7-left_b", "A.B", "Åsa"})
    EXPECT_FALSE(refuse_pseudonym(name)) << name;
  EXPECT_FALSE(refuse_pseudonym(std::string(64, 'x')));
}

// NOLINTBEGIN(misc-misleading-bidirectional): they are what is refused.
TEST(Identity, RefusesWhatIsNotSeenOrIsAFormula) {
  for (const char* name : {"",
                           " ",
                           " P",
                           "P ",
                           "=1+1",
                           "+1",
                           "-1",
                           "@a",
                           "a\tb",
                           "a\nb",
                           "a\x7f",
                           "a\xc2\xa0",
                           "\xff",
                           "a\xc3",
                           "a\xe2\x80\x8b",
                           "a\xe2\x80\xae",
                           "a\xef\xbb\xbf",
                           "a\xf3\xa0\x80\xa0",
                           "'x",
                           "a\xc2\xad",
                           "P07\xe2\xa0\x80",
                           "e\xcc\x81",
                           "\xcc\x81",
                           "\xc3\x97"
                           "1",
                           "\xef\xbc\x9d"
                           "1"})
    EXPECT_TRUE(refuse_pseudonym(name)) << name;
  EXPECT_TRUE(refuse_pseudonym(std::string(65, 'x')));
  EXPECT_TRUE(refuse_pseudonym(std::string("a\0b", 3)));
}

// NOLINTEND(misc-misleading-bidirectional)

TEST(Identity, NamesAreRandomUuids) {
  const std::regex form("[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}");
  std::set<std::string> seen;
  for (int i = 0; i < 1000; ++i) {
    const std::string uuid = random_uuid();
    EXPECT_TRUE(std::regex_match(uuid, form)) << uuid;
    EXPECT_TRUE(seen.insert(uuid).second);
  }
}

TEST(Identity, TellsTimesToTheMillisecond) {
  using namespace std::chrono;
  EXPECT_EQ(utc_text(system_clock::time_point(milliseconds(1'700'000'000'007))), "2023-11-14T22:13:20.007Z");
}

}  // namespace
}  // namespace fulcrum::session
