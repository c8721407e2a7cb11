#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <ostream>
#include <span>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/output_names.hpp"
#include "core/build/version.hpp"
#include "core/os/output_file.hpp"
#include "core/task/clock.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/page.hpp"

namespace sarsim::cli {

namespace {

using workflow::verify::Finding;

struct VerifyArguments {
  std::string html;
  bool quick = false;
  bool json = false;
  bool force = false;
  bool quiet = false;
};

// "model name : ..." of the first processor; empty where the system does not say.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  return {};
}

workflow::verify::Facts facts_of(const VerifyArguments& arguments, double seconds) {
  workflow::verify::Facts facts{{"Program", fmt::format("sarsim {}", core::program_version)}};
  if (const std::string name = processor(); !name.empty()) facts.emplace_back("Processor", name);
  facts.emplace_back("Instruction set", simulate::simd_level());
  facts.emplace_back("Measured", arguments.quick ? "quickly: fewer samples, no speed" : "everything");
  facts.emplace_back("Time", core::duration_text(seconds));
  return facts;
}

std::string line_of(const Finding& f) {
  if (!f.failure.empty()) return fmt::format("  FAILED  {}: {}\n", f.name, f.failure);
  return fmt::format("  {:<6}  {:<64} {:>16}  {:>16} {:<8} {}\n", f.holds ? "holds" : "FAILED", f.name,
                     workflow::verify::value_text(f.measured, f), workflow::verify::value_text(f.expected, f), f.unit,
                     workflow::verify::bound_text(f));
}

std::string text_of(const workflow::verify::Record& record, bool failures_only) {
  std::string text;
  std::string group;
  for (const Finding& f : record.findings()) {
    if (failures_only && f.holds) continue;
    if (f.group != group) text += fmt::format("{}{}\n", text.empty() ? "" : "\n", f.group);
    group = f.group;
    if (!failures_only && text.find("measured") == std::string::npos)
      text += fmt::format("  {:<6}  {:<64} {:>16}  {:>16}\n", "", "", "measured", "expected");
    text += line_of(f);
  }
  return text + fmt::format("{}{} of {} statements hold\n", text.empty() ? "" : "\n", workflow::verify::holding(record),
                            record.findings().size());
}

std::string json_of(const workflow::verify::Record& record, const workflow::verify::Facts& facts, double seconds) {
  static constexpr const char* bounds[] = {"near", "at most", "at least"};
  core::JsonWriter json;
  json.begin_object()
      .member("sarsim", core::program_version)
      .member("simd", simulate::simd_level())
      .member("seconds", seconds);
  json.key("facts").begin_object();
  for (const auto& [name, value] : facts) json.member(name, value);
  json.end_object().key("findings").begin_array();
  for (const Finding& f : record.findings()) {
    json.begin_object().member("group", f.group).member("name", f.name).member("unit", f.unit);
    json.member("bound", bounds[static_cast<std::size_t>(f.bound)]).member("expected", f.expected);
    json.member("measured", f.measured).member("tolerance", f.tolerance).member("holds", f.holds);
    json.member("source", f.source);
    if (!f.failure.empty()) json.member("failure", f.failure);
    json.end_object();
  }
  json.end_array().member("holding", workflow::verify::holding(record)).member("all", record.findings().size());
  return json.end_object().text();
}

ExitStatus verify_program(const VerifyArguments& arguments, Streams& streams) {
  std::optional<core::OutputFile> page;
  if (!arguments.html.empty()) {
    expect_free_outputs({arguments.html}, {{}, arguments.force, "--html"});
    page.emplace(arguments.html, arguments.force);  // Before anything is measured: where it cannot be, nobody waits.
  }
  const double begin_s = core::now_s();
  const workflow::verify::Record record = workflow::verify::verify_all({arguments.quick, streams.stop});
  const double seconds = core::now_s() - begin_s;
  const workflow::verify::Facts facts = facts_of(arguments, seconds);
  if (page) {
    const std::string text = workflow::verify::page_of(record, facts);
    page->write(std::as_bytes(std::span(text)));
    page->commit();
  }
  write_out(streams, arguments.json ? json_of(record, facts, seconds) : text_of(record, arguments.quiet));
  return workflow::verify::holding(record) == record.findings().size() ? exit_done : exit_failed;
}

}  // namespace

Action add_verify(CLI::App& app) {
  auto arguments = std::make_shared<VerifyArguments>();
  add_text(app, "--html", arguments->html, "FILE", "also a page with tables and charts");
  app.add_flag("--quick", arguments->quick, "fewer samples, and no measurement of speed");
  app.add_flag("--json", arguments->json, "the findings as JSON");
  app.add_flag("--force", arguments->force, "replace the page where it exists");
  app.add_flag("--quiet", arguments->quiet, "only what does not hold");
  add_examples(app, {{"sarsim verify", "everything, in some seconds"},
                     {"sarsim verify --quick --quiet", "in a script; exit status 1 where something does not hold"},
                     {"sarsim verify --html verify.html", "a page to keep"}});
  return [arguments](Streams& streams) { return verify_program(*arguments, streams); };
}

}  // namespace sarsim::cli
