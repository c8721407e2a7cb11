#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "simulate/plan/flight_test_scene.hpp"
#include "workflow/record/record.hpp"

namespace sarsim::workflow {
namespace cloud_recording_test {

namespace fs = std::filesystem;

// Forty targets near those of the flight, as targets and as a cloud.
class CloudRecording : public testing::Test {
 protected:
  CloudRecording() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    scene_ = simulate::flight_scene();
    scene_.simulations = {simulate::flight_recording(0.0, scene::FileFormat::npy)};
    scene_.simulations[0].file = "sim.npy";
    const scene::Target like = scene_.targets.front();
    scene_.targets.resize(1);
    std::string table = "x,y,z,rcs\n";
    for (int i = 0; i < 40; ++i) {
      scene::Target target;
      target.platform = like.platform;
      target.position_m = like.position_m + core::Vec3{1.5 * i, -2.25 * i, 0.125 * i};
      target.rcs_m2 = 1.0 + 0.25 * (i % 5);
      points_.push_back(target);
      table +=
          fmt::format("{},{},{},{}\n", target.position_m.x, target.position_m.y, target.position_m.z, target.rcs_m2);
    }
    write_table(table);
    cloud_.platform = *like.platform;
    cloud_.file = "points.csv";
  }
  ~CloudRecording() override { fs::remove_all(folder_); }

  void write_table(const std::string& text) const { std::ofstream(folder_ / "points.csv") << text; }

  // What each point has besides, as a target and as the cloud.
  void each(const auto& change) {
    change(cloud_.traits);
    for (scene::Target& target : points_) change(target.traits.edit());
  }

  [[nodiscard]] scene::Scene with_cloud() const {
    scene::Scene scene = scene_;
    scene.clouds.push_back(cloud_);
    return scene;
  }
  [[nodiscard]] scene::Scene with_targets() const {
    scene::Scene scene = scene_;
    scene.targets.insert(scene.targets.end(), points_.begin(), points_.end());
    return scene;
  }

  [[nodiscard]] std::string recorded(const scene::Scene& scene, simulate::Engine engine, unsigned threads = 1) const {
    RecordRequest request;
    request.scene = scene;
    request.script = (folder_ / "scene.scr").string();
    request.folder = folder_;
    request.threads = threads;
    request.engine = engine;
    request.force = true;
    (void)record(request, {});
    std::ifstream file(folder_ / "sim.npy", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  void expect_same() const {
    for (const simulate::Engine engine :
         {simulate::Engine::reference, simulate::Engine::direct, simulate::Engine::spectral}) {
      const std::string of_targets = recorded(with_targets(), engine);
      const std::string of_cloud = recorded(with_cloud(), engine);
      EXPECT_GT(of_targets.size(), 1000U);
      EXPECT_TRUE(of_cloud == of_targets) << simulate::name_of(engine);
      EXPECT_TRUE(recorded(with_cloud(), engine, 3) == of_cloud) << simulate::name_of(engine);
    }
  }

  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("cloud-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  scene::Scene scene_;
  scene::Cloud cloud_;
  std::vector<scene::Target> points_;
};

TEST_F(CloudRecording, HasTheBytesOfThatOfEqualTargets) { expect_same(); }

TEST_F(CloudRecording, HasThemWithRandomDeviations) {
  each([](scene::TargetTraits& traits) {
    traits.position_stddev_m = {0.01, 0.02, 0.03};
    traits.rcs_stddev_m2 = 0.0625;
  });
  // Squares of roots are the cross-sections again where those are squares.
  write_table([&] {
    std::string table = "x,y,z,rcs\n";
    for (scene::Target& target : points_) {
      target.rcs_m2 = 2.25;
      table += fmt::format("{},{},{},2.25\n", target.position_m.x, target.position_m.y, target.position_m.z);
    }
    return table;
  }());
  expect_same();
}

TEST_F(CloudRecording, HasThemWithAFaceAndAFunction) {
  each([](scene::TargetTraits& traits) {
    traits.reflectivity = scene::Target::Reflectivity::directional;
    traits.azimuth = core::Angle::from_deg(170.0);
    traits.elevation = core::Angle::from_deg(40.0);
    traits.azimuth_stddev = core::Angle::from_deg(2.0);
    traits.gain = scene::Target::Gain::user;
    traits.gain_db.part[0] = {core::Interpolation::linear, {{0.0, 0.0}, {90.0, -10.0}, {180.0, -60.0}}};
  });
  scene_.targets.clear();
  expect_same();
}

TEST_F(CloudRecording, FollowsTheCloudsOwnCrossSection) {
  std::string table;
  for (scene::Target& target : points_) {
    target.rcs_m2 = 12.25;
    table += fmt::format("{},{},{}\n", target.position_m.x, target.position_m.y, target.position_m.z);
  }
  write_table(table);
  cloud_.rcs_m2 = 12.25;
  expect_same();
}

TEST_F(CloudRecording, IsRefusedWithoutItsTable) {
  fs::remove(folder_ / "points.csv");
  EXPECT_THROW((void)recorded(with_cloud(), simulate::Engine::automatic), core::InvalidRequest);
}

}  // namespace cloud_recording_test
}  // namespace sarsim::workflow
