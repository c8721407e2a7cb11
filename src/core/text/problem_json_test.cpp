#include "core/text/problem_json.hpp"

#include <gmock/gmock.h>

#include "core/text/counted.hpp"

namespace sarsim::core {
namespace problem_json_test {

using testing::HasSubstr;

TEST(ProblemJson, HoldsThePlaceOfAProblem) {
  Problem problem;
  problem.severity = Severity::warning;
  problem.message = "m";
  problem.place = {"a.scr", 3, 7};
  JsonWriter json;
  write_json(json, problem);
  for (const char* member : {"\"severity\": \"warning\"", "\"file\": \"a.scr\"", "\"line\": 3", "\"column\": 7"})
    EXPECT_THAT(json.text(), HasSubstr(member));
}

TEST(Counted, CountsThings) {
  EXPECT_EQ(counted(0, "turn"), "0 turns");
  EXPECT_EQ(counted(1, "turn"), "1 turn");
  EXPECT_EQ(counted(2, "turn"), "2 turns");
}

}  // namespace problem_json_test
}  // namespace sarsim::core
