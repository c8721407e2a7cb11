#include "raster/format/text_rows.hpp"

#include <fmt/format.h>

namespace sarsim::raster {

namespace {

constexpr std::size_t shown_bytes = 40;

std::string printable(const std::string& text) {
  std::string result;
  for (const char c : text.substr(0, shown_bytes)) {
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code >= 0x7F ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  return text.size() > shown_bytes ? result + "..." : result;
}

}  // namespace

core::Problem malformed_text(std::size_t line, std::size_t column, const std::string& token, int next,
                             const char* expected) {
  core::Problem problem;
  problem.place.line = line;
  problem.place.column = column;
  problem.expected = expected;
  if (!token.empty()) {
    problem.message = "text that is not a sample";
    problem.found = printable(token);
  } else if (next == TextScanner::end) {
    problem.message = "the file ends within a sample";
    problem.hint = "the file may be cut off";
  } else {
    problem.message = "a sample is incomplete";
    problem.found = next == '\n' ? "the end of the line" : printable(std::string(1, static_cast<char>(next)));
  }
  return problem;
}

}  // namespace sarsim::raster
