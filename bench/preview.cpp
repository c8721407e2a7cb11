// Times the simulation window: the first, coarse picture, the full one, the delay of a cancel, and how often a second a
// dragged target is followed. Prints one JSON object.
//
//   preview_bench [--simd LEVEL] [SCENE.scr] [WIDTH HEIGHT]
//
// Without a script the scene is 100 000 targets of 1 m2 on 1.5 km x 1.5 km, seen with a chirp of 100 MHz and 800 ns by
// a radar that rests ("resting") and by one that flies past ("flying"); with one, its first simulation.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/maths/random.hpp"
#include "picture/echo/echo_picture.hpp"
#include "picture/echo/preview.hpp"
#include "scene/script/reader.hpp"
#include "simulate/resolve/simd_level.hpp"

namespace {

using namespace sarsim::core;
using namespace sarsim::picture;
using namespace sarsim::scene;
using namespace sarsim::simulate;

// Of all threads: what other programs on the machine disturb less than the clock.
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Scene many_targets(bool flying) {
  const auto line = [](double a, double b) { return SampledFunction{Interpolation::linear, {{0.0, a}, {1.0, b}}}; };
  Scene scene;
  scene.platforms.push_back({});
  Platform plane;
  plane.name = "Plane";
  plane.path = Platform::Path::trajectory;
  plane.trajectory_m.part = {line(0.0, flying ? 200.0 : 0.0), line(-10000.0, -10000.0), line(2000.0, 2000.0)};
  scene.platforms.push_back(plane);
  const RandomStream stream(1, RandomKind::target_position, 0);
  for (int i = 0; i < 100000; ++i) {
    Target target;
    const auto [x, y] = stream.normals(i, 0);
    target.position_m = {250.0 * x, 250.0 * y, 0.0};
    scene.targets.push_back(target);
  }
  Radar radar;
  radar.platform = "Plane";
  radar.pulse = Radar::Pulse::chirp;
  radar.bandwidth_hz = 100e6;
  radar.pulse_width_s = 800e-9;
  radar.carrier_hz = 5.3e9;
  radar.prf_hz = 500.0;
  radar.noise_temperature_k = 300.0;
  scene.radars.push_back(radar);
  return scene;
}

EchoWindow many_window() {
  EchoWindow window = new_echo_window("Radar1", Processing::raw);
  set_view(window, {9500.0, 11000.0, -1.0, 1.0});
  return window;
}

// When what was asked for came.
struct Clocks {
  std::atomic<double> first{0.0};
  std::atomic<double> finished{0.0};
  std::atomic<std::uint64_t> number{0};
};

struct Times {
  double first_s = 1e9;
  double full_s = 1e9;
  double processor_s = 1e9;  // of the full one
};

class Bench {
 public:
  Bench(EchoWindow window, PlotSize size)
      : window_(std::move(window)), size_(size), preview_([this](const PreviewEvent& event) { hear(event); }) {}

  Times picture(const std::shared_ptr<const Scene>& scene) {
    clocks_.first = 0.0;
    clocks_.finished = 0.0;
    const double processor = processor_s();
    const double begin = now_s();
    preview_.show({scene, window_, size_, Engine::automatic, false});
    preview_.wait();
    const double full = clocks_.finished;
    const double first = clocks_.first > 0.0 ? clocks_.first.load() : full;
    if (!(full > 0.0)) {
      std::fprintf(stderr, "preview: %s\n", failure_.c_str());
      std::exit(1);
    }
    return {first - begin, full - begin, processor_s() - processor};
  }

  // Asked for while rows are being computed.
  double cancel(const std::shared_ptr<const Scene>& scene, double after_s) {
    preview_.show({scene, window_, size_, Engine::automatic, false});
    std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
    const double begin = now_s();
    preview_.cancel();
    preview_.wait();
    return now_s() - begin;
  }

