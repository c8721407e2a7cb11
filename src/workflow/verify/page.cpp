#include "workflow/verify/page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "workflow/verify/svg.hpp"

namespace sarsim::workflow::verify {

namespace {

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 62em; padding: 0 1em; color: #222; }
table { border-collapse: collapse; width: 100%; margin: .6em 0 1.4em; }
th, td { text-align: left; padding: .2em .6em; border-bottom: 1px solid #ddd; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.source { color: #666; font-size: 13px; }
.holds { color: #00734f; } .fails { color: #b00020; font-weight: bold; }
svg { width: 100%; max-width: 640px; height: auto; display: block; margin: 1em 0; background: #fff; }
svg text { font: 12px system-ui, sans-serif; } svg text.title { font-weight: bold; font-size: 13px; }
svg .grid { stroke: #e4e4e4; } svg .frame { fill: none; stroke: #888; }
@media print { body { margin: 0; max-width: none; } }
)";

std::string row_of(const Finding& f) {
  if (!f.failure.empty())
    return fmt::format("<tr><td>{}</td><td colspan=\"4\">{}</td><td class=\"fails\">failed</td></tr>\n",
                       xml_text(f.name), xml_text(f.failure));
  return fmt::format(
      "<tr><td>{}<br><span class=\"source\">{}</span></td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td>{}</td><td class=\"{}\">{}</td></tr>\n",
      xml_text(f.name), xml_text(f.source), value_text(f.expected, f), value_text(f.measured, f),
      xml_text(bound_text(f)), xml_text(f.unit), f.holds ? "holds" : "fails", f.holds ? "holds" : "does not hold");
}

std::vector<std::string> groups_of(const Record& record) {
  std::vector<std::string> groups;
  for (const Finding& f : record.findings())
    if (std::ranges::find(groups, f.group) == groups.end()) groups.push_back(f.group);
  return groups;
}

std::string group_text(const Record& record, const std::string& group) {
  std::string html = fmt::format("<h2>{}</h2>\n", xml_text(group));
  for (const Chart& chart : record.charts())
    if (chart.group == group) html += svg_of(chart);
  html +=
      "<table>\n<tr><th>quantity</th><th>expected</th><th>measured</th><th>tolerance</th><th>unit</th><th></th></tr>\n";
  for (const Finding& f : record.findings())
    if (f.group == group) html += row_of(f);
  return html + "</table>\n";
}

}  // namespace

std::string value_text(double value, const Finding& finding) {
  if (value == 0.0) return "0";
  if (finding.bound != Bound::near) return fmt::format("{:.4g}", value);
  // Two digits beyond the first one that the tolerance allows to differ.
  const double size = std::max(std::abs(finding.expected), std::abs(value));
  const double span = finding.tolerance > 0.0 ? std::log10(size / finding.tolerance) : 6.0;
  return fmt::format("{:.{}g}", value, std::clamp(static_cast<int>(std::ceil(span)) + 2, 3, 15));
}

std::string bound_text(const Finding& finding) {
  switch (finding.bound) {
    case Bound::near: return finding.tolerance == 0.0 ? "exact" : fmt::format("+- {:.2g}", finding.tolerance);
    case Bound::at_most: return "at most";
    case Bound::at_least: return "at least";
  }
  return {};
}

std::size_t holding(const Record& record) {
  return static_cast<std::size_t>(
      std::ranges::count_if(record.findings(), [](const Finding& finding) { return finding.holds; }));
}

std::string page_of(const Record& record, const Facts& facts) {
  const std::size_t good = holding(record);
  const std::size_t all = record.findings().size();
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>sarsim verify</title>\n<style>{}</style>\n"
      "</head>\n<body>\n<h1>sarsim verify</h1>\n",
      style);
  html += fmt::format("<p class=\"{}\">{} of {} comparisons agree.</p>\n<table>\n", good == all ? "holds" : "fails",
                      good, all);
  for (const auto& [name, value] : facts)
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", xml_text(name), xml_text(value));
  html += "</table>\n";
  for (const std::string& group : groups_of(record)) html += group_text(record, group);
  return html + "</body>\n</html>\n";
}

}  // namespace sarsim::workflow::verify
