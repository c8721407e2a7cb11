#include "workflow/record/part_choice.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::workflow {

std::optional<PartChoice::Share> share_from(const std::string& text) {
  constexpr std::int64_t max_parts = 1'000'000;
  const std::size_t slash = text.find('/');
  const auto number = core::parse_integer(text.substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : core::parse_integer(text.substr(slash + 1));
  if (!number || !count || *number < 1 || *number > *count || *count > max_parts) return std::nullopt;
  return PartChoice::Share{*number, *count};
}

std::optional<PartChoice::Span> span_from(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return std::nullopt;
  PartChoice::Span span;
  const std::string begin = text.substr(0, colon);
  const std::string end = text.substr(colon + 1);
  const auto first = begin.empty() ? std::optional<std::int64_t>(1) : core::parse_integer(begin);
  if (!end.empty()) span.last = core::parse_integer(end);
  if (!first || *first < 1 || (!end.empty() && (!span.last || *span.last < *first))) return std::nullopt;
  span.first = *first;
  return span;
}

raster::RowRange rows_of(const PartChoice& choice, std::size_t rows, std::size_t piece_rows) {
  if (choice.share) {
    const auto number = static_cast<std::size_t>(choice.share->number);
    const auto count = static_cast<std::size_t>(choice.share->count);
    const std::size_t pieces = (rows + piece_rows - 1) / piece_rows;
    const std::size_t grain = pieces >= count ? piece_rows : 1;
    const std::size_t grains = grain == 1 ? rows : pieces;
    // The first `grains % count` shares have one more.
    const auto begin = [&](std::size_t part) {
      return std::min(rows, grain * (part * (grains / count) + std::min(part, grains % count)));
    };
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

}  // namespace sarsim::workflow