  // Turning the last matrix into colours, as decibels.
  double paint_s() {
    EchoWindow how = window_;
    how.quantity = DisplayQuantity::decibels;
    EchoImage image;
    double best = 1e9;
    for (int i = 0; i < 10; ++i) {
      const double begin = now_s();
      paint(*matrix_, colours_for(*matrix_, how), RowPlacing::nearest, 0, image);
      best = std::min(best, now_s() - begin);
    }
    return best;
  }

  // Full pictures a second while one target moves, painting included.
  double drag_hz(Scene scene, int steps) {
    EchoImage image;
    const double begin = now_s();
    for (int i = 0; i < steps; ++i) {
      scene.targets[scene.targets.size() / 2].position_m.x += 0.5;
      picture(std::make_shared<const Scene>(scene));
      paint(*matrix_, colours_for(*matrix_, window_), RowPlacing::nearest, 0, image);
    }
    return steps / (now_s() - begin);
  }

 private:
  void hear(const PreviewEvent& event) {
    if (event.kind == PreviewEvent::Kind::rows && clocks_.first == 0.0) clocks_.first = now_s();
    if (event.kind == PreviewEvent::Kind::finished) {
      clocks_.finished = now_s();
      matrix_ = event.matrix;
    }
    if (event.kind == PreviewEvent::Kind::failed) failure_ = to_string(event.problems.front());
  }

  EchoWindow window_;
  PlotSize size_;
  Clocks clocks_;
  std::string failure_;
  std::shared_ptr<const EchoMatrix> matrix_;
  Preview preview_;
};

void measure(const char* name, const Scene& scene, const EchoWindow& window, const PlotSize& size) {
  Bench bench(window, size);
  Times best;
  for (int i = 0; i < 5; ++i) {
    // A scene of its own each time, so that nothing is prepared.
    const Times t = bench.picture(std::make_shared<const Scene>(scene));
    best = {std::min(best.first_s, t.first_s), std::min(best.full_s, t.full_s),
            std::min(best.processor_s, t.processor_s)};
  }
  const double paint_s = bench.paint_s();
  double cancel_s = 0.0;
  for (int i = 1; i <= 20; ++i)
    cancel_s = std::max(cancel_s, bench.cancel(std::make_shared<const Scene>(scene), 0.002 * i));
  const double drag = bench.drag_hz(scene, best.full_s < 0.1 ? 200 : 3);
  std::printf(
      "  \"%s\": {\"targets\": %zu, \"width\": %zu, \"height\": %zu, \"first_picture_ms\": %.1f, "
      "\"full_picture_ms\": %.1f, \"full_picture_processor_ms\": %.1f, \"paint_ms\": %.1f, \"longest_cancel_ms\": "
      "%.1f, "
      "\"full_pictures_per_s_while_dragging\": %.1f}",
      name, scene.targets.size(), size.width_px, size.height_px, 1e3 * best.first_s, 1e3 * best.full_s,
      1e3 * best.processor_s, 1e3 * paint_s, 1e3 * cancel_s, drag);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string_view(argv[1]) == "--simd") {
    if (!use_simd_level(argv[2])) {
      std::fprintf(stderr, "preview_bench: this machine has no '%s'\n", argv[2]);
      return 1;
    }
    argc -= 2;
    argv += 2;
  }
  const PlotSize size{argc > 3 ? std::strtoul(argv[2], nullptr, 10) : 1600,
                      argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1000};
  std::printf("{\n");
  if (argc > 1) {
    const ScriptReading reading = read_script_file(argv[1]);
    EchoWindow window = window_of(reading.scene.simulations.at(0));
    measure("recording", reading.scene, window, size);
    window.sampling.kind = Sampling::Kind::screen;
    window.recording.processing = Processing::raw;
    std::printf(",\n");
    measure("screen", reading.scene, window, size);
    window = window_of(reading.scene.simulations.at(0));
    window.recording.processing = Processing::matched_filter;
    std::printf(",\n");
    measure("compressed", reading.scene, window, size);
  } else {
    measure("resting", many_targets(false), many_window(), size);
    std::printf(",\n");
    measure("flying", many_targets(true), many_window(), size);
  }
  std::printf("\n}\n");
  return 0;
}
