// The work on echoes of sarsim.h, and its options.

#include <algorithm>
#include <complex>
#include <iterator>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "capi/call.hpp"
#include "capi/labels.hpp"
#include "capi/rasters.hpp"
#include "capi/tables.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/json.hpp"
#include "simulate/run/geometry_table.hpp"
#include "workflow/convert/convert_options.hpp"
#include "workflow/exchange/export_options.hpp"
#include "workflow/focus/focus_report.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/measure_options.hpp"
#include "workflow/options/option_words.hpp"
#include "workflow/product/products.hpp"
#include "workflow/record/geometry.hpp"
#include "workflow/sweep/sweep.hpp"
#include "workflow/sweep/sweep_options.hpp"

using namespace sarsim;

namespace sarsim::capi {

workflow::GivenWords words_of(const std::vector<workflow::Option>& options, const char* const* words,
                              std::size_t count) {
  std::vector<std::string> typed;
  for (std::size_t i = 0; i < told_count(count, max_words, "option_count"); ++i) {
    const std::string word = &given((&given(words, "options"))[i], "options: a word");
    const bool flag = word.find('=') == std::string::npos;
    const std::string name = "--" + word.substr(0, word.find('='));
    const auto option = std::ranges::find(options, name, &workflow::Option::name);
    if (flag && option != options.end() && option->kind != workflow::OptionKind::flag)
      throw core::InvalidRequest("the option '" + word + "' needs a value",
                                 "write " + word + "=" + option->placeholder);
    typed.push_back("--" + word);
  }
  return workflow::given_words(options, typed);
}

}  // namespace sarsim::capi

