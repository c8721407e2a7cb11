#include "random_scenes/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "random_scenes/engine_errors.hpp"
#include "random_scenes/scene_maker.hpp"
#include "raster/format/sinks.hpp"
#include "scene/check/check.hpp"
#include "scene/script/reader.hpp"
#include "scene/script/writer.hpp"
#include "simulate/plan/row_maker.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "simulate/run/geometry_table.hpp"
#include "simulate/run/run.hpp"
#include "simulate/survey/survey.hpp"

namespace sarsim::test {

namespace {

using Row = std::vector<std::complex<double>>;

std::string first_error(const core::Problems& problems) {
  for (const core::Problem& problem : problems)
    if (problem.severity == core::Severity::error) return core::to_string(problem);
  return {};
}

// One number from a text, for choices that belong to a scene.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 1469598103934665603U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash;
}

class Examiner {
 public:
  explicit Examiner(const scene::Scene& scene) : scene_(scene) {}

  Examination examine() {
    text_ = scene::write_script(scene_);
    choices_ = hash_of(text_);
    guarded("round trip", [&] { compare_scripts(); });
    try {
      refuse(scene::check(scene_));
      if (!result_.refused.empty()) return result_;
      resolved_ = std::make_shared<const simulate::ResolvedScene>(simulate::resolve(scene_));
      refuse(simulate::survey(scene_, resolved_));
      if (!result_.refused.empty()) return result_;
      for (std::size_t i = 0; i < scene_.simulations.size(); ++i) examine_simulation(i);
      guarded("geometry", [&] { make_tables(); });
    } catch (const simulate::ImpossibleEcho& echo) {  // Of a pulse that the survey did not look at.
      result_.refused = core::to_string(echo.problem);
    }
    return result_;
  }

 private:
  void find(const std::string& check, std::string text) { result_.findings.push_back({check, std::move(text)}); }

  // What throws is a finding, but for echoes that cannot be.
  void guarded(const std::string& check, const std::function<void()>& work) {
    try {
      work();
    } catch (const simulate::ImpossibleEcho&) {
      throw;
    } catch (const std::exception& error) {
      find(check + " throws", error.what());
    }
  }

  void refuse(const core::Problems& problems) { result_.refused = first_error(problems); }

  void compare_scripts() {
    const scene::ScriptReading reading = scene::read_script(text_, "scene.scr", loader_of(scene_));
    if (core::has_errors(reading.problems)) return find("script read", first_error(reading.problems));
    if (!(reading.scene == scene_)) find("script differs", "the scene that was read is another one");
    if (scene::write_script(reading.scene) != text_) find("script rewritten", "the script is written in another way");
    const scene::ScriptReading other = scene::read_script(spelled_otherwise(text_), "scene.scr", loader_of(scene_));
    if (core::has_errors(other.problems) || !(other.scene == scene_))
      find("script spelled otherwise", first_error(other.problems));
  }

  void examine_simulation(std::size_t index) {
    const simulate::Plan reference = simulate::make_plan(scene_, index, resolved_, simulate::Engine::reference);
    for (const simulate::Engine engine :
         {simulate::Engine::automatic, simulate::Engine::direct, simulate::Engine::spectral})
      guarded(std::string(simulate::name_of(engine)), [&] { compare_engine(index, engine, reference); });
    if (reference.acquisition.reception.compressor)
      guarded("compression", [&] { compare_compression(index, reference); });
    if (reference.acquisition.reception.profiler) guarded("profile", [&] { compare_profile(index, reference); });
    constexpr std::array engines{simulate::Engine::automatic, simulate::Engine::direct, simulate::Engine::spectral,
                                 simulate::Engine::reference};
    guarded("division", [&] { compare_divisions(index, engines[choices_ % engines.size()]); });
  }

  void compare_engine(std::size_t index, simulate::Engine engine, const simulate::Plan& reference) {
    const double tolerance = scene_.options.tolerance;
    const EngineErrors errors =
        compare_rows(simulate::make_plan(scene_, index, resolved_, engine), reference, tolerance);
    result_.rows += reference.acquisition.timing.rows;
    if (!errors.finite)
      find(fmt::format("{} not finite", simulate::name_of(engine)), "a sample is not a finite number");
    result_.worst_error = std::max(result_.worst_error, errors.worst_share);
    if (!(errors.worst_share <= 1.0))
      find(fmt::format("{} error", simulate::name_of(engine)),
           fmt::format("row {} of simulation {} is {:.3g} times as far from the reference as promised",
                       errors.worst_row, index + 1, errors.worst_share));
  }

  // The raw recording of the samples that a plan compresses, or of the pulses of its profiles.
  [[nodiscard]] simulate::Plan raw_plan(std::size_t index, const simulate::Plan& plan) const {
    scene::Scene scene = scene_;
    scene::Simulation& simulation = scene.simulations[index];
    simulation.processing = scene::Processing::raw;
    simulate::Plan raw = simulate::make_plan(scene, index, resolved_, simulate::Engine::reference);
    raw.acquisition.reception.raw_grid = plan.acquisition.reception.raw_grid;
    raw.acquisition.reception.noise_first_sample = plan.acquisition.reception.noise_first_sample;
    raw.acquisition.reception.stc_gain = plan.acquisition.reception.stc_gain;
    raw.acquisition.reception.pulse = plan.acquisition.reception.pulse;
    raw.acquisition.reception.columns = plan.acquisition.reception.raw_grid.count;
    return raw;
  }

