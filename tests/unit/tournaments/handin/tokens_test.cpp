// SPDX-License-Identifier: MIT
//
// Catches a token that is kept where it can be read, one that is worth something after its end, and
// one that can be guessed from another.
#include "tournaments/handin/tokens.hpp"

#include "system/digest.hpp"
#include "tests/support/memory_files.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <set>

namespace mirocup::league {
namespace {

const std::string monday = "2026-11-30T12:00:00Z";
const std::string tuesday = "2026-12-01T12:00:00Z";

TEST(Tokens, AreWordsOf128RandomBitsOfWhichOnlyAHashIsKept) {
  test_support::MemoryFiles files;
  const Folder folder{"l"};
  TokenList list;
  std::set<std::string> words;
  for (int i = 0; i < 100; ++i) words.insert(list.add("alpha", monday, ""));
  EXPECT_EQ(words.size(), 100u);
  for (const std::string& word : words) {
    EXPECT_EQ(word.size(), 26u);
    EXPECT_EQ(word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ234567"), std::string::npos);
  }
  for (const Role role : {Role::staff, Role::tutor}) (void)list.add_for(role, "Zoë", monday, "");
  ASSERT_TRUE(write_tokens(files, folder, list));
  const std::string text = *files.read(tokens_path(folder));
  for (const std::string& word : words) EXPECT_EQ(text.find(word), std::string::npos);
  const auto read = read_tokens(files, folder);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->tokens, list.tokens);
}

TEST(Tokens, AreTakenAsAPersonTypesThem) {
  TokenList list;
  std::string word = list.add("alpha", monday, "");
  ASSERT_NE(list.find(word, monday), nullptr);
  EXPECT_EQ(list.find(word, monday)->team, "alpha");
  for (char& c : word) c = static_cast<char>(std::tolower(c));
  EXPECT_NE(list.find(" " + word.substr(0, 5) + " " + word.substr(5) + "\n", monday), nullptr);
  EXPECT_EQ(list.find("", monday), nullptr);
  EXPECT_EQ(list.find(word + "A", monday), nullptr);
  EXPECT_EQ(list.find(system::sha256(word), monday), nullptr) << "what is kept is no token";
}

TEST(Tokens, EndWhenTheyExpireOrAreRevoked) {
  TokenList list;
  const std::string brief = list.add("alpha", monday, tuesday);
  const std::string lasting = list.add("alpha", monday, "");
  const std::string other = list.add("beta", monday, "");
  const std::string staff = list.add_for(Role::staff, "", monday, "");
  EXPECT_NE(list.find(brief, monday), nullptr);
  EXPECT_EQ(list.find(brief, tuesday), nullptr) << "the moment of the end is too late";
  EXPECT_EQ(list.find(staff, monday)->role, Role::staff);
  EXPECT_EQ(list.revoke(Role::team, "alpha", "", tuesday), 1) << "one had expired";
  EXPECT_EQ(list.find(lasting, tuesday), nullptr);
  EXPECT_EQ(list.revoke(Role::team, "alpha", "", tuesday), 0);
  EXPECT_NE(list.find(other, tuesday), nullptr);
  EXPECT_NE(list.find(staff, tuesday), nullptr);
  EXPECT_FALSE(list.has_valid("alpha", tuesday));
  const std::string max = list.add_for(Role::staff, "Max", monday, "");
  EXPECT_EQ(list.revoke(Role::staff, "", "Max", tuesday), 1);
  EXPECT_EQ(list.find(max, tuesday), nullptr);
  EXPECT_NE(list.find(staff, tuesday), nullptr) << "of another person";
  EXPECT_EQ(list.find_ended(lasting, tuesday)->revoked, tuesday);
}

TEST(Tokens, OfADamagedFileAreNone) {
  test_support::MemoryFiles files;
  const Folder folder{"l"};
  EXPECT_TRUE(read_tokens(files, folder)->tokens.empty());
  const std::string head = R"({"schema":"mirocup/tokens/1","tokens":[{"sha256":"","made":null,)";
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string(R"({"schema":"mirocup/tokens/1"})"),
        head + R"("team":"../x","expires":null,"revoked":null}]})",
        head + R"("team":"a","expires":"soon","revoked":null}]})",
        head + R"("team":null,"role":"head","expires":null,"revoked":null}]})"}) {
    ASSERT_TRUE(files.write(tokens_path(folder), text));
    ASSERT_FALSE(read_tokens(files, folder)) << text;
    EXPECT_EQ(read_tokens(files, folder).error().code, Errc::damaged);
  }
}

}  // namespace
}  // namespace mirocup::league
