#include "picture/live/live_engine.hpp"
#include "picture/live/live_image.hpp"
#include "picture/live/live_picture.hpp"
#include "picture/live/live_request.hpp"
#include "picture/live/live_workflows.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/report/invalid_request.hpp"
#include "support/folders.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/image/placed_image.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/search/search.hpp"

namespace sarsim::picture {
namespace live_test {

using core::Vec3;

constexpr PlotSize window{300, 240};

std::string example_path(const std::string& name) { return (test::source_folder() / "examples" / name).string(); }

scene::Scene example(const std::string& name) {
  return workflow::read_scene(example_path(name), {}, workflow::CheckLevel::values).scene;
}

std::shared_ptr<const scene::Scene> shared(scene::Scene scene) {
  return std::make_shared<const scene::Scene>(std::move(scene));
}

LiveImage made(LiveEngine& engine, scene::Scene scene, const LiveOptions& options = {},
               const LiveEngine::Coarse& coarse = {}) {
  const core::StopFlag stop;
  return engine.make({shared(std::move(scene)), 0, options, window}, stop, coarse);
}

LiveImage made(scene::Scene scene, const LiveOptions& options = {}) {
  LiveEngine engine(2);
  return made(engine, std::move(scene), options);
}

// Largest difference of two images, over the largest magnitude.
double difference(const LiveImage& a, const LiveImage& b) {
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.columns, b.columns);
  if (a.magnitude_v.size() != b.magnitude_v.size()) return 1.0;
  double most = 0.0;
  for (std::size_t i = 0; i < a.magnitude_v.size(); ++i)
    most = std::max(most, static_cast<double>(std::abs(a.magnitude_v[i] - b.magnitude_v[i])));
  return most / static_cast<double>(a.largest_v);
}

// Pixels that are higher than those around them and within 20 dB of the largest.
std::size_t peaks(const LiveImage& image) {
  std::size_t count = 0;
  const std::size_t width = image.columns.count;
  for (std::size_t r = 2; r + 2 < image.rows.count; ++r)
    for (std::size_t k = 2; k + 2 < width; ++k) {
      const float v = image.magnitude_v[r * width + k];
      bool highest = v > 0.1F * image.largest_v;
      for (std::size_t y = r - 2; y <= r + 2; ++y)
        for (std::size_t x = k - 2; x <= k + 2; ++x) highest &= image.magnitude_v[y * width + x] <= v;
      count += highest ? 1 : 0;
    }
  return count;
}

TEST(LiveImageTest, KeepsTheLargestOfEachPixelWithItsPlace) {
  // 4 rows of 6 samples become 2 of 3; the largest is complex.
  std::vector<std::complex<float>> values(24, {0.1F, 0.0F});
  values[3 * 6 + 5] = {3.0F, 4.0F};
  values[0] = {-2.0F, 0.0F};
  const LiveImage image = live_image(core::rows_in_memory(std::span<const std::complex<float>>(values), 4, 6),
                                     {{"Azimuth", "m", 10.0, 2.0}, {"Slant range", "m", 100.0, 1.0}}, {3, 2}, {});
  EXPECT_EQ(image.rows, (LiveAxis{"Azimuth", "m", 9.0, 17.0, 2}));
  EXPECT_EQ(image.columns, (LiveAxis{"Slant range", "m", 99.5, 105.5, 3}));
  EXPECT_EQ(image.magnitude_v, (std::vector<float>{2.0F, 0.1F, 0.1F, 0.1F, 0.1F, 5.0F}));
  EXPECT_EQ(image.largest_v, 5.0F);
}

TEST(LiveImageTest, TellsInDecibelsWhatChanged) {
  std::vector<std::complex<float>> values{1.0F, 0.1F, 0.0F, 0.01F};
  const raster::FocusedPlaces places{{"Azimuth", "m", 0.0, 1.0}, {"Slant range", "m", 0.0, 1.0}};
  const auto rows = [&] { return core::rows_in_memory(std::span<const std::complex<float>>(values), 2, 2); };
  const LiveImage before = live_image(rows(), places, window, {});
  values = {0.1F, 0.1F, 0.0F, 1.0F};
  const LiveImage after = live_image(rows(), places, window, {});
  const std::vector<float> told = difference_db(before, after, 30.0);
  EXPECT_NEAR(told[0], -20.0F, 1e-4F);
  EXPECT_EQ(told[1], 0.0F);
  EXPECT_EQ(told[2], 0.0F);
  EXPECT_NEAR(told[3], 30.0F, 1e-4F);  // From the floor.
  const Figure figure = difference_figure(before, after, {ColourMap::ocean, 30.0});
  ASSERT_EQ(figure.panels.size(), 1U);
  EXPECT_EQ(figure.panels[0].colour_bar->first, -figure.panels[0].colour_bar->last);
  EXPECT_EQ(figure.panels[0].y_per_x, 1.0);
}

TEST(LiveImageTest, FigureOfASingleRowIsACurve) {
  const std::vector<std::complex<float>> values{1.0F, 0.1F};
  const LiveImage image = live_image(core::rows_in_memory(std::span<const std::complex<float>>(values), 1, 2),
                                     {{"Profile", "", 1.0, 1.0}, {"Slant range", "m", 5.0, 1.0}}, window, {});
  const Figure figure = live_figure(image, {});
  ASSERT_EQ(figure.panels.at(0).curves.size(), 1U);
  EXPECT_FALSE(figure.panels[0].image);
  EXPECT_NEAR(figure.panels[0].curves[0].y[1], -20.0, 1e-4);
  EXPECT_NEAR(figure.panels[0].curves[0].x[0], 5.0, 1e-9);
}

TEST(LiveRequestTest, ProductSuitsTheScene) {
  EXPECT_EQ(suitable_product(example("sar_r.toml"), 0), LiveProduct::focused);
  EXPECT_EQ(suitable_product(example("search_radar.toml"), 0), LiveProduct::ppi);
  EXPECT_EQ(suitable_product(example("turning_ship.toml"), 0), LiveProduct::isar);
  EXPECT_EQ(suitable_product(example("stepped_aircraft.toml"), 0), LiveProduct::profiles);
  EXPECT_EQ(suitable_product(example("thesis_chapter3.toml"), 0), LiveProduct::doppler);
}

TEST(LiveRequestTest, CommandMakesTheSame) {
  LiveRequest request{shared(example("sar_r.toml")), 0, {}, window};
  EXPECT_EQ(live_command(request, "r.toml"), "focus r.toml");
  request.options.algorithm = workflow::FocusAlgorithm::omega_k;
  request.options.window.kind = signal::SarWindow::Kind::hamming;
  request.options.compensation = false;
  request.options.autofocus = true;
  EXPECT_EQ(live_command(request, "r.toml"),
            "focus r.toml --window hamming --algorithm omega-k --motion-compensation none --autofocus");
  request.options = {.product = LiveProduct::doppler};
  EXPECT_EQ(live_command(request, "r.toml"), "doppler r.toml --pulses 256");
}

TEST(LiveEngineTest, FocusedImageIsThatOfFocus) {
  const LiveImage image = made(example("sar_r.toml"));
  EXPECT_EQ(image.product, LiveProduct::focused);
  EXPECT_EQ(image.made, "omega-k, 1240 pulses");
  EXPECT_EQ(image.cost.echoes, 24U * 1240U);
  EXPECT_FALSE(image.coarse);
  workflow::FocusRequest request;
  request.input.path = example_path("sar_r.toml");
  request.memory_bytes = 0;
  const workflow::FocusReport report = workflow::focus(request, {});
  const LiveImage expected =
      live_image(report.image, workflow::places_of(workflow::in_memory_image(report).content.header, ""), window, {});
  EXPECT_LT(difference(expected, image), 1e-6);
  EXPECT_EQ(peaks(image), 24U);
}

// Largest magnitude within some pixels of a place.
float largest_near(const LiveImage& image, const LiveImage::TargetPlace& place, int pixels) {
  const auto pixel_of = [](const LiveAxis& axis, double at) {
    return static_cast<int>(std::floor((at - axis.first) / (axis.last - axis.first) * static_cast<double>(axis.count)));
  };
  float largest = 0.0F;
  for (int dy = -pixels; dy <= pixels; ++dy)
    for (int dx = -pixels; dx <= pixels; ++dx) {
      const int r = pixel_of(image.rows, place.row) + dy;
      const int k = pixel_of(image.columns, place.column) + dx;
      if (r < 0 || k < 0 || r >= static_cast<int>(image.rows.count) || k >= static_cast<int>(image.columns.count))
        continue;
      const std::size_t at = static_cast<std::size_t>(r) * image.columns.count + static_cast<std::size_t>(k);
      largest = std::max(largest, image.magnitude_v[at]);
    }
  return largest;
}

TEST(LiveEngineTest, TellsWhereTargetsShouldBe) {
  EXPECT_TRUE(made(example("sar_r.toml")).targets.empty());
  LiveOptions options;
  options.targets = true;
  for (const char* name : {"sar_r.toml", "stripmap_motion.toml"}) {
    const scene::Scene scene = example(name);
    const LiveImage image = made(scene, options);
    ASSERT_EQ(image.targets.size(), scene.targets.size()) << name;
    for (const LiveImage::TargetPlace& place : image.targets)
      EXPECT_GT(largest_near(image, place, 1), 0.3F * image.largest_v)
          << name << " " << place.column << " " << place.row;
    // A place beside them holds less.
    const LiveImage::TargetPlace beside{image.targets[0].column + 15.0, image.targets[0].row + 25.0};
    EXPECT_LT(largest_near(image, beside, 1), 0.2F * image.largest_v) << name;
    const Figure figure = live_figure(image, {});
    ASSERT_EQ(figure.panels.at(0).marks.size(), image.targets.size());
    EXPECT_TRUE(figure.panels[0].marks[0].ring);
    EXPECT_EQ(figure.panels[0].marks[0].x, image.targets[0].column);
  }
  options.algorithm = workflow::FocusAlgorithm::back_projection;  // on its own grid
  const LiveImage projected = made(example("sar_r.toml"), options);
  ASSERT_EQ(projected.targets.size(), 24U);
  for (const LiveImage::TargetPlace& place : projected.targets)
    EXPECT_GT(largest_near(projected, place, 2), 0.3F * projected.largest_v) << place.column << " " << place.row;
  options.algorithm = workflow::FocusAlgorithm::automatic;
  scene::Scene many = example("sar_r.toml");
  many.targets.resize(max_ringed_targets + 1, many.targets.front());
  const LiveImage crowded = made(many, options);
  EXPECT_TRUE(crowded.targets.empty());
  EXPECT_TRUE(std::ranges::any_of(crowded.problems, [](const core::Problem& problem) {
    return problem.message == "there are too many targets to mark" && problem.found == "501";
  }));
}

TEST(LiveEngineTest, SearchPictureIsThatOfSearch) {
  const LiveImage image = made(example("search_radar.toml"));
  workflow::SearchRequest request;
  request.input.path = example_path("search_radar.toml");
  request.keep = true;
  request.detect = false;
  const workflow::SearchReport report = workflow::search(request, {});
  ASSERT_TRUE(report.kept);
  const LiveImage expected =
      live_image(report.kept->rows, workflow::places_of(report.kept->content.header, ""), window, {});
  EXPECT_EQ(image.product, LiveProduct::ppi);
  EXPECT_EQ(image.columns.label, "East");
  EXPECT_GT(expected.largest_v, 0.0F);
  EXPECT_EQ(difference(expected, image), 0.0);
}

TEST(LiveEngineTest, OtherProductsHaveTheirAxes) {
  std::vector<LiveImage> looks;
  LiveEngine engine(2);
  const LiveImage ship =
      made(engine, example("turning_ship.toml"), {}, [&](LiveImage look) { looks.push_back(std::move(look)); });
  ASSERT_EQ(looks.size(), 1U);
  EXPECT_TRUE(looks[0].coarse);
  EXPECT_LT(looks[0].rows.count, ship.rows.count);
  EXPECT_EQ(ship.product, LiveProduct::isar);
  EXPECT_EQ(ship.rows.label, "Cross-range");
  EXPECT_GT(peaks(ship), 3U);
  const LiveImage aircraft = made(example("stepped_aircraft.toml"));
  EXPECT_EQ(aircraft.product, LiveProduct::profiles);
  EXPECT_EQ(aircraft.columns.label, "Slant range");
  const LiveImage map = made(example("mti.toml"), {.product = LiveProduct::doppler});
  EXPECT_EQ(map.product, LiveProduct::doppler);
  EXPECT_EQ(map.rows.label, "Doppler frequency");
  EXPECT_GT(map.largest_v, 0.0F);
}

TEST(LiveEngineTest, LowPrfShowsGhosts) {
  scene::Scene scene = example("sar_r.toml");
  scene.radars[0].prf_hz = 150.0;  // Points have bands of 277 Hz.
  LiveEngine engine(2);
  LiveImage first;
  const LiveImage image = made(engine, scene, {}, [&](const LiveImage& early) { first = early; });
  EXPECT_GT(peaks(image), 40U);  // Of 24 points.
  EXPECT_FALSE(image.problems.empty());
  // The picture does not wait for what is said of it.
  EXPECT_TRUE(first.problems.empty());
  EXPECT_FALSE(first.coarse);
  EXPECT_EQ(difference(first, image), 0.0);
}

TEST(LiveEngineTest, DragComputesTheEchoesOfOneTargetAndGivesTheSameImage) {
  scene::Scene scene = example("sar_r.toml");
  scene.radars[0].noise_temperature_k = 1e5;
  LiveEngine engine(2);
  static_cast<void>(made(engine, scene));
  scene.targets[3].position_m = Vec3{30.0, -90.0, 0.0};
  EXPECT_EQ(made(engine, scene).cost.echoes, 2U * 1240U);  // Its old ones go, its new ones come.
  for (int step = 0; step < 4; ++step) {
    scene.targets[3].position_m.x += 7.0;
    EXPECT_EQ(made(engine, scene).cost.echoes, 1240U);
  }
  scene.targets[7].rcs_m2 = 4.0;
  const LiveImage followed = made(engine, scene);
  EXPECT_EQ(followed.cost.echoes, 2U * 1240U);
  const LiveImage whole = made(scene);
  EXPECT_EQ(whole.cost.echoes, 24U * 1240U);
  EXPECT_LT(difference(whole, followed), 1e-5);
}

TEST(LiveEngineTest, FirstLookBehindASmallChangeHasItsEchoes) {
  scene::Scene scene = example("sar_r.toml");
  LiveEngine engine(2);
  const LiveImage before = made(engine, scene);
  scene.targets[3].position_m.x += 20.0;
  std::vector<LiveImage> looks;
  const LiveImage whole = made(engine, scene, {}, [&](LiveImage look) { looks.push_back(std::move(look)); });
  ASSERT_EQ(looks.size(), 2U);
  EXPECT_TRUE(looks[0].coarse);
  EXPECT_FALSE(looks[1].coarse);
  // Pixels of a slightly other grid.
  EXPECT_EQ(looks[0].made, whole.made);
  EXPECT_NEAR(looks[0].largest_v, whole.largest_v, 0.1F * whole.largest_v);
  EXPECT_EQ(peaks(looks[0]), peaks(whole));
  const std::vector<float> changed = difference_db(before, looks[0], 30.0);
  EXPECT_GT(*std::ranges::max_element(changed), 15.0F);
  EXPECT_LT(*std::ranges::min_element(changed), -15.0F);
}

TEST(LiveEngineTest, WhatDoesNotAddUpIsComputedWhole) {
  scene::Scene scene = example("sar_r.toml");
  LiveEngine engine(2);
  static_cast<void>(made(engine, scene));
  scene.targets[3].traits.edit().position_stddev_m =
      Vec3{0.01, 0.0, 0.0};  // A draw for each pulse, by the number of the target.
  EXPECT_EQ(made(engine, scene).cost.echoes, 24U * 1240U);
  scene.radars[0].prf_hz = 610.0;
  EXPECT_GT(made(engine, scene).cost.echoes, 24U * 1200U);
}

TEST(LiveEngineTest, OtherOptionsComputeNoEchoes) {
  const scene::Scene scene = example("sar_r.toml");
  LiveEngine engine(2);
  const LiveImage sharp = made(engine, scene);
  LiveOptions options;
  options.window.kind = signal::SarWindow::Kind::hamming;
  const LiveImage smooth = made(engine, scene, options);
  EXPECT_EQ(smooth.cost.echoes, 0U);
  EXPECT_GT(difference(sharp, smooth), 0.1);
}

TEST(LiveEngineTest, ManyTargetsAreLookedAtCoarselyFirst) {
  scene::Scene scene = example("sar_r.toml");
  const scene::Target first = scene.targets.front();
  scene.targets.clear();
  for (int i = 0; i < 5000; ++i) {
    scene.targets.push_back(first);
    scene.targets.back().position_m = Vec3{-180.0 + 3.6 * (i % 100), -100.0 + 4.0 * static_cast<double>(i / 100), 0.0};
  }
  scene.simulations[0].time_end_s = scene.simulations[0].time_start_s + 0.3;  // Fewer pulses: a quick test.
  std::vector<LiveImage> coarse;
  const auto keep = [&](LiveImage image) {
    if (image.coarse) coarse.push_back(std::move(image));
  };
  LiveEngine engine(2);
  const LiveImage all = made(engine, scene, {}, keep);
  ASSERT_EQ(coarse.size(), 1U);
  EXPECT_TRUE(coarse[0].coarse);
  EXPECT_EQ(coarse[0].coarsely, "128 of 5000 targets");
  EXPECT_LT(coarse[0].cost.echoes, all.cost.echoes / 30);
  scene.targets[17].position_m.x += 10.0;
  const LiveImage after = made(engine, scene, {}, keep);
  ASSERT_EQ(coarse.size(), 2U);
  EXPECT_EQ(after.cost.echoes * 2500, all.cost.echoes);  // Two targets of 5000.
  EXPECT_LT(difference(made(scene), after), 1e-5);
}

TEST(LiveEngineTest, RefusesWithReasons) {
  scene::Scene scene = example("sar_r.toml");
  scene.radars.clear();
  EXPECT_THROW(static_cast<void>(made(scene)), core::InvalidRequest);
  scene = example("sar_r.toml");
  scene.simulations.clear();
  EXPECT_THROW(static_cast<void>(made(scene)), core::InvalidRequest);
}

TEST(LivePictureTest, ReportsTheNewestRequestAlone) {
  const auto scene = shared(example("sar_r.toml"));
  std::mutex lock;
  std::vector<LiveEvent> events;
  std::uint64_t newest = 0;
  bool late = false;
  {
    LivePicture picture([&](const LiveEvent& event) {
      const std::scoped_lock hold(lock);
      late = late || event.request < newest;
      events.push_back(event);
    });
    for (int i = 0; i < 20; ++i) {
      const std::uint64_t number = picture.show({scene, 0, {}, window});
      const std::scoped_lock hold(lock);
      newest = number;
    }
    picture.wait();
  }
  EXPECT_FALSE(late);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back().kind, LiveEvent::Kind::finished);
  EXPECT_EQ(events.back().request, newest);
  EXPECT_EQ(std::ranges::count(events, LiveEvent::Kind::finished, &LiveEvent::kind), 1);
}