  void expect_close(const std::string& check, const Row& got, const Row& expected, double scale, std::size_t row) {
    double error = 0.0;
    for (std::size_t i = 0; i < got.size(); ++i) error = std::max(error, std::abs(got[i] - expected[i]));
    if (!(error <= 1e-11 * scale))
      find(check, fmt::format("row {} differs by {:.3g} where the largest sample is {:.3g}", row, error, scale));
  }

  void compare_compression(std::size_t index, const simulate::Plan& plan) {
    const simulate::Plan raw = raw_plan(index, plan);
    simulate::RowMaker raw_rows(raw);
    simulate::RowMaker rows(plan);
    const auto& taps = plan.acquisition.reception.compressor->filter().taps;
    Row samples(raw.acquisition.reception.columns), expected(plan.acquisition.reception.columns),
        got(plan.acquisition.reception.columns);
    for (std::size_t row = 0; row < plan.acquisition.timing.rows; ++row) {
      raw_rows.make_row(row, samples);
      rows.make_row(row, got);
      double scale = 0.0;
      for (const auto& sample : samples) scale = std::max(scale, std::abs(sample));
      double weight = 0.0;
      for (const auto& tap : taps) weight += std::abs(tap);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        expected[i] = 0.0;
        for (std::size_t k = 0; k < taps.size(); ++k)
          expected[i] += taps[k] * samples[plan.acquisition.reception.compressor->output_index()[i] + k];
      }
      expect_close("compression", got, expected, scale * weight, row);
    }
  }

  void compare_profile(std::size_t index, const simulate::Plan& plan) {
    const simulate::Plan raw = raw_plan(index, plan);
    simulate::RowMaker raw_rows(raw);
    simulate::RowMaker rows(plan);
    const std::size_t gates = plan.acquisition.reception.raw_grid.count;
    const auto per_step = static_cast<std::size_t>(plan.acquisition.link.carrier.pulses_per_step());
    Row samples(gates), sums(plan.acquisition.reception.columns), expected(plan.acquisition.reception.columns),
        got(plan.acquisition.reception.columns);
    for (std::size_t row = 0; row < plan.acquisition.timing.rows; ++row) {
      const auto first = static_cast<std::size_t>(plan.acquisition.timing.first_pulse_of_row(row) -
                                                  plan.acquisition.timing.pulses.first);
      std::ranges::fill(sums, std::complex<double>());
      double scale = 0.0;
      for (std::size_t pulse = 0; pulse < static_cast<std::size_t>(plan.acquisition.timing.row_pulses); ++pulse) {
        raw_rows.make_row(first + pulse, samples);
        for (std::size_t gate = 0; gate < gates; ++gate) {
          sums[pulse / per_step * gates + gate] += samples[gate] / static_cast<double>(per_step);
          scale = std::max(scale, std::abs(samples[gate]));
        }
      }
      plan.acquisition.reception.profiler->profile(sums, expected);
      rows.make_row(row, got);
      expect_close("profile", got, expected, scale, row);
    }
  }

  // The bytes of some rows, and the LSB.
  std::vector<std::byte> bytes_of(const simulate::Plan& plan, double lsb_v, const raster::Sink& encoder,
                                  raster::RowRange rows, unsigned threads) {
    std::vector<std::byte> bytes;
    raster::RunControl control;
    control.threads = threads;
    simulate::run_rows(plan, rows, lsb_v, encoder, control, [&](const raster::EncodedRows& encoded) {
      bytes.insert(bytes.end(), encoded.bytes.begin(), encoded.bytes.end());
    });
    return bytes;
  }

  void compare_divisions(std::size_t index, simulate::Engine engine) {
    const simulate::Plan plan = simulate::make_plan(scene_, index, resolved_, engine);
    raster::RunControl one, three;
    one.threads = 1;
    three.threads = 3;
    const double lsb_v = simulate::resolved_lsb_v(plan, one);
    if (simulate::resolved_lsb_v(plan, three) != lsb_v) find("threads", "another LSB with three threads");
    raster::SinkOptions options;
    options.format = plan.acquisition.simulation.format;
    options.counts = choices_ / 4 % 2 == 0;
    const auto encoder = raster::make_discarding_sink(simulate::product_of(plan, text_), options);
    const auto whole = bytes_of(plan, lsb_v, *encoder, {0, plan.acquisition.timing.rows}, 1);
    if (bytes_of(plan, lsb_v, *encoder, {0, plan.acquisition.timing.rows}, 3) != whole)
      find("threads", "other bytes with three threads");
    const std::size_t cut = choices_ / 8 % (plan.acquisition.timing.rows + 1);
    auto divided = bytes_of(plan, lsb_v, *encoder, {0, cut}, 2);
    const auto rest = bytes_of(plan, lsb_v, *encoder, {cut, plan.acquisition.timing.rows - cut}, 1);
    divided.insert(divided.end(), rest.begin(), rest.end());
    if (divided != whole) find("division", fmt::format("other bytes where divided at row {}", cut));
  }

  void make_tables() {
    for (const scene::GeometryTable& table : scene_.geometries) {
      std::string text, exact;
      simulate::write_geometry_text(scene_, table, [&](std::string_view piece) { text += piece; });
      simulate::write_geometry_csv(scene_, table, [&](std::string_view piece) { exact += piece; });
      if (text.empty() || exact.empty()) find("geometry", "a table is empty");
      if (exact.find("nan") != std::string::npos || exact.find("inf") != std::string::npos)
        find("geometry", "a table holds what is no number");
    }
  }

  const scene::Scene& scene_;
  std::string text_;
  std::uint64_t choices_ = 0;
  std::shared_ptr<const simulate::ResolvedScene> resolved_;
  Examination result_;
};

}  // namespace

Examination examine(const scene::Scene& scene) { return Examiner(scene).examine(); }

}  // namespace sarsim::test
