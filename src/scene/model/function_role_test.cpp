#include "scene/model/function_role.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "scene/schema/function_block.hpp"
#include "support/folders.hpp"

namespace sarsim::scene {
namespace function_role_test {
namespace {

const core::SampledFunction slope{core::Interpolation::linear, {{0, 0}, {10, 5}}};

TEST(FunctionEnds, AreOfOneValuePerUse) {
  struct Case {
    FunctionRole role;
    double beyond;  // at 30: 15 where the line goes on
  };
  for (const Case& c :
       {Case{FunctionRole::trajectory, 15}, Case{FunctionRole::rotation, 15}, Case{FunctionRole::beam_target, 15},
        Case{FunctionRole::position_envelope, 0}, Case{FunctionRole::rotation_envelope, 0},
        Case{FunctionRole::pulse, 5}, Case{FunctionRole::pulse_envelope, 5}, Case{FunctionRole::window, 5},
        Case{FunctionRole::stc, 5}, Case{FunctionRole::reflectivity, 5}, Case{FunctionRole::azimuth_cut, 5},
        Case{FunctionRole::elevation_cut, 5}}) {
    EXPECT_EQ(evaluated(c.role, slope, {})(30.0), c.beyond) << static_cast<int>(c.role);
    EXPECT_EQ(evaluated(c.role, slope, {})(7.0), 3.5) << static_cast<int>(c.role);
    EXPECT_EQ(evaluated(c.role, slope, {}, false)(30.0), c.beyond == 0 ? 0.0 : 15.0) << static_cast<int>(c.role);
  }
}

TEST(FunctionEnds, OfAGainByRangeAreHeld) {
  const core::SampledFunction stc{core::Interpolation::linear, {{0, 0.1}, {5000, 1}}};
  EXPECT_EQ(evaluated(FunctionRole::stc, stc, {})(10e3), 1.0);
  EXPECT_NEAR(evaluated(FunctionRole::stc, stc, {}, false)(10e3), 1.9, 1e-12);
}

// Each block of the language has a row of docs/theory/echo-model.md with the words of the table.
TEST(FunctionEnds, AreThoseOfTheTheorysTable) {
  std::ifstream file(sarsim::test::source_folder() / "docs/theory/echo-model.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const FunctionBlock* block : function_blocks::all)
    for (std::size_t part = 0; part < block->count; ++part) {
      const FunctionRole role = role_of(*block, part);
      std::string name(block->words);
      if (role == FunctionRole::azimuth_cut) name = "gain of an antenna in azimuth";
      if (role == FunctionRole::elevation_cut) name = "gain of an antenna in elevation";
      if (role == FunctionRole::list) name = "pulse repetition intervals, carrier frequencies";
      const std::string row = fmt::format("| {} | {} |", name, function_ends(role).words);
      EXPECT_NE(page.find(row), std::string::npos) << row;
    }
}

}  // namespace
}  // namespace function_role_test
}  // namespace sarsim::scene
