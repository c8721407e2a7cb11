#include "scene/language/json_text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/text/utf8.hpp"
#include "core/toml/parse.hpp"
#include "core/toml/values.hpp"

namespace sarsim::scene::language {

namespace toml = core::toml;

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::optional<unsigned> hex_digits(std::string_view text, std::size_t at) {
  unsigned value = 0;
  if (at + 4 > text.size()) return std::nullopt;
  const char* const begin = text.data() + at;
  const auto [end, failure] = std::from_chars(begin, begin + 4, value, 16);
  if (failure != std::errc() || end != begin + 4) return std::nullopt;
  return value;
}

// Writes JSON as TOML, byte for byte.
class Writer {
 public:
  explicit Writer(std::string_view json) : json_(json) { toml_.reserve(json.size()); }

  std::string write() {
    if (json_.starts_with(byte_order_mark)) toml_ = std::string(byte_order_mark.size(), ' ');
    while (toml_.size() < json_.size())
      if (json_[toml_.size()] == '"')
        write_string();
      else
        toml_ += letter(json_[toml_.size()]);
    return std::move(toml_);
  }

  [[nodiscard]] const std::vector<toml::Mistake>& mistakes() const { return mistakes_; }

 private:
  // A letter outside of strings.
  char letter(char c) {
    switch (c) {
      case '{': return depth_++ == 0 ? ' ' : c;
      case '[': ++depth_; return c;
      case '}':
      case ']': return close(c);
      case ',': return depth_ == 1 ? '\n' : c;
      case ':': return '=';
      case '\n':
      case '\r': return ' ';
      case '=': tell("'=' in a JSON text", "':'"); return ' ';
      case '#': tell("JSON has no comments", "a value, a comma or a bracket"); return ' ';
      default:
        if (depth_ == 0 && c != ' ' && c != '\t') {
          tell("unexpected text after the outermost object", "nothing");
          return ' ';
        }
        return c;
    }
  }

  char close(char c) {
    if (depth_ > 0) --depth_;
    return depth_ == 0 && c == '}' ? ' ' : c;
  }

  void tell(std::string message, std::string expected) {
    if (!mistakes_.empty()) return;
    const auto at = static_cast<std::uint32_t>(toml_.size());
    mistakes_.push_back({{at, at + 1}, std::move(message), std::string(1, json_[at]), std::move(expected), ""});
  }

  // What TOML writes in fewer bytes is filled up with blanks behind the closing quote.
  void write_string() {
    const std::size_t begin = toml_.size();
    std::size_t at = begin + 1;
    std::string text = "\"";
    while (at < json_.size() && json_[at] != '"' && json_[at] != '\n') at += write_letter(at, text);
    if (at < json_.size() && json_[at] == '"') {
      text += '"';
      ++at;
    }
    toml_ += text;
    toml_.resize(at, ' ');
  }

  // @returns how many bytes of the JSON text were taken
  std::size_t write_letter(std::size_t at, std::string& text) const {
    if (json_[at] != '\\' || at + 1 == json_.size()) {
      text += json_[at];
      return 1;
    }
    if (json_[at + 1] == '/') {
      text += '/';
      return 2;
    }
    const auto high = json_[at + 1] == 'u' ? hex_digits(json_, at + 2) : std::nullopt;
    const bool is_pair = high && (*high & 0xFC00U) == 0xD800U && json_.substr(at + 6, 2) == "\\u";
    const auto low = is_pair ? hex_digits(json_, at + 8) : std::nullopt;
    if (low && (*low & 0xFC00U) == 0xDC00U) {
      core::append_utf8(text, 0x10000U + ((*high & 0x3FFU) << 10U) + (*low & 0x3FFU));
      return 12;
    }
    text += json_.substr(at, 2);
    return 2;
  }

  std::string_view json_;
  std::string toml_;
  std::size_t depth_ = 0;
  std::vector<toml::Mistake> mistakes_;
};

// Gives each object of the outermost one a table of its own, as a header would.
class Tables {
 public:
  Tables(std::string_view text, const toml::Document& flat) : text_(text), flat_(flat) {}

  toml::Document build() {
    document_.mistakes = flat_.mistakes;
    const toml::Table& root = flat_.tables.front();
    document_.tables.push_back(root);
    for (const toml::Entry& entry : flat_.entries)
      if (!is_table(entry)) document_.entries.push_back(entry);
    document_.tables.front().first_entry = 0;
    document_.tables.front().entries = static_cast<std::uint32_t>(document_.entries.size());
    for (const toml::Entry& entry : flat_.entries)
      if (is_table(entry)) add_tables(entry);
    return std::move(document_);
  }

 private:
  [[nodiscard]] bool is_table(const toml::Entry& entry) const {
    if (entry.value.kind == toml::Kind::table) return true;
    if (entry.value.kind != toml::Kind::array) return false;
    toml::Elements elements(text_, entry.value);
    const auto first = elements.next();
    return first && first->value.kind == toml::Kind::table;
  }

  void add_tables(const toml::Entry& entry) {
    if (entry.value.kind == toml::Kind::table) return add(entry, entry.value, false);
    toml::Elements elements(text_, entry.value);
    while (const auto element = elements.next())
      if (element->value.kind == toml::Kind::table)
        add(entry, element->value, true);
      else
        document_.mistakes.push_back({element->value.span, "an object is expected here", "", "{ ... }", ""});
  }

  void add(const toml::Entry& entry, const toml::Value& value, bool element) {
    toml::Table table;
    table.header = element ? toml::Span{value.span.begin, value.span.begin + 1} : entry.key;
    table.name = entry.key;
    table.element = element;
    table.first_entry = static_cast<std::uint32_t>(document_.entries.size());
    toml::Elements members(text_, value);
    while (const auto member = members.next()) document_.entries.push_back({member->key, member->value});
    table.entries = static_cast<std::uint32_t>(document_.entries.size()) - table.first_entry;
    document_.tables.push_back(table);
  }

  std::string_view text_;
  const toml::Document& flat_;
  toml::Document document_;
};

}  // namespace

bool is_json(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{';
}

JsonText read_json(std::string_view text) {
  Writer writer(text);
  JsonText json{writer.write(), {}};
  toml::Document flat = toml::parse(json.toml);
  for (toml::Mistake& mistake : flat.mistakes)
    if (mistake.hint.find(" line ") != std::string::npos) mistake.hint.clear();  // It counts the lines of TOML.
  flat.mistakes.insert(flat.mistakes.begin(), writer.mistakes().begin(), writer.mistakes().end());
  json.document = Tables(json.toml, flat).build();
  std::ranges::stable_sort(json.document.mistakes, {}, [](const toml::Mistake& m) { return m.at.begin; });
  return json;
}

}  // namespace sarsim::scene::language
