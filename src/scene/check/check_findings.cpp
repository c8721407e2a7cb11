#include "scene/check/check_findings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/model/limits.hpp"

namespace sarsim::scene {

namespace {

// Names can be of any length, messages cannot.
std::string clipped(std::string text) {
  constexpr std::size_t longest = 200;
  if (text.size() > longest) text.replace(longest, std::string::npos, "...");
  return text;
}

std::string title(const FunctionRule& rule, std::size_t part) {
  const std::string_view name = part < rule.parts.size() ? rule.parts[part] : std::string_view{};
  return name.empty() ? std::string(rule.what) : fmt::format("{} {}", rule.what, name);
}

bool check_points_are_numbers(Findings& findings, const FunctionRule& rule, std::size_t part,
                              const core::SampledFunction& function) {
  const auto bad = std::ranges::find_if(
      function.knots, [](const core::Knot& knot) { return !std::isfinite(knot.x) || !std::isfinite(knot.y); });
  if (bad == function.knots.end()) return true;
  findings.error(rule.field,
                 {.id = "function.not-finite",
                  .message = fmt::format("a point of the {} is not a finite number", title(rule, part)),
                  .found = fmt::format("point {}: {:g}, {:g}", bad - function.knots.begin() + 1, bad->x, bad->y),
                  .expected = "finite numbers"});
  return false;
}

bool check_points_are_computable(Findings& findings, const FunctionRule& rule, std::size_t part,
                                 const core::SampledFunction& function) {
  const auto bad = std::ranges::find_if(
      function.knots, [](const core::Knot& knot) { return !computable(knot.x) || !computable(knot.y); });
  if (bad == function.knots.end()) return true;
  findings.error(rule.field,
                 too_large(fmt::format("point of the {}", title(rule, part)),
                           fmt::format("point {}: {:g}, {:g}", bad - function.knots.begin() + 1, bad->x, bad->y), ""));
  return false;
}

bool check_points_ascend(Findings& findings, const FunctionRule& rule, std::size_t part,
                         const core::SampledFunction& function) {
  const auto first = std::ranges::adjacent_find(function.knots, std::ranges::greater_equal{}, &core::Knot::x);
  if (first == function.knots.end()) return true;
  findings.error(rule.field, {.id = "function.not-ascending",
                              .message = fmt::format("the points of the {} do not ascend", title(rule, part)),
                              .found = fmt::format("x = {:.9g} after {:.9g} at point {}", std::next(first)->x, first->x,
                                                   first - function.knots.begin() + 2),
                              .expected = "each x above the one before",
                              .hint = "Sort the points by their first number and give each of these once."});
  return false;
}

// The low-pass filter reads every point as if it stood at its even place: farther from there it misses the point.
// A table whose x is rounded to a few digits is even; the value is then off by at most this part of a spacing.
constexpr double even_within = 0.05;

void check_points_are_even(Findings& findings, const FunctionRule& rule, std::size_t part,
                           const core::SampledFunction& function) {
  const auto& knots = function.knots;
  if (function.method != core::Interpolation::low_pass || knots.size() < 3) return;
  const double spacing = (knots.back().x - knots.front().x) / static_cast<double>(knots.size() - 1);
  std::size_t worst = 0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double off = std::abs((knots[i].x - knots.front().x) / spacing - static_cast<double>(i));
    if (off <= farthest) continue;
    farthest = off;
    worst = i;
  }
  if (!(farthest > even_within)) return;
  findings.warning(
      Consequence::lost_signal, rule.field,
      {.id = "function.not-even",
       .message = fmt::format("the points of the {} are not evenly spaced: an MFILTER path does not pass through them",
                              title(rule, part)),
       .found = fmt::format("x = {:.9g} at point {}, {:.3g} spacings from its even position", knots[worst].x, worst + 1,
                            farthest),
       .expected = fmt::format("points {:.9g} apart, within {:g} %", spacing, 100.0 * even_within),
       .hint = "Use CUBIC, which passes through points at any spacing, or give the points at even spacing."});
}

bool check_not_empty(Findings& findings, const FunctionRule& rule, std::size_t part,
                     const core::SampledFunction& function) {
  if (!function.knots.empty() || rule.empty == FunctionRule::Empty::allowed) return true;
  const std::string message = fmt::format("the {} has no points", title(rule, part));
  if (rule.empty == FunctionRule::Empty::error) {
    findings.error(rule.field,
                   {.id = "function.empty", .message = message, .found = "0 points", .expected = "at least one point"});
    return false;
  }
  findings.warning(Consequence::surprise, rule.field,
                   {.id = "function.counts-as-zero",
                    .message = message + " and counts as 0 throughout",
                    .found = "0 points",
                    .expected = "at least one point",
                    .hint = "One point is enough for a constant."});
  return true;
}

}  // namespace

