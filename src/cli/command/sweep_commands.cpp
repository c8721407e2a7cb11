#include "cli/command/sweep_commands.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/text/shell_word.hpp"
#include "raster/table/formats.hpp"
#include "workflow/input/override_words.hpp"

namespace sarsim::cli {

namespace {

// What all lines have at their end.
std::string options_of(const SweepArguments& arguments) {
  const workflow::SweepRequest& request = arguments.words.request;
  std::string text;
  const auto add = [&text](const char* option, std::string_view word) {
    text += fmt::format(" {} {}", option, core::shell_word(word));
  };
  if (request.overrides.format) add("--format", raster::word_of(raster::format_of(*request.overrides.format)));
  if (const std::string words = workflow::words_of_overrides(request.overrides); !words.empty()) text += " " + words;
  if (arguments.engine) add("--engine", simulate::name_of(*arguments.engine));
  if (!arguments.simd.empty()) add("--simd", arguments.simd);
  if (request.folder != ".") add("--out", request.folder);
  for (const auto& [option, given] : {std::pair{" --counts", request.counts}, std::pair{" --header", request.header},
                                      std::pair{" --discard", request.discard}, std::pair{" --force", request.force},
                                      std::pair{" --resume", request.resume}, std::pair{" --strict", request.strict}})
    if (given) text += option;
  return text;
}

}  // namespace

std::string run_commands(const SweepArguments& arguments, const workflow::SweepPlan& plan) {
  const std::string options = options_of(arguments);
  std::string chosen;
  for (const std::string& product : arguments.words.request.products) chosen += " " + core::shell_word(product);
  std::string text;
  auto row = plan.rows.begin();
  for (const std::size_t variation : plan.open) {
    text += fmt::format("sarsim run {}{}", core::shell_word(arguments.scene), chosen);
    workflow::SceneOverrides values;
    plan.sweep.add_to(values, variation);
    text += " " + workflow::words_of_overrides(values);
    while (row->variation != variation) ++row;
    for (; row != plan.rows.end() && row->variation == variation; ++row) {
      const workflow::ProductJob& job = plan.products.at(row->product);
      text += " --set " + core::shell_word(fmt::format("{}{}.file={}", job.table ? "Geometry" : "Simulation",
                                                       job.index + 1, row->file));
    }
    text += options + "\n";
  }
  return text;
}

}  // namespace sarsim::cli
