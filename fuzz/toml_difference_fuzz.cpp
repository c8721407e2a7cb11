// Any bytes as TOML, read by our parser and by toml++: both accept a text or both refuse it, and what they read is the
// same. Where they may differ is listed at `may_differ`.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Where toml++ finds a mistake of its own, nothing can be compared.
struct FaultOfToml {};
#define TOML_EXCEPTIONS 0
#define TOML_ASSERT(condition)          \
  if (!(condition)) throw FaultOfToml { \
    }
#include <toml++/toml.h>

#include "core/toml/parse.hpp"
#include "core/toml/values.hpp"

namespace {

namespace ours = sarsim::core::toml;

// A value with all that it holds. Two of one meaning have one `text`.
struct Node {
  std::string text;  // Of a scalar, with the letter of its kind first.
  std::map<std::string, Node> members;
  std::vector<Node> elements;
  bool is_table = true;
  bool is_array = false;
};

std::string length_and(std::string_view bytes) { return std::to_string(bytes.size()) + ":" + std::string(bytes); }

void write(const Node& node, std::string& out) {
  if (node.is_array) {
    out += "[";
    for (const Node& element : node.elements) write(element, out);
    out += "]";
  } else if (node.is_table) {
    out += "{";
    for (const auto& [key, member] : node.members) {
      out += length_and(key);
      write(member, out);
    }
    out += "}";
  } else {
    out += node.text;
  }
}

Node scalar(std::string text) { return {std::move(text), {}, {}, false, false}; }

std::string number_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "f%a", value);
  return value != value ? "fnan" : text;
}

std::string date_text(char kind, int year, int month, int day, int hour, int minute, int second, int nanosecond,
                      int offset) {
  char text[120];
  std::snprintf(text, sizeof text, "%c%d-%d-%dT%d:%d:%d.%d+%d", kind, year, month, day, hour, minute, second,
                nanosecond, offset);
  return text;
}

// Reads what our parser found valid.
class Ours {
 public:
  explicit Ours(std::string_view text) : text_(text) {}

  // Where toml++ 3.3 refuses what TOML 1.0 allows: numbers beyond 64 bits, beyond all doubles or longer than 126
  // characters, seconds with more than 64 decimals, leap seconds, the year 0.
  bool may_differ = false;

  Node tree(const ours::Document& document) {
    Node root;
    for (const ours::Table& table : document.tables) {
      Node* at = &root;
      if (&table != &document.tables.front()) {
        const std::vector<std::string> parts = ours::key_parts(text_, table.name);
        at = below(root, parts, table.element);
      }
      for (std::size_t i = 0; i < table.entries; ++i) add(*at, document.entries[table.first_entry + i]);
    }
    return root;
  }

 private:
  static Node& last_of(Node& node) { return node.is_array ? node.elements.back() : node; }

  static Node* below(Node& root, const std::vector<std::string>& parts, bool element) {
    Node* at = &root;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Node& member = at->members[parts[i]];
      if (i + 1 == parts.size() && element) {
        member.is_array = true;
        member.is_table = false;
        at = &member.elements.emplace_back();
      } else {
        at = &last_of(member);
      }
    }
    return at;
  }

  template <class Keyed>
  void add(Node& table, const Keyed& entry) {
    Node* at = &table;
    for (const std::string& part : ours::key_parts(text_, entry.key)) at = &at->members[part];
    *at = node_of(entry.value);
  }

  Node node_of(const ours::Value& value) {
    const bool is_number = value.kind == ours::Kind::integer || value.kind == ours::Kind::floating;
    may_differ = may_differ || (is_number && value.span.end - value.span.begin > longest_number);
    switch (value.kind) {
      case ours::Kind::string: return scalar("s" + length_and(ours::decoded_string(text_, value)));
      case ours::Kind::boolean: return scalar(ours::boolean(text_, value).value() ? "true" : "false");
      case ours::Kind::integer: {
        const auto integer = ours::integer(text_, value);
        may_differ = may_differ || !integer;
        return scalar("i" + std::to_string(integer.value_or(0)));
      }
      case ours::Kind::floating: {
        const double number = ours::number(text_, value).value();
        const bool said = ours::piece(text_, value.span).find("inf") != std::string_view::npos;
        may_differ = may_differ || (number - number != 0.0 && number == number && !said);
        return scalar(number_text(number));
      }
      case ours::Kind::array: {
        Node node;
        node.is_array = true;
        node.is_table = false;
        ours::Elements elements(text_, value);
        while (const auto element = elements.next()) node.elements.push_back(node_of(element->value));
        return node;
      }
      case ours::Kind::table: {
        Node node;
        ours::Elements elements(text_, value);
        while (const auto element = elements.next()) add(node, *element);
        return node;
      }
      default: return date_of(value);
    }
  }

  Node date_of(const ours::Value& value) {
    const ours::DateTime date = ours::date_time(text_, value).value();
    const bool has_date = value.kind != ours::Kind::local_time;
    const bool is_long = value.span.end - value.span.begin > longest_date;
    may_differ = may_differ || is_long || date.second == 60 || (has_date && date.year == 0);
    const char kind = value.kind == ours::Kind::offset_date_time  ? 'o'
                      : value.kind == ours::Kind::local_date_time ? 'l'
                      : value.kind == ours::Kind::local_date      ? 'd'
                                                                  : 't';
    return scalar(date_text(kind, date.year, date.month, date.day, date.hour, date.minute, date.second, date.nanosecond,
                            date.offset_minutes));
  }

  static constexpr std::size_t longest_number = 126;
  static constexpr std::size_t longest_date = 60;

  std::string_view text_;
};

