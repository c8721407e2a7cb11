// Any bytes as TOML: no crash, and what the parser hands out stays inside of the text and can be read again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/toml/lines.hpp"
#include "core/toml/parse.hpp"
#include "core/toml/values.hpp"

namespace {

using namespace sarsim::core::toml;

void expect_inside(std::string_view text, Span span) {
  if (span.begin > span.end || span.end > text.size()) std::abort();
}

void walk(std::string_view text, const Value& value) {
  expect_inside(text, value.span);
  static_cast<void>(decoded_string(text, value));
  static_cast<void>(number(text, value));
  static_cast<void>(integer(text, value));
  static_cast<void>(boolean(text, value));
  static_cast<void>(date_time(text, value));
  Elements elements(text, value);
  while (const auto element = elements.next()) walk(text, element->value);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Document document = parse(text);
  Lines lines(text);
  for (const Mistake& mistake : document.mistakes) {
    expect_inside(text, mistake.at);
    if (mistake.message.empty() || lines.at(mistake.at.begin).line == 0) std::abort();
  }
  for (const Table& table : document.tables) {
    expect_inside(text, table.header);
    if (table.header.end > table.header.begin &&
        comments_begin(text, document, table.header.begin) > table.header.begin)
      std::abort();
  }
  for (const Entry& entry : document.entries) {
    expect_inside(text, entry.key);
    static_cast<void>(key_parts(text, entry.key));
    walk(text, entry.value);
  }
  return 0;
}
