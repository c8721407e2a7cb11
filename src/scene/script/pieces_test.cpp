#include "scene/script/pieces.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sarsim::scene::script {

namespace pieces_test {

std::vector<std::string> parts_of(std::string_view text, std::size_t piece_bytes, unsigned threads = 1) {
  std::vector<std::string> parts;
  for (const Piece& piece : cut(Tokens(text), piece_bytes, {threads}))
    parts.emplace_back(text.substr(piece.begin, piece.end - piece.begin));
  return parts;
}

using Parts = std::vector<std::string>;

TEST(Pieces, BeginWithTheCommandsThatBeginALine) {
  EXPECT_EQ(parts_of("! head\n$A 1\n 2\n$B $C\n, \t$D\r\n\n$E", 1),
            (Parts{"! head\n", "$A 1\n 2\n", "$B $C\n", ", \t$D\r\n\n", "$E"}));
}

TEST(Pieces, AreNotBegunByDollarsInCommentsQuotesAndWords) {
  const std::string_view text = "$A 1 ! $B\n!$C\n\"$D\"\n1$E\n2 $F\n";
  EXPECT_EQ(parts_of(text, 1), (Parts{std::string(text)}));
}

TEST(Pieces, EndLinesWithCarriageReturnsOnlyWhereThereAreNoLineFeeds) {
  EXPECT_EQ(parts_of("$A\r$B\r", 1), (Parts{"$A\r", "$B\r"}));
  // With line feeds around, a carriage return is a blank, and a comment goes on behind it.
  EXPECT_EQ(parts_of("$A ! \r$B\n\r$C", 1), (Parts{"$A ! \r$B\n", "\r$C"}));
}

TEST(Pieces, AreAtLeastAsLongAsWanted) {
  const std::string_view text = "$A\n$B\n$C\n$D\n$E\n";
  EXPECT_EQ(parts_of(text, 3), (Parts{"$A\n", "$B\n", "$C\n", "$D\n", "$E\n"}));
  EXPECT_EQ(parts_of(text, 4), (Parts{"$A\n$B\n", "$C\n$D\n", "$E\n"}));
  EXPECT_EQ(parts_of(text, 1000), (Parts{std::string(text)}));
}

TEST(Pieces, OfTextWithoutCommandsAreOne) {
  for (const std::string_view text : {"", "\n", "no command\n", "\n\n\n"})
    EXPECT_EQ(parts_of(text, 1), (Parts{std::string(text)}));
}

TEST(Pieces, LeaveOutMarksAtTheEndOfTheText) { EXPECT_EQ(parts_of("$A\n$B\x1A\x1A", 1), (Parts{"$A\n", "$B"})); }

TEST(Pieces, KnowTheirLinesForAnyNumberOfThreads) {
  std::string text = "first\n";
  for (int i = 0; i < 500; ++i) text += "$A\n" + std::string(static_cast<std::size_t>(i % 300), '\n') + "1 2 ! 3\n";
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    const Tokens whole(text);
    const std::vector<Piece> pieces = cut(whole, 1, {threads});
    ASSERT_EQ(pieces.size(), 501U);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_EQ(pieces[i].first_line, token_at(text, pieces[i].begin).line);
      EXPECT_EQ(whole.from_line(pieces[i].begin, pieces[i].first_line).peek().line, pieces[i].first_line);
      if (i + 1 < pieces.size()) {
        EXPECT_EQ(pieces[i].end_line, pieces[i + 1].first_line);
      }
    }
  }
}

}  // namespace pieces_test
}  // namespace sarsim::scene::script
