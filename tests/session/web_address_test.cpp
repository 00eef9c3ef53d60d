#include "engine/session/web_address.h"

#include <gtest/gtest.h>

namespace fulcrum::session {
namespace {

std::string text_of(const std::string& typed) {
  const auto address = web_address(typed);
  return address ? address->text : "refused: " + address.error().sentence;
}

TEST(WebAddress, LosesItsSlash) {
  EXPECT_EQ(text_of("https://lrs.example/xapi/"), "https://lrs.example/xapi");
  EXPECT_EQ(text_of("https://lrs.example//"), "https://lrs.example");
  EXPECT_EQ(text_of("https://lrs.example"), "https://lrs.example");
  EXPECT_EQ(text_of("http://localhost:8080/a/../b%20c"), "http://localhost:8080/b%20c");
  EXPECT_TRUE(web_address("https://lrs.example")->encrypted);
  EXPECT_FALSE(web_address("http://lrs.example")->encrypted);
}

TEST(WebAddress, KnowsThisMachine) {
  for (const char* const typed :
       {"http://localhost", "http://localhost:1/x", "http://127.0.0.1", "http://[::1]:80/"})
    EXPECT_TRUE(web_address(typed)->loopback) << typed;
  for (const char* const typed : {"http://localhost.example", "http://127.0.0.1.example", "http://127.0.0.2",
                                  "http://[::2]", "http://0.0.0.0", "http://localhost.", "http://xlocalhost",
                                  "http://127.0.0.1%2eexample", "http://[::ffff:127.0.0.1]"}) {
    const auto address = web_address(typed);
    EXPECT_FALSE(address && address->loopback) << typed;
  }
}

TEST(WebAddress, RefusesWhatHidesSomething) {
  const std::string zero("https://lrs.example/\0x", 22);
  for (const std::string& typed : {std::string(),
                                   std::string("lrs.example/xapi"),
                                   std::string("ftp://lrs.example"),
                                   std::string("file:///etc/passwd"),
                                   std::string("https://"),
                                   std::string("https:///xapi"),
                                   std::string("https:/lrs.example"),
                                   std::string("https:lrs.example"),
                                   std::string("https:////lrs.example"),
                                   std::string("://lrs.example"),
                                   std::string("a://"),
                                   std::string("https://lrs.example/xapi?x=1"),
                                   std::string("https://lrs.example/xapi?"),
                                   std::string("https://lrs.example/#x"),
                                   std::string("https://lrs.example/a b"),
                                   std::string("https://lrs.example/\r\nX: y"),
                                   std::string("https://lrs.example/\x7f"),
                                   std::string("https://lrs.ex\xc3\xa4mple/"),
                                   zero,
                                   std::string("https://lrs.example/%"),
                                   std::string("https://lrs.example/%4"),
                                   std::string("https://lrs.example/%zz"),
                                   std::string("https://lrs.example:99999/"),
                                   std::string("https://lrs.example:x/"),
                                   std::string("https://[::1%25lo]/"),
                                   std::string("https://[fe80::1%251]/"),
                                   std::string("https://lrs.example\\@evil.example/"),
                                   std::string("javascript:alert(1)"),
                                   "https://lrs.example/" + std::string(3000, 'a')})
    EXPECT_EQ(text_of(typed).substr(0, 8), "refused:") << typed << " -> " << text_of(typed);
}

TEST(WebAddress, NamesNobody) {
  for (const char* const typed : {"https://anna:secret@lrs.example/", "https://anna@lrs.example/",
                                  "http://localhost:secret@evil.example/", "https://:secret@lrs.example/"}) {
    const std::string said = text_of(typed);
    EXPECT_NE(said.find("it names a user"), std::string::npos) << said;
    EXPECT_EQ(said.find("secret"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace fulcrum::session
