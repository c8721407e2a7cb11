#include "simulate/run/measure_machine.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/row_kernel.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::simulate {

namespace {

constexpr int trial_repeats = 3;
constexpr double farthest = 100.0;  // from the constants; more is an accident of the clock
constexpr double trial_rate_hz = 60e6;
constexpr double trial_samples = 4096.0;
constexpr double trial_prf_hz = 1000.0;
constexpr double near_m = 1000.0;
constexpr double golden_ratio = 0.6180339887498949;  // neighbours in the list are far apart, as in most scenes

// One recording: a resting radar, targets in a row, chirps.
struct Trial {
  Engine engine = Engine::direct;
  int targets = 1;
  double pulse_samples = 100.0;
  int rows = 8;  // of the longer of two recordings; so many that it takes a few milliseconds
  bool noise = false;
  bool filter = false;
};

scene::Scene scene_of(const Trial& trial, int rows) {
  scene::Scene scene;
  const std::string ground = "Ground";
  scene.platforms.emplace_back().name = ground;
  scene::Radar& radar = scene.radars.emplace_back();
  radar.platform = ground;
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 50e6;
  radar.pulse_width_s = trial.pulse_samples / trial_rate_hz;
  radar.prf_hz = trial_prf_hz;
  radar.noise_temperature_k = trial.noise ? 290.0 : 0.0;
  const double spacing_m = radar::range_of(1.0 / trial_rate_hz, core::exact_light_speed_mps);
  for (int i = 0; i < trial.targets; ++i) {
    scene::Target& target = scene.targets.emplace_back();
    target.platform = ground;
    const double share = golden_ratio * i - std::floor(golden_ratio * i);
    target.position_m.x = near_m + spacing_m * (trial_samples - trial.pulse_samples) * share;
  }
  scene::Simulation& simulation = scene.simulations.emplace_back();
  simulation.radar = radar.name;
  simulation.range_start_m = near_m;
  simulation.range_end_m = near_m + spacing_m * trial_samples;
  simulation.sample_rate_hz = trial_rate_hz;
  simulation.time_end_s = (rows - 0.5) / trial_prf_hz;
  simulation.lsb_v = 1e-6;
  if (trial.filter) simulation.processing = scene::Processing::matched_filter;
  return scene;
}

// Takes the samples as counts, makes bytes of them as files of counts do, and forgets them.
class Nowhere : public raster::Sink {
 public:
  [[nodiscard]] bool wants_counts() const override { return true; }
  [[nodiscard]] std::vector<std::byte> encode(const raster::Block& block) const override {
    std::vector<std::byte> bytes(block.counts.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (block.counts[i] > 128) throw std::logic_error("a count of 8 bits is beyond them");
      bytes[i] = static_cast<std::byte>(block.counts[i] + 127);
    }
    return bytes;
  }
  void append(std::span<const std::byte>, std::size_t, std::size_t) override {}
  void finish(const raster::RunReport&) override {}
};

// Processor time does not count what else the machine does, nor wall time what else this process does: the less of
// both.
struct Moment {
  std::chrono::steady_clock::time_point wall;
  std::clock_t processor = 0;

  static Moment now() { return {std::chrono::steady_clock::now(), std::clock()}; }
  [[nodiscard]] double seconds_since() const {
    const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
    const double processor_s = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    return std::min(wall_s, processor_s);
  }
};

// Measures trials one after the other; each knows what those before it found.
class Measuring {
 public:
  explicit Measuring(const core::StopFlag* stop) : stop_(stop) {}

  MachineSpeed all() {
    take({.rows = 1024}, &MachineSpeed::samples);
    take({.rows = 24, .noise = true}, &MachineSpeed::noise);
    take({.pulse_samples = 400.0, .rows = 96, .filter = true}, &MachineSpeed::compression);
    for (const RowKernelKind& kind : row_kernels())
      take({.engine = kind.engine,
            .targets = kind.to_measure.targets,
            .pulse_samples = kind.to_measure.pulse_samples,
            .rows = kind.to_measure.rows},
           kind.speed);
    return speed_;
  }

 private:
  // What one part takes over what the constants say, the other parts being known or left out.
  void take(const Trial& trial, double MachineSpeed::*part) {
    const Plan plan = make_plan(scene_of(trial, trial.rows), 0, nullptr, trial.engine, stop_);
    const auto expected_s = [&](double of_part) {
      MachineSpeed speed = speed_;
      speed.*part = of_part;
      const Cost cost = estimated_cost(plan, 1, speed);
      return (cost.seconds_one_thread - cost.start_seconds) / static_cast<double>(plan.acquisition.timing.rows);
    };
    const double others_s = expected_s(0.0);
    const double measured = (row_seconds(trial) - others_s) / (expected_s(1.0) - others_s);
    speed_.*part = std::clamp(measured, 1.0 / farthest, farthest);
  }

  // Of a row once all is set up: from recordings of two lengths.
  [[nodiscard]] double row_seconds(const Trial& trial) const {
    const int few = trial.rows / 8;
    const double few_s = run_seconds(scene_of(trial, few), trial.engine);
    const double many_s = run_seconds(scene_of(trial, trial.rows), trial.engine);
    return std::max(many_s - few_s, 1e-9) / (trial.rows - few);
  }

  [[nodiscard]] double run_seconds(const scene::Scene& scene, Engine engine) const {
    const Plan plan = make_plan(scene, 0, nullptr, engine, stop_);
    double min_s = std::numeric_limits<double>::infinity();
    for (int i = 0; i < trial_repeats; ++i) {
      Nowhere nowhere;
      const Moment begin = Moment::now();
      (void)run(plan, plan.acquisition.simulation.lsb_v, nowhere, {1, stop_, {}});
      min_s = std::min(min_s, begin.seconds_since());
    }
    return min_s;
  }

  const core::StopFlag* stop_;
  MachineSpeed speed_;
};

}  // namespace

MachineSpeed measure_machine(const core::StopFlag* stop) { return Measuring(stop).all(); }

}  // namespace sarsim::simulate
