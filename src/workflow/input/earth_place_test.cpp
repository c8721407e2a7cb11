#include "workflow/input/earth_place.hpp"

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow {
namespace earth_place_test {

TEST(EarthPlace, AnchorsInsideTheEarthAreRefusedAsByTheirReaders) {
  for (const char* const sound : {"10,20,-11999", "10,20,0,90", "-90,0,8848", "0,0,36e6"})
    EXPECT_NO_THROW(static_cast<void>(anchor_from_text(sound, "--anchor"))) << sound;
  for (const char* const bad : {"10,20,-12001", "10,20,-7e5", "10,20,-6.4e6", "10,20,-1.3e7", "10,20,1e12"}) try {
      static_cast<void>(anchor_from_text(bad, "--anchor"));
      ADD_FAILURE() << bad;
    } catch (const core::InvalidRequest& refused) {
      EXPECT_EQ(refused.problems.front().message.substr(0, 9), "--anchor ") << bad;
      EXPECT_NE(refused.problems.front().expected.find("at most 12000 m below the ellipsoid"), std::string::npos);
    }
}

}  // namespace earth_place_test
}  // namespace sarsim::workflow