Node node_of(const toml::node& value) {
  if (const auto* table = value.as_table()) {
    Node node;
    for (const auto& [key, member] : *table) node.members[std::string(key.str())] = node_of(member);
    return node;
  }
  if (const auto* array = value.as_array()) {
    Node node;
    node.is_array = true;
    node.is_table = false;
    for (const toml::node& element : *array) node.elements.push_back(node_of(element));
    return node;
  }
  if (const auto* text = value.as_string()) return scalar("s" + length_and(text->get()));
  if (const auto* flag = value.as_boolean()) return scalar(flag->get() ? "true" : "false");
  if (const auto* integer = value.as_integer()) return scalar("i" + std::to_string(integer->get()));
  if (const auto* number = value.as_floating_point()) return scalar(number_text(number->get()));
  toml::date date{};
  toml::time time{};
  int offset = 0;
  char kind = 't';
  if (const auto* both = value.as_date_time()) {
    date = both->get().date;
    time = both->get().time;
    kind = both->get().offset ? 'o' : 'l';
    if (both->get().offset) offset = both->get().offset->minutes;
  } else if (const auto* day = value.as_date()) {
    date = day->get();
    kind = 'd';
  } else if (const auto* of_day = value.as_time()) {
    time = of_day->get();
  }
  return scalar(date_text(kind, date.year, date.month, date.day, time.hour, time.minute, time.second,
                          static_cast<int>(time.nanosecond), offset));
}

// What we refuse on purpose.
bool is_our_limit(const ours::Document& document) {
  return document.mistakes.front().message.find("nest") != std::string::npos;
}

[[noreturn]] void fail(const char* what, const std::string& a, const std::string& b) {
  std::fprintf(stderr, "%s\n  ours:   %s\n  toml++: %s\n", what, a.c_str(), b.c_str());
  std::abort();
}

void compare(std::string_view text) {
  const ours::Document document = ours::parse(text);
  // Letters beyond ASCII where none may stand lead toml++ 3.3 to places that it holds for unreachable.
  const auto beyond_ascii = [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; };
  if (!document.mistakes.empty() && std::ranges::any_of(text, beyond_ascii)) return;
  const toml::parse_result other = toml::parse(text);
  if (!document.mistakes.empty()) {
    if (other && !is_our_limit(document)) fail("refused by us alone", document.mistakes.front().message, "");
    return;
  }
  Ours reader(text);
  const Node tree = reader.tree(document);
  if (reader.may_differ) return;
  if (!other) fail("refused by toml++ alone", "", std::string(other.error().description()));
  std::string a;
  std::string b;
  write(tree, a);
  write(node_of(other.table()), b);
  if (a != b) fail("read differently", a, b);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    compare({reinterpret_cast<const char*>(data), size});
  } catch (const FaultOfToml&) {
  }
  return 0;
}
