#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/object.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/field_spec.hpp"

namespace sarsim::scene {

/// How much the writer of format 2 says.
enum class Saying {
  differences,  ///< What is not at its default.
  everything,   ///< Also what is, as comment lines.
};

/// A scene in format 2. Reading it gives the same scene, bit for bit, but for what its choices make meaningless and
/// control characters in names. Single values have units, lists of coordinates none. Targets that differ in their
/// position alone are one table with `positions`.
[[nodiscard]] std::string write_format_2(const Scene& scene, Saying saying = Saying::differences);

/// What the writer says of one key, for those who change single values of a text.
struct Said {
  std::string key;               ///< One part: "pulse".
  std::string text = {};         ///< The value in one line; empty for a table that has no shorter form.
  std::vector<Said> below = {};  ///< Of a table: its keys, also where `text` is its shorter form.
  bool is_default = false;
};

/// A field that is said even where it is at its default.
struct FieldText {
  const FieldSpec* field = nullptr;  ///< Of the object's table.
  std::size_t part = 0;              ///< Of a vector: 0 to 2.
  std::string text = {};             ///< Of its number, with the quotes; empty: as the writer says it.
};

/// What the writer says of an object, of options or of the atmosphere that is not at its default, in its order.
/// @param also  further fields to say, and with which words
[[nodiscard]] std::vector<Said> said_of(const AnyObject& object, std::span<const FieldText> also = {});
[[nodiscard]] std::vector<Said> said_of(const RunOptions& options, std::span<const FieldText> also = {});
[[nodiscard]] std::vector<Said> said_of(const Atmosphere& atmosphere, std::span<const FieldText> also = {});
[[nodiscard]] std::vector<Said> said_of(const World& world, std::span<const FieldText> also = {});

/// What the writer says of one field.
/// @param words  for the field or parts of it
[[nodiscard]] std::string field_value_text(const FieldSpec& field, const FieldValue& value,
                                           std::span<const FieldText> words);

/// The value of a key in one line, a table as an inline one.
[[nodiscard]] std::string inline_text(const Said& said);

/// The line of a key or, for a table that is too long for one, the lines of its header and of all below it.
/// @param header  the path of the table that it stands in: "radar.antenna"
[[nodiscard]] std::string lines_of(const Said& said, const std::string& header);

/// The tables of all objects of a kind, each with an empty line above it.
[[nodiscard]] std::string write_objects(const Scene& scene, ObjectKind kind);

}  // namespace sarsim::scene
