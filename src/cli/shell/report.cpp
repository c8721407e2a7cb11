#include "cli/shell/report.hpp"

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "workflow/input/scene_words.hpp"

namespace sarsim::cli {

namespace {

double share(std::uint64_t part, const raster::RunReport& run) {
  const double samples = static_cast<double>(run.rows) * static_cast<double>(run.columns);
  return samples > 0.0 ? static_cast<double>(part) / samples : 0.0;
}

std::string millivolts(double volts) { return fmt::format("{:.6G} mV", 1e3 * volts); }

std::string lsb_line(const workflow::RecordingReport& report) {
  const bool given = report.simulation.lsb_v > 0.0;
  if (!report.counts && !given) return fmt::format("  best LSB           {}", millivolts(report.run.best_lsb_v));
  return fmt::format("  LSB                {} ({}), best {}", millivolts(report.run.lsb_v),
                     given ? "as given" : "estimated from the data", millivolts(report.run.best_lsb_v));
}

}  // namespace

std::string decimals(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.starts_with('-') && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string report_text(const workflow::RecordingReport& report) {
  const raster::RunReport& run = report.run;
  std::string text = fmt::format(
      "{}: {} x {} samples, {}{}\n", report.file.empty() ? "nothing written" : report.file, run.rows, run.columns,
      report.bytes ? core::bytes_text(*report.bytes) + ", " : std::string(), core::duration_text(report.seconds));
  if (report.counts)
    text += fmt::format("  largest magnitude  {}, {:.4g} % of the converter's range\n", millivolts(run.maximum_v),
                        100.0 * run.range_used);
  else
    text += fmt::format("  largest magnitude  {}\n", millivolts(run.maximum_v));
  text += lsb_line(report) + "\n";
  if (report.counts)
    text += fmt::format("  samples            {:.4g} % saturated, {:.4g} % zero\n", 100.0 * share(run.saturated, run),
                        100.0 * share(run.zero, run));
  else
    text += fmt::format("  samples            volts, not quantised: --quantise applies the {}-bit converter\n",
                        report.simulation.bits);
  text += fmt::format("  engine             {} ({}), relative error below {:g}\n", report.engine, report.engine_reason,
                      report.engine == "reference" ? 1e-12 : report.options.tolerance);
  if (run.saturated > 0)
    text += fmt::format("  some samples were clipped: an LSB of {} would avoid clipping\n", millivolts(run.best_lsb_v));
  return text;
}

void write_json(core::JsonWriter& json, const workflow::RecordingReport& report) {
  const raster::RunReport& run = report.run;
  json.begin_object().member("kind", "recording").key("file");
  if (report.file.empty())
    json.null();
  else
    json.value(report.file);
  json.member("format", workflow::format_word(report.simulation.format)).member("counts", report.counts);
  json.member("quantised", report.counts);
  json.member("processing", workflow::processing_word(report.simulation.processing));
  json.member("rows", run.rows).member("columns", run.columns).key("bytes");
  report.bytes ? json.value(*report.bytes) : json.null();
  json.member("seconds", report.seconds).member("maximum_v", run.maximum_v).member("lsb_v", run.lsb_v);
  json.member("lsb_estimated", report.simulation.lsb_v <= 0.0).member("best_lsb_v", run.best_lsb_v);
  json.member("range_used", run.range_used).member("saturated", run.saturated).member("zero", run.zero);
  json.member("radar", report.simulation.radar).member("bits", report.simulation.bits);
  json.member("profile", workflow::profile_word(report.options.profile))
      .member("pulse", workflow::pulse_word(report.options.pulse));
  json.member("seed", report.options.seed)
      .member("engine", report.engine)
      .member("engine_reason", report.engine_reason);
  json.member("tolerance", report.options.tolerance).key("warnings");
  write_json(json, report.warnings);
  json.end_object();
}

void write_json(core::JsonWriter& json, const workflow::TableReport& report) {
  json.begin_object().member("kind", "geometry").key("file");
  if (report.file.empty())
    json.null();
  else
    json.value(report.file);
  json.member("radar", report.radar).member("bytes", report.bytes).member("seconds", report.seconds).end_object();
}

}  // namespace sarsim::cli
