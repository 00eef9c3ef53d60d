#include "engine/session/credentials.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/files/temporary_folder.h"

namespace fulcrum::session {
namespace {

namespace fs = std::filesystem;

class CredentialsFile : public testing::Test {
protected:
  Result<Credentials> read(const std::string& text, mode_t mode = 0600) {
    folder_.write("who", text);
    EXPECT_EQ(::chmod(path().c_str(), mode), 0);
    auto read = read_credentials(path());
    ::chmod(path().c_str(), 0600);
    return read;
  }
  std::string fault(const std::string& text, mode_t mode = 0600) {
    const auto who = read(text, mode);
    return who ? "" : who.error().sentence;
  }
  fs::path path() const { return folder_ / "who"; }

  test::TemporaryFolder folder_;
};

TEST_F(CredentialsFile, IsALineOfUserAndPassword) {
  for (const char* const text : {"anna:a:b c", "anna:a:b c\n", "anna:a:b c\r\n", "anna:a:b c\nmore\n"}) {
    const auto who = read(text);
    ASSERT_TRUE(who) << text;
    EXPECT_EQ(who->user, "anna");
    EXPECT_EQ(who->password, "a:b c");
  }
  EXPECT_EQ(read("\xc3\xa4nna:\xe2\x82\xac")->user, "\xc3\xa4nna");
}

TEST_F(CredentialsFile, IsNothingElse) {
  const std::string zero("anna:se\0cret", 12);
  for (const std::string& text :
       {std::string(), std::string("\n"), std::string("anna"), std::string(":secret"), std::string("anna:"),
        zero, std::string("anna:se\x01cret"), std::string("an\rna:secret"), std::string("anna:\xffsecret"),
        "anna:secret" + std::string(5000, 'x'), std::string("\nanna:secret")}) {
    const std::string said = fault(text);
    EXPECT_NE(said.find("USER:PASSWORD"), std::string::npos) << said;
    EXPECT_EQ(said.find("secret"), std::string::npos) << said;
  }
}

TEST_F(CredentialsFile, IsOpenToNobodyElse) {
  for (const mode_t mode : {0640u, 0604u, 0660u, 0644u, 0777u, 0700u, 0610u, 04600u}) {
    const std::string said = fault("anna:secret", mode);
    EXPECT_NE(said.find("chmod 600 " + path().string()), std::string::npos) << said;
  }
  EXPECT_TRUE(read("anna:secret", 0400));
  EXPECT_TRUE(read("anna:secret", 0600));
}

// By its link's mode, it would be open to all.
TEST_F(CredentialsFile, IsJudgedWhereLinksLead) {
  fs::create_symlink("who", folder_ / "link");
  folder_.write("who", "anna:secret");
  ::chmod(path().c_str(), 0600);
  EXPECT_TRUE(read_credentials(folder_ / "link"));
  ::chmod(path().c_str(), 0644);
  EXPECT_FALSE(read_credentials(folder_ / "link"));
}

TEST_F(CredentialsFile, IsAFile) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_NE(read_credentials(folder_ / "pipe").error().sentence.find("it is a pipe"), std::string::npos);
  EXPECT_NE(read_credentials(folder_ / "").error().sentence.find("it is a folder"), std::string::npos);
  EXPECT_NE(read_credentials(folder_ / "none").error().sentence.find("No such file"), std::string::npos);
}

// Whoever may write a file may choose who we are.
TEST_F(CredentialsFile, IsOnesOwn) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a file away";
  folder_.write("who", "anna:secret");
  ASSERT_EQ(::chown(path().c_str(), 12345, 12345), 0);
  ASSERT_EQ(::chmod(path().c_str(), 0600), 0);
  const auto who = read_credentials(path());
  ASSERT_FALSE(who);
  EXPECT_NE(who.error().sentence.find("belongs to another user"), std::string::npos) << who.error().sentence;
}

}  // namespace
}  // namespace fulcrum::session
