#include "cli/command/part_options.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/shell/options.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::cli {

namespace {

constexpr std::int64_t most_parts = 1'000'000;

[[noreturn]] void refuse(const char* name, const std::string& text, const char* expected) {
  throw CLI::ValidationError(name, fmt::format("'{}' is not {}", text, expected));
}

PartChoice::Share share_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = core::parse_integer(text.substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : core::parse_integer(text.substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count || *count > most_parts)
    refuse("--part", text, "a part such as 3/8: the third of eight");
  return {*number, *count};
}

PartChoice::Span span_of(const std::string& text) {
  constexpr const char* expected = "a range of pulses such as 101:200, counted from 1";
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) refuse("--pulses", text, expected);
  PartChoice::Span span;
  const std::string begin = text.substr(0, colon);
  const std::string end = text.substr(colon + 1);
  const auto first = begin.empty() ? std::optional<std::int64_t>(1) : core::parse_integer(begin);
  if (!end.empty()) span.last = core::parse_integer(end);
  if (!first || *first < 1 || (!end.empty() && (!span.last || *span.last < *first))) refuse("--pulses", text, expected);
  span.first = *first;
  return span;
}

}  // namespace

void add_part_options(CLI::App& app, PartChoice& choice) {
  auto* part = app.add_option_function<std::string>(
      "--part", [&choice](const std::string& text) { choice.share = share_of(text); },
      "only this share of the pulses of each recording, such as 3/8; all shares together make the file of a single "
      "run");
  part->type_name("K/N");
  auto* pulses = app.add_option_function<std::string>(
      "--pulses", [&choice](const std::string& text) { choice.span = span_of(text); },
      "only these pulses of each recording (bursts of range profiles), counted from 1");
  pulses->type_name("A:B");
  part->excludes(pulses);
  app.add_flag("--part-file", choice.own_file, "keep the share in a file of its own, for sarsim merge");
  app.add_flag("--resume", choice.resume, "keep a journal, and go on where an earlier run of it ended");
  const auto read = [&choice](const std::string& text) {
    choice.save_every_s = core::parse_number(text);
    if (!choice.save_every_s || *choice.save_every_s < 0.0 || *choice.save_every_s > 86400.0)
      refuse("--save-every", text, "a number of seconds from 0 to 86400");
  };
  app.add_option_function<std::string>("--save-every", read, "seconds from one entry of the journal to the next (1)")
      ->type_name("S");
}

simulate::RowRange rows_of(const PartChoice& choice, std::size_t rows) {
  if (choice.share) {
    const auto number = static_cast<std::size_t>(choice.share->number);
    const auto count = static_cast<std::size_t>(choice.share->count);
    // The first `rows % count` shares have one row more.
    const auto begin = [&](std::size_t part) { return part * (rows / count) + std::min(part, rows % count); };
    return {begin(number - 1), begin(number) - begin(number - 1)};
  }
  if (!choice.span) return {0, rows};
  const auto first = static_cast<std::size_t>(choice.span->first - 1);
  const auto end = choice.span->last ? std::min(static_cast<std::size_t>(*choice.span->last), rows) : rows;
  if (first >= end) return {};
  return {first, end - first};
}

std::string words_of(const PartChoice& choice) {
  if (choice.share) return fmt::format("{}/{}", choice.share->number, choice.share->count);
  if (!choice.span) return "1/1";
  return fmt::format("{}:{}", choice.span->first, choice.span->last ? std::to_string(*choice.span->last) : "");
}

std::string file_name_of(const PartChoice& choice) {
  if (choice.share) return fmt::format("part-{}-of-{}", choice.share->number, choice.share->count);
  if (!choice.span) return "all";
  return fmt::format("pulses-{}-{}", choice.span->first,
                     choice.span->last ? std::to_string(*choice.span->last) : std::string("end"));
}

}  // namespace sarsim::cli
