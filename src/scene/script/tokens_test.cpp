#include "scene/script/tokens.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sarsim::scene::script {

namespace tokens_test {

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  for (Tokens tokens(text); tokens.peek().kind != TokenKind::end;) {
    const Token token = tokens.take();
    result.push_back((token.kind == TokenKind::command ? "$" : "") + name_text(token));
  }
  return result;
}

using Words = std::vector<std::string>;

TEST(Tokens, AreSeparatedByAnyMixOfBlanksTabsCommasAndLineEnds) {
  EXPECT_EQ(words("a b\tc,d\r\ne ,\t, f"), (Words{"a", "b", "c", "d", "e", "f"}));
}

TEST(Tokens, LeaveOutComments) { EXPECT_EQ(words("a ! b c\nd !\n!e\nf"), (Words{"a", "d", "f"})); }

TEST(Tokens, LetACommentBeginWithinAWordAndSaySo) {
  Tokens tokens("12!note\n13");
  EXPECT_TRUE(tokens.peek().comment_follows);
  EXPECT_EQ(tokens.take().text, "12");
  EXPECT_FALSE(tokens.peek().comment_follows);
  EXPECT_EQ(tokens.take().text, "13");
}

TEST(Tokens, KnowTheirLineAndColumn) {
  Tokens tokens("\r\n  ab, cd ! x\r\n\t$RADAR ef");
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{2, 3}, {2, 7}, {3, 2}, {3, 9}};
  for (const auto& [line, column] : expected) {
    EXPECT_EQ(tokens.peek().line, line);
    EXPECT_EQ(tokens.peek().column, column);
    static_cast<void>(tokens.take());
  }
  EXPECT_EQ(tokens.peek().kind, TokenKind::end);
}

TEST(Tokens, TakeACommandWithBlanksOrFurtherDollarsBeforeItsWord) {
  EXPECT_EQ(words("$ RADAR $$TARGET"), (Words{"$RADAR", "$TARGET"}));
}

TEST(Tokens, DoNotLookForACommandWordOnTheNextLine) { EXPECT_EQ(words("$\r\nRADAR"), (Words{"$", "RADAR"})); }

TEST(Tokens, KeepADollarWithinAWord) { EXPECT_EQ(words("5$TARGET"), Words{"5$TARGET"}); }

TEST(Tokens, TakeQuotedTextAsOneToken) {
  EXPECT_EQ(words("\"a b,c!d\" e \"\" \"$x\""), (Words{"a b,c!d", "e", "", "$x"}));
}

TEST(Tokens, TakeADoubledQuoteAsAQuote) { EXPECT_EQ(words("\"say \"\"so\"\"\" x"), (Words{"say \"so\"", "x"})); }

TEST(Tokens, EndAnOpenQuoteWithItsLineAndSaySo) {
  Tokens tokens("\"ab\ncd");
  EXPECT_TRUE(tokens.peek().open_quote);
  EXPECT_EQ(tokens.take().text, "ab");
  EXPECT_EQ(tokens.take().text, "cd");
}

TEST(Tokens, PassOverAByteOrderMark) {
  Tokens tokens("\xEF\xBB\xBF$RADAR");
  EXPECT_EQ(tokens.peek().kind, TokenKind::command);
  EXPECT_EQ(tokens.peek().column, 1U);
}

TEST(Tokens, EndLinesWithCarriageReturnsWhereThereAreNoLineFeeds) {
  Tokens tokens("! x\ra b\rc");
  EXPECT_EQ(tokens.peek().text, "a");
  EXPECT_EQ(tokens.peek().line, 2U);
}

TEST(Tokens, StayAtTheEnd) {
  Tokens tokens("");
  EXPECT_EQ(tokens.take().kind, TokenKind::end);
  EXPECT_EQ(tokens.take().kind, TokenKind::end);
}

TEST(FindControlByte, FindsWhatNoTextHolds) {
  EXPECT_EQ(find_control_byte(std::string_view("ab\0c", 4)), 2U);
  EXPECT_EQ(find_control_byte("a\x1B"), 1U);
  EXPECT_EQ(find_control_byte("\t\r\n\xB0 \xFF~"), std::string_view::npos);
}

TEST(FindControlByte, ToleratesAnEndOfFileMarkAtTheEndOnly) {
  EXPECT_EQ(find_control_byte("ab\x1A\x1A"), std::string_view::npos);
  EXPECT_EQ(find_control_byte("a\x1A b"), 1U);
}

TEST(QuotedWhereNeeded, QuotesOnlyWhatWouldNotBeReadBack) {
  EXPECT_EQ(quoted_where_needed("Radar_1.a$b\"c"), "Radar_1.a$b\"c");
  EXPECT_EQ(quoted_where_needed("a b"), "\"a b\"");
  EXPECT_EQ(quoted_where_needed("\"a"), "\"\"\"a\"");
  EXPECT_EQ(quoted_where_needed(""), "\"\"");
  EXPECT_EQ(quoted_where_needed("$a"), "\"$a\"");
}

}  // namespace tokens_test
}  // namespace sarsim::scene::script