Finding too_large(std::string_view what, std::string found, std::string_view unit) {
  return {.id = "value.too-large",
          .message = fmt::format("the {} is too large to compute with", what),
          .found = std::move(found),
          .expected = fmt::format("a magnitude up to {:g} {}", largest_value, unit)};
}

std::string value_text(double value, std::string_view unit) {
  static constexpr std::string_view prefixed[] = {"Hz", "s", "W", "V"};
  if (std::ranges::find(prefixed, unit) != std::end(prefixed)) return core::with_prefix(value, unit);
  return unit.empty() ? fmt::format("{:.9g}", value) : fmt::format("{:.9g} {}", value, unit);
}

void Findings::about(std::string_view kind, std::size_t index) {
  subject_.kind = kind;
  subject_.index = index;
}

void Findings::add(core::Severity severity, int rank, std::string_view field, Finding&& finding, std::size_t count) {
  core::Problem problem{.severity = severity,
                        .message = std::move(finding.message),
                        .found = clipped(std::move(finding.found)),
                        .expected = clipped(std::move(finding.expected)),
                        .hint = std::move(finding.hint),
                        .place = {},
                        .subject = subject_,
                        .count = count,
                        .id = finding.id};
  problem.subject.field = field;
  entries_.push_back({rank, std::move(problem)});
}

void Findings::error(std::string_view field, Finding finding) {
  add(core::Severity::error, 0, field, std::move(finding));
}

void Findings::warning(Consequence consequence, std::string_view field, Finding finding) {
  add(core::Severity::warning, static_cast<int>(consequence), field, std::move(finding));
}

void Findings::note(std::string_view field, Finding finding, std::size_t count) {
  add(core::Severity::note, 0, field, std::move(finding), count);
}

void Findings::append(Findings&& later) { std::ranges::move(later.entries_, std::back_inserter(entries_)); }

core::Problems Findings::take() && {
  // A warning about an object with an error may only follow from the error.
  std::set<std::pair<std::string, std::size_t>> faulty;
  for (const Entry& entry : entries_)
    if (entry.problem.severity == core::Severity::error)
      faulty.insert({entry.problem.subject.kind, entry.problem.subject.index});
  std::erase_if(entries_, [&](const Entry& entry) {
    return entry.problem.severity == core::Severity::warning &&
           faulty.contains({entry.problem.subject.kind, entry.problem.subject.index});
  });
  std::ranges::stable_sort(entries_, {},
                           [](const Entry& entry) { return std::tuple(entry.problem.severity, entry.rank); });
  core::Problems problems;
  problems.reserve(entries_.size());
  for (Entry& entry : entries_) problems.push_back(std::move(entry.problem));
  return problems;
}

bool check_function(Findings& findings, const FunctionRule& rule, std::span<const core::SampledFunction> parts) {
  bool all_sound = true;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    bool sound = check_points_are_numbers(findings, rule, part, parts[part]) &&
                 check_points_are_computable(findings, rule, part, parts[part]);
    if (rule.used) {
      sound = check_not_empty(findings, rule, part, parts[part]) && sound;
      if (rule.x_matters) sound = check_points_ascend(findings, rule, part, parts[part]) && sound;
      if (rule.x_matters && sound) check_points_are_even(findings, rule, part, parts[part]);
    }
    all_sound = sound && all_sound;
  }
  return all_sound;
}

}  // namespace sarsim::scene
