// The recordings of sarsim.h.

#include <algorithm>
#include <array>
#include <complex>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "capi/call.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/input/sample_input.hpp"
#include "workflow/input/scene_words.hpp"

using namespace sarsim;

static_assert(sizeof(std::complex<float>) == 2 * sizeof(float) && sizeof(std::complex<double>) == 2 * sizeof(double));

namespace {

// Rows or columns [first, first + count) of so many, as a caller asks for them.
raster::RowRange range_of(uint64_t first, uint64_t count, std::size_t all, const char* what) {
  if (first > all || count > all - first)
    throw capi::BadArgument(std::string(what) + ": there are " + std::to_string(all) + ", asked for " +
                            std::to_string(count) + " from " + std::to_string(first));
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(count)};
}

template <class Real>
void record(const sarsim_plan* plan, uint64_t first, uint64_t count, Real* samples, const sarsim_work* work) {
  const workflow::ScenePlan& planned = capi::given(plan, "plan").planned;
  const raster::RowRange rows = range_of(first, count, planned.plan.acquisition.timing.rows, "rows");
  const sarsim_work how = capi::work_of(work);
  if (rows.count == 0) return;
  // An array of complex numbers is one of pairs of numbers, and the reverse is what every compiler makes of it.
  auto* const memory = reinterpret_cast<std::complex<Real>*>(&capi::given(samples, "samples"));
  workflow::record_rows(planned, rows, {memory, rows.count * planned.plan.acquisition.reception.columns}, how.threads,
                        capi::observer_of(how));
}

// What the axes of rows say of one row: one number or three.
template <class Take>
void each_value(const raster::Product& product, sarsim_axis axis, std::size_t index, const Take& take) {
  const auto take_all = [&take](const std::array<double, 3>& values) {
    for (const double value : values) take(value);
  };
  switch (axis) {
    case SARSIM_ROW_TIME_S: return take(product.row_time_s(index));
    case SARSIM_ROW_CARRIER_HZ: return take(product.row_carrier_hz(index));
    case SARSIM_COLUMN_RANGE_M: return take(product.column_range_m(index));
    case SARSIM_ROW_POSITION_M: return take_all(product.row_pose(index).position_m);
    case SARSIM_ROW_VELOCITY_MPS: return take_all(product.row_pose(index).velocity_mps);
    case SARSIM_ROW_ROTATION_RAD: return take_all(product.row_pose(index).rotation_rad);
    default: throw capi::BadArgument("sarsim_plan_axis: no such axis");
  }
}

std::optional<scene::FileFormat> format_of(const char* word, const std::string& path) {
  if (word == nullptr) return raster::format_from_path(path);
  const auto format = raster::format_from_name(word);
  if (!format)
    throw core::InvalidRequest("'" + std::string(word) + "' is not a recording format",
                               "it is one of " + raster::format_words());
  return format;
}

}  // namespace

sarsim_status sarsim_plan_new(const sarsim_scene* scene, size_t number, const sarsim_work* work, sarsim_plan** plan,
                              sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    sarsim_plan*& result = capi::cleared(plan, "sarsim_plan_new: plan");
    const workflow::SceneInput& input = capi::given(scene, "sarsim_plan_new: scene").input;
    const sarsim_work how = capi::work_of(work);
    const core::Observer observer = capi::observer_of(how);
    if (number == 0) throw capi::BadArgument("sarsim_plan_new: recordings are counted from 1");
    auto made = std::make_unique<sarsim_plan>();
    made->planned = workflow::plan_of_scene(input, number - 1, observer.control(core::thread_count(how.threads)));
    const simulate::Plan& p = made->planned.plan;
    made->number = number;
    made->product = simulate::product_of(p, {});
    made->processing = workflow::processing_word(p.acquisition.simulation.processing);
    made->format = workflow::format_word(p.acquisition.simulation.format);
    made->file = p.acquisition.simulation.file;
    made->engine = made->product.engine;
    found = made->planned.input.problems;
    result = made.release();
  });
}

void sarsim_plan_free(sarsim_plan* plan) { delete plan; }

sarsim_status sarsim_plan_get_info(const sarsim_plan* plan, sarsim_plan_info* info, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const sarsim_plan& known = capi::given(plan, "sarsim_plan_get_info: plan");
    const simulate::Plan& p = known.planned.plan;
    const simulate::Cost cost = simulate::estimated_cost(p, core::thread_count(0));
    const sarsim_plan_info told{
        .struct_size = sizeof(sarsim_plan_info),
        .rows = p.acquisition.timing.rows,
        .columns = p.acquisition.reception.columns,
        .sample_rate_hz = p.acquisition.simulation.sample_rate_hz,
        .bits = p.acquisition.simulation.bits,
        .lsb_v = p.acquisition.simulation.lsb_v,
        .radar = p.acquisition.link.name.c_str(),
        .processing = known.processing.c_str(),
        .format = known.format.c_str(),
        .file = known.file.c_str(),
        .engine = known.engine.c_str(),
        .engine_reason = p.engine.reason.c_str(),
        .echoes = cost.echoes,
        .seconds = cost.seconds,
        .memory_bytes = cost.memory_bytes,
        .file_bytes = raster::expected_bytes(known.product, {.format = p.acquisition.simulation.format})};
    capi::fill(told, info, "sarsim_plan_get_info: info");
  });
}