TEST(LivePictureTest, EndsWhenItIsCancelled) {
  scene::Scene scene = example("sar_r.toml");
  const scene::Target first = scene.targets.front();
  scene.targets.assign(200'000, first);  // Minutes of echoes.
  scene.simulations[0].time_end_s = 30.0;
  std::mutex lock;
  std::vector<LiveEvent> events;
  LivePicture picture([&](const LiveEvent& event) {
    const std::scoped_lock hold(lock);
    events.push_back(event);
  });
  picture.show({shared(std::move(scene)), 0, {}, window});
  picture.cancel();
  const std::size_t told = [&] {
    const std::scoped_lock hold(lock);
    return events.size();
  }();
  picture.wait();
  const std::scoped_lock hold(lock);
  EXPECT_EQ(events.size(), told);
  EXPECT_EQ(std::ranges::count(events, LiveEvent::Kind::finished, &LiveEvent::kind), 0);
}

TEST(LivePictureTest, SaysWhyThereIsNoImage) {
  scene::Scene scene = example("sar_r.toml");
  scene.radars[0].prf_hz = -1.0;
  LiveEvent last;
  LivePicture picture([&](const LiveEvent& event) { last = event; });
  picture.show({shared(scene), 0, {}, window});
  picture.wait();
  EXPECT_EQ(last.kind, LiveEvent::Kind::failed);
  EXPECT_TRUE(core::has_errors(last.problems));
}

}  // namespace live_test
}  // namespace sarsim::picture
