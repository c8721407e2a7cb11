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
  std::string text;
  const auto add = [&text](const char* option, std::string_view word) {
    text += fmt::format(" {} {}", option, core::shell_word(word));
  };
  if (arguments.overrides.format) add("--format", raster::word_of(raster::format_of(*arguments.overrides.format)));
  if (const std::string words = workflow::words_of_overrides(arguments.overrides); !words.empty()) text += " " + words;
  if (arguments.engine) add("--engine", simulate::name_of(*arguments.engine));
  if (!arguments.simd.empty()) add("--simd", arguments.simd);
  if (arguments.folder != ".") add("--out", arguments.folder);
  for (const auto& [option, given] :
       {std::pair{" --counts", arguments.counts}, std::pair{" --header", arguments.header},
        std::pair{" --discard", arguments.discard}, std::pair{" --force", arguments.force},
        std::pair{" --resume", arguments.resume}, std::pair{" --strict", arguments.strict}})
    if (given) text += option;
  return text;
}

}  // namespace

std::string run_commands(const SweepArguments& arguments, const workflow::SweepPlan& plan) {
  const std::string options = options_of(arguments);
  std::string chosen;
  for (const std::string& product : arguments.products) chosen += " " + core::shell_word(product);
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
