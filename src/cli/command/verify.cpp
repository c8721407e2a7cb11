#include <memory>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "core/build/version.hpp"
#include "core/text/json.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "workflow/verify/page.hpp"
#include "workflow/verify/verify.hpp"

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
  return text + fmt::format("{}{} of {} comparisons agree\n", text.empty() ? "" : "\n",
                            workflow::verify::holding(record), record.findings().size());
}

std::string json_of(const workflow::verify::VerifyReport& report) {
  const workflow::verify::Record& record = report.record;
  static constexpr const char* bounds[] = {"near", "at most", "at least"};
  core::JsonWriter json;
  json.begin_object()
      .member("sarsim", core::program_version)
      .member("simd", simulate::simd_level())
      .member("seconds", report.seconds);
  json.key("facts").begin_object();
  for (const auto& [name, value] : report.facts) json.member(name, value);
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
  core::Observer observer;
  observer.stop = streams.stop;
  const workflow::verify::VerifyReport report =
      workflow::verify::verify_program({arguments.quick, arguments.html, arguments.force}, observer);
  write_out(streams, arguments.json ? json_of(report) : text_of(report.record, arguments.quiet));
  return workflow::verify::holding(report.record) == report.record.findings().size() ? exit_done : exit_failed;
}

}  // namespace

Action add_verify(CLI::App& app) {
  auto arguments = std::make_shared<VerifyArguments>();
  add_text(app, "--html", arguments->html, "FILE", "also a page with tables and charts");
  app.add_flag("--quick", arguments->quick, "fewer samples, and no measurement of speed");
  app.add_flag("--json", arguments->json, "the findings as JSON");
  app.add_flag("--force", arguments->force, "replace the page where it exists");
  app.add_flag("--quiet", arguments->quiet, "only comparisons that fail");
  add_examples(app, {{"sarsim verify", "all comparisons, in a few seconds"},
                     {"sarsim verify --quick --quiet", "in a script; exit status 1 if a comparison fails"},
                     {"sarsim verify --html verify.html", "a page to keep"}});
  return [arguments](Streams& streams) { return verify_program(*arguments, streams); };
}

}  // namespace sarsim::cli
