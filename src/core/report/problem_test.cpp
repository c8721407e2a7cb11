#include "core/report/problem.hpp"

#include <gtest/gtest.h>

namespace sarsim::core {
namespace problem_test {

Problem problem(Severity severity, std::string message, Subject subject = {}, Place place = {}) {
  Problem made;
  made.severity = severity;
  made.message = std::move(message);
  made.subject = std::move(subject);
  made.place = std::move(place);
  return made;
}

TEST(Problem, PrintsItsPlaceSeverityAndTexts) {
  Problem p = problem(Severity::error, "pulse width is not a number", {}, {"a.scr", 12, 3});
  p.found = "8oo";
  p.expected = "a number in ns";
  EXPECT_EQ(to_string(p), "a.scr:12:3: error: pulse width is not a number; found '8oo', expected a number in ns");
}

TEST(Problem, GivesNoOrdersToATerminal) {
  Problem p = problem(Severity::error, "a\x1b[31mb\x7f\tc\r", {}, {"\x07.scr", 0, 0});
  p.found =
      "\xC2\x9B"
      "2J\xC3\xA9";
  EXPECT_EQ(to_string(p), "\\x07.scr: error: a\\x1b[31mb\\x7f\tc\\x0d; found '\\u009b2J\xC3\xA9'");
}

TEST(Problem, ShowsWhatEndsOrTurnsALineUnseen) {
  EXPECT_EQ(printable("a\xE2\x80\xA8z\xE2\x80\xAE\xE2\x81\xA9"), "a\\u2028z\\u202e\\u2069");
  EXPECT_EQ(printable("5 \xE2\x80\x93 6 \xE2\x82\xAC\xE2\x80"), "5 \xE2\x80\x93 6 \xE2\x82\xAC\xE2\\x80");
}

TEST(Problem, PrintsOnlyWhatItKnows) {
  Problem p = problem(Severity::warning, "odd");
  EXPECT_EQ(to_string(p), "warning: odd");
  p.place.file = "a.scr";
  EXPECT_EQ(to_string(p), "a.scr: warning: odd");
  p.place.line = 4;
  EXPECT_EQ(to_string(p), "a.scr:4: warning: odd");
  p.place.file = "";
  EXPECT_EQ(to_string(p), "4: warning: odd");
  p.place = {};
  p.expected = "even";
  EXPECT_EQ(to_string(p), "warning: odd; expected even");
  p.expected = "";
  p.found = "7";
  EXPECT_EQ(to_string(p), "warning: odd; found '7'");
}

TEST(Problem, PrintsNoColumnWithoutALine) {
  EXPECT_EQ(to_string(problem(Severity::note, "so", {}, {"a.scr", 0, 5})), "a.scr: note: so");
}

TEST(Problem, PrintsItsCountAndItsHintOnALineOfItsOwn) {
  Problem p = problem(Severity::note, "seen");
  p.count = 3;
  p.hint = "Look again.";
  EXPECT_EQ(to_string(p), "note: seen (3 times)\n    Look again.");
}

TEST(ProblemBuilder, SaysWhatItIsToldAndLeavesTheRestEmpty) {
  const Problem p = warning("the PRF is low")
                        .found("90 Hz")
                        .expected("200 Hz")
                        .hint("raise it")
                        .at("radar", 2, "prf_hz")
                        .in("a.scr", 4, 7)
                        .times(3);
  EXPECT_EQ(p.severity, Severity::warning);
  EXPECT_EQ(to_string(p), "a.scr:4:7: warning: the PRF is low; found '90 Hz', expected 200 Hz (3 times)\n    raise it");
  EXPECT_EQ(p.subject, (Subject{"radar", 2, "prf_hz"}));
  const Problem bare = note("so");
  EXPECT_EQ(to_string(bare), "note: so");
  EXPECT_EQ(bare.subject, Subject{});
  EXPECT_EQ(bare.place, Place{});
  EXPECT_EQ(bare.count, 1U);
}

TEST(ProblemBuilder, TakesObjectAndPlaceWhole) {
  const Problem p = error("wrong").at(Subject{"cloud", 1, "file"}).in(Place{"b.toml", 3, 2});
  EXPECT_EQ(p.severity, Severity::error);
  EXPECT_EQ(p.subject, (Subject{"cloud", 1, "file"}));
  EXPECT_EQ(p.place, (Place{"b.toml", 3, 2}));
}

TEST(ProblemBuilder, KeepsTheRuleAndShowsItNowhere) {
  const Problem p = warning("prf.low", "the PRF is low").found("90 Hz");
  EXPECT_EQ(p.id.name(), "prf.low");
  EXPECT_EQ(to_string(p), "warning: the PRF is low; found '90 Hz'");
  EXPECT_EQ(Problem(error("unreadable")).id.name(), "");
  EXPECT_EQ(Problem(ProblemBuilder(Severity::note, "echoes.late", "late")).id.name(), "echoes.late");
  EXPECT_EQ(Problem(error("a.b", "c")).severity, Severity::error);
  EXPECT_EQ(Problem(note("a.b", "c")).severity, Severity::note);
}

TEST(ProblemBuilder, BecomesAProblemOfAList) {
  Problems problems{error("a")};
  problems.push_back(ProblemBuilder(Severity::note, "b"));
  append(problems, {warning("c"), note("d")});
  std::string all;
  for (const Problem& p : problems) all += to_string(p) + "\n";
  EXPECT_EQ(all, "error: a\nnote: b\nwarning: c\nnote: d\n");
}

TEST(Problems, HaveErrorsOnlyWhereOneIsAnError) {
  EXPECT_FALSE(has_errors({}));
  EXPECT_FALSE(has_errors({problem(Severity::warning, "a"), problem(Severity::note, "b")}));
  EXPECT_TRUE(has_errors({problem(Severity::warning, "a"), problem(Severity::error, "b")}));
}

std::string order(const Problems& problems) {
  std::string messages;
  for (const Problem& p : problems) messages += p.message + std::to_string(p.count);
  return messages;
}

TEST(Ranked, PutsErrorsFirstAndNotesLastKeepingTheOrderWithin) {
  const Problems problems =
      ranked({problem(Severity::note, "n"), problem(Severity::warning, "w"), problem(Severity::error, "f"),
              problem(Severity::warning, "v"), problem(Severity::error, "e")});
  EXPECT_EQ(order(problems), "f1e1w1v1n1");
}

TEST(Ranked, MergesOneCauseAndAddsTheCounts) {
  Problem many = problem(Severity::warning, "w", {"target", 4, "rcs_m2"});
  many.count = 5;
  const Problems problems = ranked({problem(Severity::warning, "w", {"target", 0, "rcs_m2"}), many});
  EXPECT_EQ(order(problems), "w6");
  EXPECT_EQ(problems[0].subject.index, 0U);
}

TEST(Ranked, KeepsCausesApartThatDifferInAnything) {
  const Subject subject{"target", 0, "rcs_m2"};
  const Problems problems =
      ranked({problem(Severity::warning, "w", subject), problem(Severity::note, "w", subject),
              problem(Severity::warning, "v", subject), problem(Severity::warning, "w", {"radar", 0, "rcs_m2"}),
              problem(Severity::warning, "w", {"target", 0, "platform"})});
  EXPECT_EQ(problems.size(), 5U);
}

TEST(Ranked, LeavesErrorsWithAPlaceAlone) {
  const Problems placed =
      ranked({problem(Severity::error, "e", {}, {"a", 1, 1}), problem(Severity::error, "e", {}, {"a", 2, 1})});
  EXPECT_EQ(placed.size(), 2U);
  const Problems unplaced = ranked({problem(Severity::error, "e"), problem(Severity::error, "e")});
  EXPECT_EQ(unplaced.size(), 1U);
  const Problems warnings =
      ranked({problem(Severity::warning, "w", {}, {"a", 1, 1}), problem(Severity::warning, "w", {}, {"a", 2, 1})});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].place.line, 1U);
}

