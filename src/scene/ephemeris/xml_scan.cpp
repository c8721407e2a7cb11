#include "scene/ephemeris/xml_scan.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "core/text/letters.hpp"
#include "core/text/utf8.hpp"
#include "scene/ephemeris/text_lines.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr std::size_t deepest = 64;

std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

// Offset of the '>' that ends a tag, which does not stand in quotes; npos where there is none.
std::size_t end_of_tag(std::string_view text) {
  char quote = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0')
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return i;
    else if (c == '<' && i > 0)
      return std::string_view::npos;
  }
  return std::string_view::npos;
}

}  // namespace

XmlScan::XmlScan(std::string_view text, FileProblems& problems) : rest_(without_mark(text)), problems_(problems) {}

XmlEvent XmlScan::fail(std::string_view at, const char* message, const char* expected, const char* hint) {
  broken_ = true;
  problems_.error(at, {message, core::clipped(at.substr(0, at.find('\n'))), expected, hint});
  return XmlEvent::end;
}

// Passes over what stands between two marks; false, reported, where the second is missing.
bool XmlScan::skip(std::string_view begin, std::string_view end, bool& skipped) {
  if (!rest_.starts_with(begin)) return true;
  const std::size_t found = rest_.find(end, begin.size());
  if (found == std::string_view::npos) {
    static_cast<void>(fail(rest_, "a comment or an instruction is not closed", end.data(), "the file may be cut off"));
    return false;
  }
  rest_.remove_prefix(found + end.size());
  skipped = true;
  return true;
}

bool XmlScan::skip_marks(bool& skipped) {
  skipped = false;
  return skip("<!--", "-->", skipped) && skip("<?", "?>", skipped);
}

XmlEvent XmlScan::finish() {
  if (!open_.empty())
    return fail(open_.back(), "the element is not closed", "its closing tag", "the file may be cut off");
  if (!any_) return fail(rest_, "the file holds no elements", "XML", "");
  complete_ = true;
  return XmlEvent::end;
}

XmlEvent XmlScan::next() {
  if (broken_ || complete_) return XmlEvent::end;
  if (std::exchange(close_done_, false)) open_.pop_back();
  if (std::exchange(close_next_, false)) {
    close_done_ = true;
    return XmlEvent::close;
  }
  while (!rest_.empty()) {
    if (rest_.front() != '<') {
      if (take_text() == XmlEvent::text) return XmlEvent::text;
      if (broken_) return XmlEvent::end;
      continue;
    }
    bool skipped = false;
    if (!skip_marks(skipped)) return XmlEvent::end;
    if (!skipped) return take_tag();
  }
  return finish();
}

// XmlEvent::text, or XmlEvent::end where there are only blanks.
XmlEvent XmlScan::take_text() {
  const std::size_t end = std::min(rest_.find('<'), rest_.size());
  piece_ = core::trimmed(rest_.substr(0, end));
  rest_.remove_prefix(end);
  if (piece_.empty()) return XmlEvent::end;
  if (open_.empty()) return fail(piece_, "text outside all elements", "XML", "");
  name_ = without_prefix(open_.back());
  return XmlEvent::text;
}

XmlEvent XmlScan::take_tag() {
  if (rest_.starts_with("<!"))
    return fail(rest_, "declarations and CDATA are not read", "elements, text and comments",
                "remove them; orbit files have none");
  const std::size_t end = end_of_tag(rest_);
  if (end == std::string_view::npos) return fail(rest_, "the tag is not closed", ">", "the file may be cut off");
  std::string_view inside = rest_.substr(1, end - 1);
  rest_.remove_prefix(end + 1);
  if (inside.starts_with('/')) return close_tag(core::trimmed(inside.substr(1)));
  close_next_ = inside.ends_with('/');
  if (close_next_) inside.remove_suffix(1);
  std::size_t length = 0;
  while (length < inside.size() && !core::is_blank(inside[length])) ++length;
  if (length == 0) return fail(inside, "a tag has no name", "<name>");
  if (open_.size() >= deepest) return fail(inside, "elements are nested too deeply", "at most 64 levels");
  if (open_.empty() && any_) return fail(inside, "a second element after the end of the first", "one element");
  open_.push_back(inside.substr(0, length));
  name_ = without_prefix(open_.back());
  attributes_ = inside.substr(length);
  any_ = true;
  return XmlEvent::open;
}

XmlEvent XmlScan::close_tag(std::string_view raw_name) {
  if (open_.empty() || open_.back() != raw_name)
    return fail(raw_name, "the element that ends here is not the one that was opened last", "tags that match",
                "a closing tag is missing before");
  name_ = without_prefix(raw_name);
  close_done_ = true;
  return XmlEvent::close;
}

std::string_view XmlScan::attribute(std::string_view attribute_name) const {
  std::string_view rest = core::trimmed(attributes_);
  while (!rest.empty()) {
    const std::size_t sign = rest.find('=');
    if (sign == std::string_view::npos) break;
    const std::string_view key = core::trimmed(rest.substr(0, sign));
    rest = core::trimmed(rest.substr(sign + 1));
    if (rest.empty() || (rest.front() != '"' && rest.front() != '\'')) break;
    const std::size_t end = rest.find(rest.front(), 1);
    if (end == std::string_view::npos) break;
    if (key == attribute_name) return rest.substr(1, end - 1);
    rest = core::trimmed(rest.substr(end + 1));
  }
  return {};
}

std::optional<std::string> without_entities(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> named{
      {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t sign = std::min(text.find('&', at), text.size());
    plain += text.substr(at, sign - at);
    if (sign == text.size()) break;
    const std::size_t end = text.find(';', sign);
    if (end == std::string_view::npos || end - sign > 12) return std::nullopt;
    std::string_view entity = text.substr(sign + 1, end - sign - 1);
    at = end + 1;
    if (entity.starts_with('#')) {
      const bool hex = entity.starts_with("#x");
      entity.remove_prefix(hex ? 2 : 1);
      std::uint32_t number = 0;
      const auto [stop, error] = std::from_chars(entity.data(), entity.data() + entity.size(), number, hex ? 16 : 10);
      if (error != std::errc{} || stop != entity.data() + entity.size() || !core::is_character(number))
        return std::nullopt;
      core::append_utf8(plain, number);
      continue;
    }
    bool known = false;
    for (const auto& [name, character] : named)
      if (entity == name) plain += character, known = true;
    if (!known) return std::nullopt;
  }
  return plain;
}

}  // namespace sarsim::scene::ephemeris
