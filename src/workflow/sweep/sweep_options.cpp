#include "workflow/sweep/sweep_options.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/recording_options.hpp"
#include "workflow/sweep/swept_field.hpp"

namespace sarsim::workflow {

namespace {

OptionTable<SweepValues> value_options() {
  OptionTable<SweepValues> table;
  table.texts("--set", "FIELD=VALUES",
              "a field and its values: x, a,b,c, start:step:end, first..last, or random ones as normal(1, 0.2); repeat "
              "for combinations",
              [](SweepValues& values, const std::string& word) { values.settings.push_back(word); });
  table.text("--values", "CSV", "table of values: a column for each field, a line for each variation",
             [](SweepValues& values, const std::string& word) { values.table = word; });
  table.flag("--zip", "pair all values instead of combining them", &SweepValues::paired);
  table.whole("--draws", 1, max_variations, "how many random values are drawn",
              [](SweepValues& values, std::uint64_t n) { values.draws = static_cast<std::size_t>(n); });
  return table;
}

OptionTable<PostProcessingLabels> post_processing_options() {
  OptionTable<PostProcessingLabels> table;
  table.flag("--focus", "focus each recording to an image, NAME.img", &PostProcessingLabels::focus);
  table.flag("--measure", "measure each image against expected values: columns of the table",
             &PostProcessingLabels::measure);
  table.flag("--search", "PPI display and detections of each recording: columns of the table",
             &PostProcessingLabels::search);
  table.flag("--profiles", "make range profiles of each recording: columns of the table",
             &PostProcessingLabels::profiles);
  table.text("--with", "OPTIONS", "options of --focus, --search or --profiles, in quotes", &PostProcessingLabels::with)
      .takes_options = true;
  return table;
}

OptionTable<SweepRequest> output_options() {
  OptionTable<SweepRequest> table;
  table.text("--out", "DIR", "folder for all files; made when missing (default: the current one)",
             &SweepRequest::folder);
  table.text("--table", "NAME", "name of the tables and the journal (default: sweep)", &SweepRequest::table);
  table.whole("--jobs", 0, 4096, "variations at a time; 0 for as many as there are threads (default)",
              &SweepRequest::jobs);
  table.whole("--threads", 0, 4096, "threads of all of them; 0 for one per core (default)", &SweepRequest::threads);
  table.text("--part", "K/N", "only every Nth variation, from the Kth: a share for one machine of N",
             [](SweepRequest& request, const std::string& word) { request.part = read_part(word); });
  table.flag("--resume", "leave out what an earlier run completed", &SweepRequest::resume);
  table.flag("--counts", "converter counts instead of volts in HDF5, NPY, Zarr and SigMF", &SweepRequest::counts);
  table.flag("--header", "a header line in CSV", &SweepRequest::header);
  table.flag("--discard", "write the tables only, no recordings", &SweepRequest::discard);
  table.flag("--strict", "warnings end the sweep before it begins", &SweepRequest::strict);
  table.flag("--force", "replace files that exist", &SweepRequest::force);
  return table;
}

}  // namespace

SweepPart read_part(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const auto index = core::parse_integer(text.substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : core::parse_integer(text.substr(slash + 1));
  if (!index || !count)
    throw core::InvalidRequest(fmt::format("--part: '{}' is not a valid part", text),
                               "write K/N, for instance 2/4 for the second of four");
  if (*count < 1 || *count > static_cast<std::int64_t>(max_variations) || *index < 1 || *index > *count)
    throw core::InvalidRequest(fmt::format("--part: there is no part {}", text),
                               fmt::format("parts are numbered from 1 to N, and N is {} at most", max_variations));
  return {static_cast<std::size_t>(*index) - 1, static_cast<std::size_t>(*count)};
}

PostProcessing post_processing_of(const PostProcessingLabels& given) {
  using Kind = PostProcessing::Kind;
  PostProcessing post_processing;
  for (const auto& [kind, wanted] : {std::pair{Kind::focus, given.focus}, std::pair{Kind::search, given.search},
                                     std::pair{Kind::profiles, given.profiles}}) {
    if (!wanted) continue;
    if (post_processing)
      throw core::InvalidRequest(
          fmt::format("--{} and --{} cannot be made of one sweep", word_of(post_processing.kind), word_of(kind)),
          "leave one of them out, and make the other in a sweep of its own");
    post_processing.kind = kind;
  }
  post_processing.measure = given.measure;
  post_processing.words = given.with;
  return post_processing;
}

OptionTable<SweepWords> common_sweep_options() {
  OptionTable<SweepWords> table;
  table.include(value_options(), [](SweepWords& words) -> SweepValues& { return words.request.values; });
  table.include(post_processing_options(), &SweepWords::post_processing);
  table.include(output_options(), [](SweepWords& words) -> SweepRequest& { return words.request; });
  table.include(run_choice_options(), [](SweepWords& words) -> SceneOverrides& { return words.request.overrides; });
  return table;
}

OptionTable<SweepWords> sweep_option_table() {
  OptionTable<SweepWords> table = common_sweep_options();
  table.texts("--product", "NUMBER|NAME", "which products: numbers of simulations from 1, or output names; repeat",
              [](SweepWords& words, const std::string& word) { words.request.products.push_back(word); });
  return table;
}

SweepRequest sweep_request(const SceneInput& input, const GivenWords& given) {
  SweepWords words;
  TakenProblems problems = sweep_option_table().take_words(given, words);
  core::append(problems.early, std::move(problems.late));
  if (!problems.early.empty()) throw core::InvalidRequest(std::move(problems.early));
  SweepRequest& request = words.request;
  request.post_processing = post_processing_of(words.post_processing);
  const auto held = std::make_shared<HeldScene>();
  held->input = check_again(input, CheckLevel::reading, {core::thread_count(request.threads)}, {}, request.overrides);
  core::Problems of_files = read_files_of(
      held->input.scene, input.sources.empty() ? std::filesystem::path() : input.sources.front().parent_path(),
      {core::thread_count(request.threads)});
  if (core::has_errors(of_files)) throw core::InvalidRequest(std::move(of_files));
  request.scene = held->input.scene;
  request.script = input.sources.empty() ? std::string("scene") : input.sources.front().string();
  request.places = held->input.places;
  request.sources = held->input.sources;
  request.values.folder = std::filesystem::path(request.script).parent_path();
  request.overrides = {};  // They are in the scene.
  request.held = held;
  return std::move(request);
}

}  // namespace sarsim::workflow