namespace {

// What all work has in common: how it is done, what was found, and what it came to.
struct Job {
  sarsim_work how;
  core::Observer observer;
  core::Problems& found;
  sarsim_result result{};
};

// Calls `body(job)` and hands its result over.
template <class Body>
sarsim_status do_work(const char* name, const sarsim_work* work, sarsim_result** result, sarsim_problems** problems,
                      const Body& body) noexcept {
  return capi::call(problems, [&](core::Problems& found) {
    sarsim_result*& place = capi::cleared(result, name);
    const sarsim_work how = capi::work_of(work);
    Job job{how, capi::observer_of(how), found};
    job.observer.remark = [&found](const core::Problems& more) { core::append(found, more); };
    body(job);
    job.result.json = core::valid_utf8(job.result.json);
    place = new sarsim_result(std::move(job.result));
  });
}

const workflow::RecordingArguments& input_of(const sarsim_source* source) {
  return capi::given(source, "source").input;
}

// What a scene or recording in memory is, together with what words say of it.
void hold(workflow::RecordingArguments& request, const workflow::RecordingArguments& source) {
  request.held = source.held;
  if (!request.simulation) request.simulation = source.simulation;
}

bool names(const workflow::GivenWords& given, const char* option) { return given.contains(option); }

// The image that was made, in memory or as it was written.
void add_image(Job& job, std::optional<workflow::InMemoryImage> kept, const std::filesystem::path& file) {
  job.result.rasters.push_back(kept ? capi::raster_of_image(*std::move(kept))
                                    : capi::raster_of_file(file.string(), {}, job.observer));
}

// Makes a product of echoes.
template <const auto& product>
void make(Job& job, const sarsim_source* source, const char* const* options, std::size_t count) {
  const workflow::RecordingArguments& input = input_of(source);
  const auto given = capi::words_of(product.options().options(), options, count);
  auto request = product.request(input.path, given);
  hold(request.input, input);
  keep_unnamed(request, given);
  if (!names(given, "--threads")) request.threads = job.how.threads;
  auto report = product.make(request, job.observer);
  job.result.json = core::json_of(workflow::facts_of(report));
  job.result.tables = workflow::tables_of(report);
  for (workflow::MadeImage& image : workflow::take_images(report, request))
    add_image(job, std::move(image.kept), image.file);
}

void theory(Job& job, const sarsim_source* source, const char* const* options, std::size_t count) {
  const workflow::RecordingArguments& input = input_of(source);
  const auto given = capi::words_of(workflow::focus_option_table().options(), options, count);
  workflow::FocusRequest request = workflow::focus_request(input.path, given);
  hold(request.input, input);
  if (!names(given, "--threads")) request.threads = job.how.threads;
  job.result.tables.push_back(workflow::csv_of(workflow::theory_of_focus(request, job.observer)));
}

void measure(Job& job, const sarsim_raster* image, const char* const* options, std::size_t count) {
  const sarsim_raster& known = capi::given(image, "sarsim_measure: image");
  const auto given = capi::words_of(workflow::measure_option_table().options(), options, count);
  workflow::MeasureRequest request = workflow::measure_request(known.path, given);
  if (known.memory != nullptr)
    throw core::InvalidRequest("the caller's memory does not say how it was focused", "give the image of sarsim_focus");
  if (known.image) request.kept = known.image;
  if (!names(given, "--threads")) request.threads = job.how.threads;
  const workflow::MeasureReport report = workflow::measure(request, job.observer);
  job.result.json = core::json_of(workflow::facts_of(known.path, report));
  job.result.tables.push_back(workflow::csv_of(report));
}

void geometry(Job& job, const sarsim_source* source, const char* const* options, std::size_t count) {
  const workflow::RecordingArguments& input = input_of(source);
  workflow::GeometryRequest request;
  request.input.path = input.path;
  const auto table = workflow::geometry_option_table();
  workflow::TakenProblems mistakes = table.take_words(capi::words_of(table.options(), options, count), request);
  if (!mistakes.empty()) throw core::InvalidRequest(std::move(mistakes.early));
  hold(request.input, input);
  workflow::GeometryTables made =
      workflow::geometry_tables(request, job.observer.control(core::thread_count(job.how.threads)));
  core::append(job.found, std::move(made.remarks));
  for (const scene::GeometryTable& wanted : made.tables) {
    std::string csv;
    simulate::write_geometry_csv(
        made.scene, wanted, [&csv](std::string_view piece) { csv += piece; }, job.observer.stop);
    job.result.tables.push_back(std::move(csv));
  }
}

void sweep(Job& job, const sarsim_scene* scene, const char* const* options, std::size_t count) {
  const workflow::SceneInput& input = capi::given(scene, "sarsim_sweep: scene").input;
  const auto given = capi::words_of(workflow::sweep_option_table().options(), options, count);
  workflow::SweepRequest request = workflow::sweep_request(input, given);
  if (!names(given, "--threads")) request.threads = job.how.threads;
  workflow::SweepPlan plan = workflow::plan_sweep(request, job.observer);
  workflow::expect_sound(plan);
  const workflow::SweepReport report = workflow::run_sweep(request, std::move(plan), job.observer);
  const workflow::SweepFrame frame = workflow::frame_of(request, report.plan, report.status());
  job.result.json = workflow::sweep_json(frame, report.plan.rows);
  job.result.tables.push_back(workflow::sweep_csv(frame, report.plan.rows));
  core::append(job.found, workflow::shortened(report.failures));
}

void export_echoes(Job& job, const sarsim_source* source, const char* const* options, std::size_t count) {
  const auto given = capi::words_of(workflow::export_option_table().options(), options, count);
  workflow::ExportRequest request = workflow::export_request(input_of(source), given);
  request.threads = job.how.threads;
  const workflow::ExportReport report = workflow::export_recording(request, job.observer);
  core::JsonWriter json;
  json.begin_object().member("file", request.output.string());
  json.member("vectors", report.vectors).member("samples", report.samples).end_object();
  job.result.json = json.text();
}

std::vector<workflow::Option> options_of(const std::string& work) {
  if (work == "theory") return workflow::focus_option_table().options();
  std::vector<workflow::Option> options;
  std::apply(
      [&](const auto&... product) {
        (..., (work == product.name ? void(options = product.options().options()) : void()));
      },
      workflow::products);
  if (!options.empty()) return options;
  if (work == "measure") return workflow::measure_option_table().options();
  if (work == "geometry") return workflow::geometry_option_table().options();
  if (work == "sweep") return workflow::sweep_option_table().options();
  if (work == "export") return workflow::export_option_table().options();
  if (work == "raster") return workflow::sample_option_table().options();
  if (work == "write") return workflow::convert_option_table().options();
  throw capi::BadArgument("sarsim_options: there is no work '" + work + "'");
}

// The name of an option without hyphens before it.
std::string bare_name(const workflow::Option& option) { return option.name.substr(2); }

const char* word_of(workflow::OptionKind kind) {
  switch (kind) {
    case workflow::OptionKind::flag: return "flag";
    case workflow::OptionKind::texts: return "texts";
    case workflow::OptionKind::number: return "number";
    case workflow::OptionKind::whole: return "whole";
    case workflow::OptionKind::choice: return "choice";
    case workflow::OptionKind::text: break;
  }
  return "text";
}

void write_option(core::JsonWriter& json, const workflow::Option& option) {
  json.begin_object().member("name", bare_name(option)).member("kind", word_of(option.kind));
  json.member("takes", option.placeholder).member("help", option.help);
  if (option.kind == workflow::OptionKind::choice) {
    json.key("words").begin_array();
    for (const std::string& word : option.words) json.value(word);
    json.end_array();
  }
  if (option.kind == workflow::OptionKind::whole) json.member("least", option.low).member("most", option.high);
  json.end_object();
}

std::string json_of_options(const std::vector<workflow::Option>& options) {
  core::JsonWriter json;
  json.begin_array();
  for (const workflow::Option& option : options) write_option(json, option);
  return json.end_array().text();
}

std::string lines_of_options(const std::vector<workflow::Option>& options) {
  std::string text;
  for (const workflow::Option& option : options) {
    text += bare_name(option);
    if (!option.placeholder.empty()) text += "=" + option.placeholder;
    text += ": " + option.help + "\n";
  }
  return text;
}

// A recording in the caller's memory, as the workflows read one.
template <class Real>
sarsim_source* source_of_memory(const sarsim_plan& plan, const Real* samples) {
  const workflow::ScenePlan& planned = plan.planned;
  const auto* const memory = reinterpret_cast<const std::complex<Real>*>(samples);
  const std::size_t columns = planned.plan.acquisition.reception.columns;
  const auto held = std::make_shared<workflow::HeldScene>();
  held->input = planned.input;
  held->rows = core::SampleRows<double>{planned.plan.acquisition.timing.rows, columns,
                                        [memory, columns](std::size_t row, std::span<std::complex<double>> out) {
                                          std::copy_n(memory + row * columns, columns, out.begin());
                                        }};
  auto made = std::make_unique<sarsim_source>();
  made->input.path = plan.file.empty() ? "memory" : plan.file;
  made->input.simulation = static_cast<std::int64_t>(plan.number);
  made->input.held = held;
  return made.release();
}

}  // namespace

