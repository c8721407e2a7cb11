#include "workflow/sweep/sweep_table.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace sarsim::workflow {
namespace sweep_table_test {

using testing::HasSubstr;
using testing::StartsWith;

class SweepTable : public testing::Test {
 protected:
  static scene::Scene scene() {
    scene::Scene scene;
    scene.radars.resize(1);
    scene.radars[0].pulse = scene::Radar::Pulse::chirp;
    scene.simulations.resize(1);
    scene.simulations[0].file = "a,b.bin";
    return scene;
  }

  static std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> found(1);
    for (const char c : text) {
      if (c == '\n')
        found.emplace_back();
      else
        found.back() += c;
    }
    found.pop_back();
    return found;
  }

  Sweep sweep_{scene(), {{"Radar1.bandwidth=1MHz,2MHz", "seed=1..2"}, false}};
  std::vector<workflow::ProductJob> products_{{false, 0, "a.bin"}, {true, 1, "t.txt"}};
  core::Problems problems_;
  SweepFrame frame_{"scene.scr", &sweep_, &products_, "done", &problems_};
};

TEST_F(SweepTable, HasALineForEachRowWithAsManyCellsAsTheHeading) {
  std::vector<SweepRow> rows(4);
  rows[0].done = true;
  rows[0].file = "a_x.bin";
  rows[0].written = 1;
  rows[0].engine = "direct";
  rows[0].run.maximum_v = 0.1;
  rows[1].done = rows[1].table = true;
  rows[1].product = 1;
  rows[1].variation = 2;
  rows[2].failure = "too fast";
  rows[3].variation = 3;
  const std::vector<std::string> table = lines(sweep_csv(frame_, rows));
  ASSERT_EQ(table.size(), 5U);
  EXPECT_THAT(table[0], StartsWith("variation,Radar1.bandwidth [Hz],seed,product,file,status,rows,"));
  for (const std::string& line : table)
    EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(table[0], ',')) << line;
  EXPECT_THAT(table[1], StartsWith("1,1000000,1,Simulation1,a_x.bin,done,0,0,0,0.1,"));
  rows[0].written.reset();  // Discarded.
  EXPECT_THAT(lines(sweep_csv(frame_, rows))[1], StartsWith("1,1000000,1,Simulation1,a_x.bin,done,0,0,,0.1,"));
  EXPECT_THAT(table[2], StartsWith("3,2000000,1,Geometry2,"));
  EXPECT_THAT(table[3], HasSubstr(",failed,"));
  EXPECT_THAT(table[4], HasSubstr("4,2000000,2,Simulation1,,not made,"));
}

TEST_F(SweepTable, HasAColumnForEachFigureOfAnyRow) {
  std::vector<SweepRow> rows(3);
  rows[0].figures = {{"found", 1.0}, {"target1_snr_db", 20.5}};
  rows[2].figures = {{"found", 0.0}, {"target1_snr_db", std::nan("")}, {"target2_snr_db", 3.0}};
  const std::vector<std::string> table = lines(sweep_csv(frame_, rows));
  EXPECT_THAT(table[0], testing::EndsWith(",engine,seconds,found,target1_snr_db,target2_snr_db"));
  EXPECT_THAT(table[1], testing::EndsWith(",1,20.5,"));
  EXPECT_THAT(table[2], testing::EndsWith(",,,"));
  EXPECT_THAT(table[3], testing::EndsWith(",0,,3"));
  EXPECT_THAT(sweep_json(frame_, rows), HasSubstr("\"target1_snr_db\": null"));
}

TEST_F(SweepTable, QuotesCellsThatHoldCommasAndQuotationMarks) {
  std::vector<SweepRow> rows(1);
  rows[0].file = "a,\"b\".bin";
  EXPECT_THAT(sweep_csv(frame_, rows), HasSubstr(",\"a,\"\"b\"\".bin\","));
}

TEST_F(SweepTable, AsJsonHoldsValuesAsTypedAndInBaseUnits) {
  std::vector<SweepRow> rows(1);
  rows[0].variation = 3;
  rows[0].failure = "too fast";
  const std::string json = sweep_json(frame_, rows);
  EXPECT_THAT(json, HasSubstr("\"text\": \"2MHz\""));
  EXPECT_THAT(json, HasSubstr("\"value\": 2000000"));
  EXPECT_THAT(json, HasSubstr("\"message\": \"too fast\""));
  EXPECT_THAT(json, HasSubstr("\"status\": \"failed\""));
  EXPECT_THAT(json, HasSubstr("\"variations\": 4"));
}

TEST_F(SweepTable, IsKnownByItsBeginning) {
  const std::string csv = sweep_csv(frame_, {});
  const std::string json = sweep_json(frame_, {});
  EXPECT_TRUE(begins_as_sweep_csv(csv));
  EXPECT_TRUE(begins_as_sweep_json(json));
  for (const std::string& other : {std::string(), std::string("variation,rcs\n1,2\n"), csv.substr(1), json.substr(1),
                                   "\n" + csv, std::string("{\n  \"sarsim\": \"1.0\"\n}\n")}) {
    EXPECT_FALSE(begins_as_sweep_csv(other)) << other;
    EXPECT_FALSE(begins_as_sweep_json(other)) << other;
  }
  EXPECT_FALSE(begins_as_sweep_csv(json));
  EXPECT_FALSE(begins_as_sweep_json(csv));
}

}  // namespace sweep_table_test
}  // namespace sarsim::workflow