TEST(Ranked, TellsACauseThatIsMetTooOftenOnce) {
  Problems many;
  for (std::size_t line = 1; line <= 65'536; ++line) many.push_back(problem(Severity::error, "e", {}, {"a", line, 1}));
  many.push_back(problem(Severity::error, "other", {}, {"a", 7, 1}));
  const Problems told = ranked(many);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].count, 65'536U);
  EXPECT_EQ(told[0].place.line, 1U);
  EXPECT_EQ(told[1].message, "other");
  many.resize(100);
  EXPECT_EQ(ranked(many).size(), 100U);
}

// Compared each with each, as many different causes would take minutes.
TEST(Ranked, TakesManyCauses) {
  Problems many;
  for (std::size_t i = 0; i < 200'000; ++i) many.push_back(problem(Severity::warning, "w" + std::to_string(i)));
  EXPECT_EQ(ranked(many).size(), 200'000U);
}

TEST(Printable, SpellsOutWhatGivesOrdersToATerminal) {
  EXPECT_EQ(printable("a\x1b[31m\x7f\n\t"), "a\\x1b[31m\\x7f\n\t");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\u009b31m");  // CSI in UTF-8
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "\\x9b31m");                            // and in 8 bits
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\u202e");  // turns the direction
  EXPECT_EQ(printable("\xd8\x9c\xe2\x80\x8f"), "\\u061c\\u200f");
  EXPECT_EQ(printable("\xe2\x80\xa8"), "\\u2028");  // ends a line
  EXPECT_EQ(printable("\xc3\xbc \xe2\x82\xac \xf0\x9f\x9b\xb0"), "\xc3\xbc \xe2\x82\xac \xf0\x9f\x9b\xb0");
  EXPECT_EQ(printable("\xfc"), "\xfc");  // Latin-1 that is no order
}

TEST(Problem, IsPrintedWithinBounds) {
  Problem p = problem(Severity::error, std::string(1'000'000, 'm'));
  p.found = std::string(1'000'000, '1');
  EXPECT_LT(to_string(p).size(), 5000U);
}

}  // namespace problem_test
}  // namespace sarsim::core
