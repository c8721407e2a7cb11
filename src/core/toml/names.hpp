#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/toml/document.hpp"

namespace sarsim::core::toml {

/// What put a name into a table.
enum class Made : std::uint8_t {
  by_path,      ///< A header of a table below it.
  by_header,    ///< `[name]`, or an inline table while it is read.
  by_dots,      ///< A part of a dotted key, not the last.
  as_elements,  ///< `[[name]]`.
  as_value,     ///< `name = ...`.
};

/// A name that stands in the way of another one.
struct Clash {
  Span part;                  ///< The part of the new key or header.
  bool last = false;          ///< Whether it is the last part.
  Made made = Made::by_path;  ///< How the name came in before.
  std::uint32_t first = 0;    ///< Where that stands, as an offset.
};

/// The names of a text with what TOML allows to do with them later. They are looked up in one hash table by the table
/// that they stand in and their decoded bytes: each part of a key costs the same however many there are. The names
/// inside of an element of an array of tables are dropped with the next one, those of an inline table at its end.
class Names {
 public:
  /// A table of the tree.
  using Node = std::uint32_t;
  /// The parts of a dotted key, as typed.
  using Parts = std::vector<Span>;
  static constexpr Node root = 0;

  /// Holds nothing; the text, which keys refer to, must outlive it.
  explicit Names(std::string_view text);

  /// `[parts]`, or `[[parts]]` with `element`. `table` becomes the table of the entries that follow; after a clash it
  /// is left alone.
  std::optional<Clash> add_header(const Parts& parts, bool element, Node& table);
  /// `parts = ...` in a table.
  std::optional<Clash> add_key(Node table, const Parts& parts);

  /// A new table without a name; `drop` ends it.
  Node begin_nameless();
  /// Ends a table: its names may be given again.
  void drop(Node table);

 private:
  struct Name {
    Span key;
    Node parent = 0;
    std::uint32_t hash = 0;
    Node next = 0;  // of the same bucket; 0 for none, as for the following ones: the root is nowhere inside
    Node first_child = 0;
    Node sibling = 0;  // also the next one in the list of free names
    Made made = Made::by_path;
  };

  std::pair<Node, bool> find_or_add(Node parent, Span part, Made made);
  Node new_name(const Name& name);
  void release(Node node);
  void unlink(Node node);
  void drop_children(Node table);
  void double_buckets();

  std::string_view text_;
  std::vector<Name> names_;
  std::vector<Node> buckets_;
  std::vector<Node> to_drop_;
  std::size_t linked_ = 0;
  Node free_ = 0;
  std::string decoded_;
};

}  // namespace sarsim::core::toml