sarsim_status sarsim_plan_axis(const sarsim_plan* plan, sarsim_axis axis, uint64_t first, uint64_t count,
                               double* values, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const raster::Product& product = capi::given(plan, "sarsim_plan_axis: plan").product;
    const bool columns = axis == SARSIM_COLUMN_RANGE_M;
    const raster::RowRange range = range_of(first, count, columns ? product.columns : product.rows, "sarsim_plan_axis");
    if (range.count == 0) return;
    double* next = &capi::given(values, "sarsim_plan_axis: values");
    for (std::size_t i = range.first; i < range.end(); ++i)
      each_value(product, axis, i, [&next](double value) { *next++ = value; });
  });
}

sarsim_status sarsim_record_float(const sarsim_plan* plan, uint64_t first, uint64_t count, float* samples,
                                  const sarsim_work* work, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) { record(plan, first, count, samples, work); });
}

sarsim_status sarsim_record_double(const sarsim_plan* plan, uint64_t first, uint64_t count, double* samples,
                                   const sarsim_work* work, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) { record(plan, first, count, samples, work); });
}

sarsim_status sarsim_record_rows(const sarsim_plan* plan, uint64_t first, uint64_t count, uint64_t block,
                                 sarsim_rows rows, void* user, const sarsim_work* work, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const workflow::ScenePlan& planned = capi::given(plan, "sarsim_record_rows: plan").planned;
    const raster::RowRange wanted = range_of(first, count, planned.plan.acquisition.timing.rows, "rows");
    const sarsim_work how = capi::work_of(work);
    if (rows == nullptr) throw capi::BadArgument("sarsim_record_rows: rows is NULL");
    const std::size_t columns = planned.plan.acquisition.reception.columns;
    const std::size_t at_once =
        block > 0 ? static_cast<std::size_t>(std::min<uint64_t>(block, wanted.count)) : workflow::rows_at_once(columns);
    std::vector<std::complex<float>> samples(at_once * columns);
    for (std::size_t row = wanted.first; row < wanted.end(); row += at_once) {
      const raster::RowRange part{row, std::min(at_once, wanted.end() - row)};
      core::Observer observer = capi::observer_of(how);
      if (observer.progress)
        observer.progress = [progress = observer.progress, done = row - wanted.first, all = wanted.count](
                                const std::string& stage, const core::Progress& now) {
          progress(stage, {done + now.done, all, now.columns});
        };
      workflow::record_rows(planned, part, std::span(samples).first(part.count * columns), how.threads, observer);
      if (rows(user, part.first, part.count, reinterpret_cast<const float*>(samples.data())) != 0)
        throw core::Interrupted();
    }
  });
}

sarsim_status sarsim_record_file(const sarsim_plan* plan, const char* path, const sarsim_file_options* options,
                                 const sarsim_work* work, sarsim_file_report* report, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems& found) {
    const workflow::ScenePlan& planned = capi::given(plan, "sarsim_record_file: plan").planned;
    const std::string file = &capi::given(path, "sarsim_record_file: path");
    const sarsim_file_options wanted = capi::taken(options, "options");
    const sarsim_work how = capi::work_of(work);
    if (report != nullptr) static_cast<void>(capi::told_size(report, "sarsim_record_file: report"));
    const workflow::RecordingReport made = workflow::record_file(planned, file, format_of(wanted.format, file),
                                                                 {.replace = wanted.replace != 0,
                                                                  .counts = wanted.counts != 0,
                                                                  .header = wanted.header != 0,
                                                                  .doubles = wanted.doubles != 0},
                                                                 how.threads, capi::observer_of(how));
    found = made.warnings;
    if (report == nullptr) return;
    const sarsim_file_report told{.struct_size = sizeof(sarsim_file_report),
                                  .seconds = made.seconds,
                                  .bytes = made.bytes.value_or(0.0),
                                  .maximum_v = made.run.maximum_v,
                                  .lsb_v = made.run.lsb_v,
                                  .saturated = made.run.saturated,
                                  .zero = made.run.zero};
    capi::fill(told, report, "sarsim_record_file: report");
  });
}
