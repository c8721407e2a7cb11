// live_chain [SCENE...]: how long the live image takes while a target is dragged, a PRF typed and a window chosen.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "picture/live/live_engine.hpp"
#include "scene/model/scene.hpp"
#include "workflow/input/scene_input.hpp"

namespace {

using namespace sarsim;
using Clock = std::chrono::steady_clock;

constexpr int drags = 200;
constexpr picture::PlotSize window{400, 400};

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Milliseconds of images, until the first and until the last picture of each.
struct Times {
  std::vector<double> first;
  std::vector<double> last;
  std::vector<double> busy_first;  // processor time of all threads
  std::vector<double> busy_last;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0.0 : values[values.size() / 2];
}

double worst(const std::vector<double>& values) { return values.empty() ? 0.0 : *std::ranges::max_element(values); }

void make(picture::LiveEngine& engine, const scene::Scene& scene, const picture::LiveOptions& options, Times& times) {
  const auto shared = std::make_shared<const scene::Scene>(scene);
  const core::StopFlag stop;
  const double processor = processor_ms();
  const Clock::time_point begin = Clock::now();
  const auto since = [&] { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); };
  double first = -1.0;
  const picture::LiveImage image =
      engine.make({shared, 0, options, window}, stop, [&](const picture::LiveImage& coarse) {
        static_cast<void>(picture::live_figure(coarse, {}));
        if (first >= 0.0) return;
        first = since();
        times.busy_first.push_back(processor_ms() - processor);
      });
  static_cast<void>(picture::live_figure(image, {}));
  times.last.push_back(since());
  times.first.push_back(first < 0.0 ? times.last.back() : first);
  times.busy_last.push_back(processor_ms() - processor);
  if (first < 0.0) times.busy_first.push_back(times.busy_last.back());
}

void print(const std::string& name, const char* what, const Times& times) {
  std::printf("%-18s %-16s %8.1f %8.1f %8.1f %8.1f %8.1f %8.1f\n", name.c_str(), what, median(times.first),
              worst(times.first), median(times.busy_first), median(times.last), worst(times.last),
              median(times.busy_last));
  std::fflush(stdout);
}

void run(const std::string& name, scene::Scene scene, int count) {
  picture::LiveEngine engine(core::thread_count(0));
  Times opened;
  make(engine, scene, {}, opened);
  print(name, "open", opened);
  Times dragged;
  for (int step = 0; step < count && !scene.targets.empty(); ++step) {
    scene.targets.front().position_m.x += 0.5;
    make(engine, scene, {}, dragged);
  }
  if (!dragged.last.empty()) print(name, "drag a target", dragged);
  Times typed;
  for (int step = 0; step < std::min(count, 10); ++step) {
    scene.radars.front().prf_hz *= 1.001;
    make(engine, scene, {}, typed);
  }
  print(name, "type a PRF", typed);
  Times chosen;
  picture::LiveOptions options;
  for (int step = 0; step < std::min(count, 10); ++step) {
    options.window.kind = step % 2 == 0 ? signal::SarWindow::Kind::hamming : signal::SarWindow::Kind::rectangular;
    make(engine, scene, options, chosen);
  }
  print(name, "choose a window", chosen);
}

// The radar of the R over so many targets.
scene::Scene many(scene::Scene scene, std::size_t targets) {
  const scene::Target first = scene.targets.front();
  scene.targets.assign(targets, first);
  const auto side = static_cast<std::size_t>(std::max(1.0, std::sqrt(static_cast<double>(targets))));
  for (std::size_t i = 0; i < targets; ++i)
    scene.targets[i].position_m = {-190.0 + 380.0 * static_cast<double>(i % side) / static_cast<double>(side),
                                   -190.0 + 380.0 * static_cast<double>(i / side) / static_cast<double>(side), 0.0};
  return scene;
}

scene::Scene read(const std::string& path) {
  workflow::SceneInput input = workflow::read_scene(path, {}, workflow::CheckLevel::values);
  workflow::expect_usable(input);
  return std::move(input.scene);
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path examples = SARSIM_EXAMPLES;
  std::printf("milliseconds to the first and to the whole picture of %zu x %zu pixels, %u threads; processor time\n",
              window.width_px, window.height_px, core::thread_count(0));
  std::printf("%-18s %-16s %8s %8s %8s %8s %8s %8s\n", "scene", "change", "first", "worst", "busy", "whole", "worst",
              "busy");
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) names = {"sar_r", "stripmap_motion", "spotlight", "satellite", "10000", "100000"};
  try {
    for (const std::string& name : names) {
      const std::size_t targets = std::strtoul(name.c_str(), nullptr, 10);
      if (targets > 0)
        run(name + " targets", many(read((examples / "sar_r.toml").string()), targets), targets > 20'000 ? 20 : drags);
      else
        run(name, read((examples / (name + ".toml")).string()), drags);
    }
  } catch (const core::InvalidRequest& refused) {
    for (const core::Problem& problem : refused.problems)
      std::fprintf(stderr, "%s\n", core::to_string(problem).c_str());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
