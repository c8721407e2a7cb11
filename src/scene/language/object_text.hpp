#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/toml/document.hpp"
#include "core/toml/lines.hpp"

/// A text of format 2 as a list of objects, each a flat list of what is said of it: however a value was written down
/// (in the object's own table, in one below it, in an inline table, or with a dotted key), it has one path.
namespace sarsim::scene::language {

/// One value of an object.
struct Leaf {
  std::string_view path;  ///< Below the object: "pulse.width". A table has a leaf too, before those of its values.
  core::toml::Span key;   ///< As it stands in the text.
  core::toml::Value value;
  bool is_header = false;  ///< A table with a header of its own; `key` is the header.
  bool used = false;
};

/// Whether a path is that of a table or of something inside of it.
[[nodiscard]] constexpr bool is_below(std::string_view path, std::string_view table) {
  return path.starts_with(table) && (path.size() == table.size() || path[table.size()] == '.');
}

/// What a text says of one object.
struct ObjectText {
  std::string_view kind;    ///< First part of the header: "radar"; empty: what stands before all headers.
  core::toml::Span header;  ///< Or, for an object within an array, its table.
  bool is_element = false;  ///< One of several: `[[radar]]`.
  std::vector<Leaf> leaves;

  /// The leaf of a path; null where there is none.
  [[nodiscard]] Leaf* find(std::string_view path);
  /// Marks a path and everything below it as used.
  void use_all_below(std::string_view path);
};

/// Hands out the objects of a text in its order, one at a time.
class ObjectTexts {
 public:
  /// Text and document must outlive it.
  /// @param first  the table to begin with
  ObjectTexts(std::string_view text, const core::toml::Document& document, std::size_t first = 0)
      : text_(text), document_(document), table_(first) {}

  /// The next object; false behind the last one. What was handed out before is gone then.
  [[nodiscard]] bool next(ObjectText& object);

  /// The values of an inline table, by their paths in it; valid as long as this.
  [[nodiscard]] ObjectText inner(const core::toml::Value& table);

 private:
  void take_entries(const core::toml::Table& table, std::string_view prefix, ObjectText& object);
  void take_value(std::string_view path, core::toml::Span key, const core::toml::Value& value, ObjectText& object);
  [[nodiscard]] std::string_view joined(std::string_view prefix, core::toml::Span key);
  [[nodiscard]] std::string_view kept(std::string path);

  std::string_view text_;
  const core::toml::Document& document_;
  std::size_t table_;
  std::deque<std::string> paths_;  // those that do not stand in the text
};

}  // namespace sarsim::scene::language
