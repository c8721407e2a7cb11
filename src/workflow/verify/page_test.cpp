#include "workflow/verify/page.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "workflow/verify/svg.hpp"

namespace sarsim::workflow::verify {
namespace page_test {

using testing::HasSubstr;
using testing::Not;

Finding near(double expected, double tolerance) {
  Finding finding;
  finding.expected = expected;
  finding.tolerance = tolerance;
  return finding;
}

TEST(VerifyPage, ShowsAsManyDigitsAsTheToleranceNeeds) {
  EXPECT_EQ(value_text(-101.48542669, near(-101.485, 0.0005)), "-101.48543");
  EXPECT_EQ(value_text(1.0 / 3.0, near(0.3, 0.1)), "0.333");
  EXPECT_EQ(value_text(0.0, near(0.0, 0.1)), "0");
  EXPECT_EQ(value_text(1.0000000000001, near(1.0, 1e-12)), "1.0000000000001");
  EXPECT_EQ(bound_text(near(1.0, 0.0)), "exact");
  EXPECT_EQ(bound_text(near(1.0, 0.02)), "+- 0.02");
}

TEST(VerifyPage, ShowsWhatDoesNotHold) {
  Record record({});
  record.group("a < b & c", [](Record& r) {
    r.near("good", "m", 1.0, 1.0, 0.1, "x");
    r.near("<bad>", "m", 1.0, 2.0, 0.1, "x");
    r.chart({{}, "a chart", "x", "y", {{"curve", {0.0, 1.0}, {0.0, 1.0}, false}}, false, false});
  });
  const std::string page = page_of(record, {{"Processor", "\"fast\""}});
  EXPECT_THAT(page, HasSubstr("1 of 2 comparisons agree"));
  EXPECT_THAT(page, HasSubstr("does not hold"));
  EXPECT_THAT(page, HasSubstr("&lt;bad&gt;"));
  EXPECT_THAT(page, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(page, HasSubstr("&quot;fast&quot;"));
  EXPECT_THAT(page, HasSubstr("<svg"));
}

TEST(VerifySvg, LeavesOutWhatNoAxisCanShow) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Chart chart{
      {},   "t",  "x", "y", {{"c", {1.0, 10.0, 0.0, -1.0, nan, 100.0}, {1.0, 2.0, 3.0, 4.0, 5.0, inf}, false}},
      true, false};
  const std::string svg = svg_of(chart);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  // The corners of the frame: the two points that are left span both axes.
  EXPECT_THAT(svg, HasSubstr("points=\"70.0,312.0 620.0,34.0 \""));
}

TEST(VerifySvg, DrawsChartsOfOnePointAndOfNone) {
  EXPECT_THAT(svg_of({{}, "t", "x", "y", {{"c", {5.0}, {7.0}, true}}, false, false}), HasSubstr("<circle"));
  EXPECT_THAT(svg_of({{}, "t", "x", "y", {}, true, true}), Not(HasSubstr("nan")));
}

TEST(VerifySvg, PutsTicksAtRoundNumbers) {
  const std::string svg = svg_of({{}, "t", "x", "y", {{"c", {0.0, 9.7}, {1e-9, 1e3}, false}}, false, true});
  for (const char* tick : {">0<", ">2<", ">8<", ">1e-08<", ">100<"}) EXPECT_THAT(svg, HasSubstr(tick)) << tick;
}

}  // namespace page_test
}  // namespace sarsim::workflow::verify
