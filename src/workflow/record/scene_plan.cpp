#include "workflow/record/scene_plan.hpp"

#include <cstring>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/os/disk_room.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "raster/table/formats.hpp"
#include "scene/language/recorded_text.hpp"
#include "scene/script/reader.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/record/recording.hpp"

namespace sarsim::workflow {

namespace {

// Encodes rows as the numbers that memory is to hold.
template <class Real>
class VoltEncoder : public raster::Sink {
 public:
  [[nodiscard]] bool wants_counts() const override { return false; }
  [[nodiscard]] std::vector<std::byte> encode(const raster::Block& block) const override {
    std::vector<std::byte> bytes(block.volts.size() * sizeof(std::complex<Real>));
    std::byte* next = bytes.data();
    for (const std::complex<double>& volts : block.volts) {
      const std::complex<Real> stored(static_cast<Real>(volts.real()), static_cast<Real>(volts.imag()));
      std::memcpy(next, &stored, sizeof stored);
      next += sizeof stored;
    }
    return bytes;
  }
  void append(std::span<const std::byte> /*bytes*/, std::size_t /*first_row*/, std::size_t /*rows*/) override {}
  void finish(const raster::RunReport& /*report*/) override {}
};

[[noreturn]] void refuse_echo(core::Problem problem, const SceneInput& input) {
  core::Problems problems{std::move(problem)};
  scene::locate(problems, input.places);
  throw core::InvalidRequest(std::move(problems));
}

template <class Real>
void fill_rows(const ScenePlan& planned, raster::RowRange rows, std::span<std::complex<Real>> samples, unsigned threads,
               const core::Observer& observer) try {
  const simulate::Plan& plan = planned.plan;
  const VoltEncoder<Real> encoder;
  const core::ProgressReport progress = observer.stage(plan.acquisition.link.name);
  if (progress) progress({0, rows.count, plan.acquisition.reception.columns});
  simulate::run_rows(plan, rows, 0.0, encoder, {threads, observer.stop, {}}, [&](const raster::EncodedRows& made) {
    const std::size_t done = made.rows.first - rows.first;
    if (!made.bytes.empty())
      std::memcpy(samples.data() + done * plan.acquisition.reception.columns, made.bytes.data(), made.bytes.size());
    if (progress) progress({done + made.rows.count, rows.count, plan.acquisition.reception.columns});
  });
} catch (const simulate::ImpossibleEcho& error) {
  refuse_echo(error.problem, planned.input);
}

// Throws core::InvalidRequest where the file may not be made.
void expect_free(const std::filesystem::path& file, const SceneInput& input, bool replace) {
  core::Problems taken = problems_of_output(file, {input.sources, true, "", {}});
  for (core::Problem& problem : taken) problem.hint = "give the file another name";
  std::error_code ignored;
  if (taken.empty() && !replace && std::filesystem::exists(file, ignored))
    taken.push_back(core::error("the file exists already")
                        .found(file.string())
                        .expected("a new name")
                        .hint("give it another name, or ask for it to be replaced"));
  if (!taken.empty()) throw core::InvalidRequest(std::move(taken));
}

// The plan with its scene, where the file is not of the format that the scene asks for.
ScenePlan in_format(const ScenePlan& planned, scene::FileFormat format) {
  ScenePlan changed = planned;
  for (scene::Simulation& simulation : changed.input.scene.simulations) simulation.format = format;
  changed.plan.acquisition.simulation.format = format;
  return changed;
}

}  // namespace

ScenePlan plan_of_scene(const SceneInput& known, std::size_t simulation, const core::WorkControl& control) {
  const auto choose = [simulation](const scene::Scene& scene) -> WantedProducts {
    if (simulation >= scene.simulations.size())
      throw core::InvalidRequest(fmt::format("the scene has no recording {}", simulation + 1),
                                 fmt::format("it has {}", scene.simulations.size()));
    return {{simulation}, {}};
  };
  ScenePlan planned{.input = check_again(known, CheckLevel::echoes, control, choose), .plan = {}};
  expect_usable(planned.input);
  resolve_once(planned.input, control);
  planned.plan = simulate::make_plan(planned.input.scene, simulation, planned.input.resolved,
                                     simulate::Engine::automatic, control.stop);
  return planned;
}

void record_rows(const ScenePlan& planned, raster::RowRange rows, std::span<std::complex<float>> samples,
                 unsigned threads, const core::Observer& observer) {
  fill_rows(planned, rows, samples, threads, observer);
}

void record_rows(const ScenePlan& planned, raster::RowRange rows, std::span<std::complex<double>> samples,
                 unsigned threads, const core::Observer& observer) {
  fill_rows(planned, rows, samples, threads, observer);
}

RecordingReport record_file(const ScenePlan& planned, const std::filesystem::path& file,
                            std::optional<scene::FileFormat> format, raster::SinkOptions options, unsigned threads,
                            const core::Observer& observer) try {
  if (format && *format != planned.plan.acquisition.simulation.format)
    return record_file(in_format(planned, *format), file, {}, options, threads, observer);
  options.format = planned.plan.acquisition.simulation.format;
  expect_free(file, planned.input, options.replace);
  RecordingJob job{planned.plan, file, options, {}};
  if (raster::format_of(options.format).carries_script)
    job.script = scene::recorded_text(planned.input.scene, observer.control(core::thread_count(threads)));
  const double bytes = raster::expected_bytes(simulate::product_of(planned.plan, job.script), options);
  core::expect_room(std::filesystem::absolute(file).parent_path(), raster::min_bytes(options.format, bytes),
                    "or choose another folder");
  return make_recording(job, threads, observer);
} catch (const simulate::ImpossibleEcho& error) {
  refuse_echo(error.problem, planned.input);
}

}  // namespace sarsim::workflow
