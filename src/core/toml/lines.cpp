#include "core/toml/lines.hpp"

#include <algorithm>

#include "core/toml/scan.hpp"

namespace sarsim::core::toml {

namespace {

// The first byte of the line that ends at, or goes on to, `at`.
std::size_t line_begin(std::string_view text, std::size_t at) {
  const std::size_t feed = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return feed == std::string_view::npos ? 0 : feed + 1;
}

// The end of what stands last before `offset` among items in order of the text; 0 for nothing.
template <class Items, class SpanOf>
std::size_t end_before(const Items& items, std::uint32_t offset, SpanOf span_of_item) {
  const auto behind = std::ranges::lower_bound(items, offset, {}, [&](const auto& i) { return span_of_item(i).begin; });
  return behind == items.begin() ? 0 : span_of_item(*std::prev(behind)).end;
}

}  // namespace

Position Lines::at(std::uint32_t offset) {
  const std::size_t target = std::min<std::size_t>(offset, text_.size());
  if (target < line_begin_) {
    line_ -= static_cast<std::size_t>(std::ranges::count(text_.substr(target, line_begin_ - target), '\n'));
    line_begin_ = line_begin(text_, target);
  } else {
    const std::string_view before = text_.substr(0, target);
    std::size_t feed = before.find('\n', std::max(offset_, line_begin_));
    for (; feed != std::string_view::npos; feed = before.find('\n', line_begin_)) {
      line_begin_ = feed + 1;
      ++line_;
    }
  }
  offset_ = target;
  return {line_, target - line_begin_ + 1};
}

std::uint32_t comments_begin(std::string_view text, const Document& document, std::uint32_t offset) {
  const auto entry_span = [](const Entry& entry) { return Span{entry.key.begin, entry.value.span.end}; };
  const auto header_span = [](const Table& table) { return table.header; };
  const std::size_t top =
      std::max(end_before(document.entries, offset, entry_span), end_before(document.tables, offset, header_span));
  // The root's empty header stands behind a byte order mark.
  const std::size_t first = document.tables.empty() ? 0 : document.tables.front().header.begin;
  std::size_t begin = std::max(line_begin(text, std::min<std::size_t>(offset, text.size())), first);
  while (begin > top) {
    const std::size_t above = std::max(line_begin(text, begin - 1), first);
    if (above < top || byte_at(text, skip(text, above, blank_byte)) != '#') break;
    begin = above;
  }
  return static_cast<std::uint32_t>(begin);
}

}  // namespace sarsim::core::toml