void sarsim_source_free(sarsim_source* source) { delete source; }

sarsim_status sarsim_source_file(const char* path, sarsim_source** source, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_source*& result = capi::cleared(source, "sarsim_source_file: source");
    auto made = std::make_unique<sarsim_source>();
    made->input.path = &capi::given(path, "sarsim_source_file: path");
    result = made.release();
  });
}

sarsim_status sarsim_source_scene(const sarsim_scene* scene, size_t number, sarsim_source** source,
                                  sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_source*& result = capi::cleared(source, "sarsim_source_scene: source");
    const auto held = std::make_shared<workflow::HeldScene>();
    held->input = capi::given(scene, "sarsim_source_scene: scene").input;
    auto made = std::make_unique<sarsim_source>();
    made->input.path = held->input.sources.empty() ? "scene" : held->input.sources.front().string();
    if (number > 0) made->input.simulation = static_cast<std::int64_t>(number);
    made->input.held = held;
    result = made.release();
  });
}

sarsim_status sarsim_source_floats(const sarsim_plan* plan, const float* samples, sarsim_source** source,
                                   sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_source*& result = capi::cleared(source, "sarsim_source_floats: source");
    result = source_of_memory(capi::given(plan, "sarsim_source_floats: plan"),
                              &capi::given(samples, "sarsim_source_floats: samples"));
  });
}

sarsim_status sarsim_source_doubles(const sarsim_plan* plan, const double* samples, sarsim_source** source,
                                    sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_source*& result = capi::cleared(source, "sarsim_source_doubles: source");
    result = source_of_memory(capi::given(plan, "sarsim_source_doubles: plan"),
                              &capi::given(samples, "sarsim_source_doubles: samples"));
  });
}

void sarsim_result_free(sarsim_result* result) { delete result; }
const char* sarsim_result_json(const sarsim_result* result) { return result != nullptr ? result->json.c_str() : "{}"; }
size_t sarsim_result_raster_count(const sarsim_result* result) {
  return result != nullptr ? result->rasters.size() : 0;
}
size_t sarsim_result_table_count(const sarsim_result* result) { return result != nullptr ? result->tables.size() : 0; }

sarsim_status sarsim_result_raster(const sarsim_result* result, size_t index, sarsim_raster** raster,
                                   sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_raster*& place = capi::cleared(raster, "sarsim_result_raster: raster");
    const sarsim_result& known = capi::given(result, "sarsim_result_raster: result");
    if (index >= known.rasters.size()) throw capi::BadArgument("sarsim_result_raster: no such raster");
    place = new sarsim_raster(known.rasters[index]);
  });
}

sarsim_status sarsim_result_table(const sarsim_result* result, size_t index, sarsim_table** table,
                                  sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_table*& place = capi::cleared(table, "sarsim_result_table: table");
    const sarsim_result& known = capi::given(result, "sarsim_result_table: result");
    if (index >= known.tables.size()) throw capi::BadArgument("sarsim_result_table: no such table");
    place = capi::table_handle(known.tables[index]);
  });
}

sarsim_status sarsim_options(const char* work, sarsim_style style, sarsim_text** text, sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    sarsim_text*& result = capi::cleared(text, "sarsim_options: text");
    if (style != SARSIM_WORDS && style != SARSIM_JSON) throw capi::BadArgument("sarsim_options: no such style");
    const std::vector<workflow::Option> options = options_of(&capi::given(work, "sarsim_options: work"));
    result = capi::text_handle(style == SARSIM_JSON ? json_of_options(options) : lines_of_options(options));
  });
}

// A function of sarsim.h that does work.
// @param body  of `(job, subject, options, option_count)`
#define SARSIM_WORK_FUNCTION(name, Subject, subject, body)                                                             \
  sarsim_status name(const Subject* subject, const char* const* options, size_t option_count, const sarsim_work* work, \
                     sarsim_result** result, sarsim_problems** problems) {                                             \
    return do_work(#name ": result", work, result, problems,                                                           \
                   [&](Job& job) { body(job, subject, options, option_count); });                                      \
  }

SARSIM_WORK_FUNCTION(sarsim_focus, sarsim_source, source, make<workflow::focus_product>)
SARSIM_WORK_FUNCTION(sarsim_profiles, sarsim_source, source, make<workflow::profiles_product>)
SARSIM_WORK_FUNCTION(sarsim_isar, sarsim_source, source, make<workflow::isar_product>)
SARSIM_WORK_FUNCTION(sarsim_doppler, sarsim_source, source, make<workflow::doppler_product>)
SARSIM_WORK_FUNCTION(sarsim_search, sarsim_source, source, make<workflow::search_product>)
SARSIM_WORK_FUNCTION(sarsim_measure, sarsim_raster, image, measure)
SARSIM_WORK_FUNCTION(sarsim_theory, sarsim_source, source, theory)
SARSIM_WORK_FUNCTION(sarsim_geometry, sarsim_source, source, geometry)
SARSIM_WORK_FUNCTION(sarsim_sweep, sarsim_scene, scene, sweep)
SARSIM_WORK_FUNCTION(sarsim_export, sarsim_source, source, export_echoes)

#undef SARSIM_WORK_FUNCTION
