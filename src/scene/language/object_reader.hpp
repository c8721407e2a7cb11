#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/toml/lines.hpp"
#include "core/toml/values.hpp"
#include "scene/language/earth_places.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/object_text.hpp"
#include "scene/language/plain_table.hpp"
#include "scene/schema/expression.hpp"
#include "scene/schema/field_table.hpp"
#include "scene/schema/trade_words.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/field_places.hpp"
#include "scene/script/problem_log.hpp"

namespace sarsim::scene::language {

/// One text that is being read, the scene's own or one that it includes.
struct Source {
  std::string file;       ///< For the places of problems.
  std::string_view text;  ///< Outlives the reading.
  core::toml::Document document;
  std::string name;        ///< As files beside the scene's own are named; empty: the scene's own text.
  std::string_view typed;  ///< As it stands in the file, of the same length: another text where that is JSON.
};

/// What all objects of one reading share.
struct Reading {
  script::ProblemLog log;
  FieldPlaces places;
  const DataFileLoader& loader;
  LetNames names;
  bool names_lost = false;                ///< A platform or radar could not be read: who refers to it is not to blame.
  std::optional<EarthPlaces> earth = {};  ///< Turns geodetic places into world positions; nothing over a flat world.
};

/// Reads the values of one object and reports what is wrong with them, each at its place.
class ObjectReader {
 public:
  /// @param kind   `Subject::kind` of the object
  /// @param index  its position in the scene's list
  ObjectReader(Reading& reading, const Source& source, core::toml::Lines& lines, ObjectText& text,
               std::string_view kind, std::size_t index);

  /// Reads all that the text says of an object; what it does not say stays as it is.
  template <class Object>
  void read(Object& object) {
    const FieldTable<Object>& table = table_of<Object>();
    for (const FieldOf<Object>& field : table.fields()) {
      if (!table.applies(object, field)) continue;
      const std::string_view key = key_of(table, field, object);
      if (field.function != nullptr) {
        read_function(field.spec, key, field.function(object));
      } else if (field.list != nullptr) {
        if (Leaf* const leaf = find(key))
          visit_elements(field.spec.list, field.list(object), [&](auto& list) { read_list(field.spec, *leaf, list); });
      } else if (field.number != nullptr && field.spec.quantity != Quantity::count && !key.ends_with(']')) {
        if (Leaf* const leaf = find(key)) {
          double value = field.number(object);
          read_number(field.spec, *leaf, value);
          field.set_number(object, value);
        }
      } else if (says_anything_of(key)) {
        FieldValue value = field.get(object);
        const bool is_choice = field.spec.type == FieldType::choice;
        if (read_value(field.spec, key, is_choice ? shorthand(table, field) : nullptr, value)) field.put(object, value);
      }
    }
  }

  /// The value of a path, which then counts as used; null where there is none.
  [[nodiscard]] Leaf* find(std::string_view path);
  /// A number with the unit of a field, or an expression; false where it is none, which is then reported.
  bool read_number(const FieldSpec& spec, const Leaf& leaf, double& number);
  /// Three of them.
  bool read_vector(const FieldSpec& spec, const core::toml::Value& value, core::Vec3& vector);

  /// Reports what nobody has asked for, and where it belongs.
  void finish(ObjectKind kind);
  /// The same of a table that is no object.
  void finish(const std::vector<std::string>& known);

  /// Reports what is wrong, or odd, with a piece of the text.
  /// @param field  of the object; empty for all of it
  /// @{
  void error(core::toml::Span at, std::string_view field, script::Complaint complaint);
  void warning(core::toml::Span at, std::string_view field, script::Complaint complaint);
  /// @}
  [[nodiscard]] std::string_view text_of(core::toml::Span span) const { return core::toml::piece(source_.text, span); }
  /// What a string means; empty for other values.
  [[nodiscard]] std::string string_of(const core::toml::Value& value) const {
    return core::toml::decoded_string(source_.text, value);
  }
  /// The first place on the Earth that was read, which is a world position; empty: none.
  [[nodiscard]] core::toml::Span geodetic_at() const { return geodetic_at_; }
  /// Notes where a field stands.
  void note_place(std::string_view field, core::toml::Span at);

 private:
  [[nodiscard]] bool says_anything_of(std::string_view key) const;

  bool read_value(const FieldSpec& spec, std::string_view key, const FieldSpec* shorthand, FieldValue& value);
  bool read_choice(const FieldSpec& spec, std::string_view key, const FieldSpec* shorthand, FieldValue& value);
  bool read_listed(const FieldSpec& spec, std::string_view key, FieldValue& value);
  bool read_flags(const FieldSpec& spec, const Leaf& leaf, FieldValue& value);
  bool read_seed(const FieldSpec& spec, const Leaf& leaf, FieldValue& value);
  bool read_text(const FieldSpec& spec, const Leaf& leaf, FieldValue& value);
  bool choose_word(const FieldSpec& spec, const Leaf& leaf, FieldValue& value);
  bool number_in(const FieldSpec& spec, const core::toml::Value& value, double& number);
  bool expression_in(const FieldSpec& spec, const core::toml::Value& value, double& number);
  bool check_number(const FieldSpec& spec, core::toml::Span at, double number, bool bare);
  bool read_place(const FieldSpec& spec, const core::toml::Value& value, core::Vec3& vector);
  void read_function(const FieldSpec& spec, std::string_view key, const FunctionRef& function);
  template <class Element>
  void read_list(const FieldSpec& spec, const Leaf& leaf, std::vector<Element>& list);
  template <class Element>
  void report_lacks(const Element& element, core::toml::Span at);
  void read_part(const FieldSpec& spec, const std::string& key, std::size_t part, core::SampledFunction& function);
  void read_points(const FieldSpec& spec, const Leaf& leaf, std::size_t part, core::SampledFunction& function);
  void read_function_file(const FieldSpec& spec, const Leaf& leaf, const FunctionRef& function);
  [[nodiscard]] std::string remedy(const Leaf& leaf, const std::vector<std::string>& known) const;
  [[nodiscard]] std::string value_text(const core::toml::Value& value) const;
  [[nodiscard]] std::string trade_remedy(const Leaf& leaf, std::string_view last) const;
  [[nodiscard]] std::string advice_on(const TradeWord& word, const Leaf& leaf, std::string_view last) const;
  [[nodiscard]] std::optional<double> carrier_hz() const;
  void report_unknown(const Leaf& leaf, const std::string& belongs, const std::vector<std::string>& known);
  void add(core::Severity severity, core::toml::Span at, std::string_view field, script::Complaint complaint);

  // Of a table within that object: an entry of a list, or a place on the Earth.
  // @param entries  fields of the entries; null where it is none
  ObjectReader(const ObjectReader& outer, ObjectText& text, std::string_view field, const PlainTable* entries)
      : reading_(outer.reading_),
        source_(outer.source_),
        lines_(outer.lines_),
        text_(text),
        kind_(outer.kind_),
        index_(outer.index_),
        list_field_(field),
        entries_(entries),
        entry_(entries != nullptr ? text.kind : outer.entry_) {}

  Reading& reading_;
  const Source& source_;
  core::toml::Lines& lines_;
  ObjectText& text_;
  std::string_view kind_;
  std::size_t index_;
  core::toml::Span geodetic_at_{};
  std::string_view list_field_;  // of the object, which this is an element or a part of: where problems are shown
  const PlainTable* entries_ = nullptr;  // of an element of a list
  std::string_view entry_;               // that element, or the one around: "leg 2"
};

/// What a value is, for messages: "a string", "an array".
[[nodiscard]] std::string_view noun_of(core::toml::Kind kind);

}  // namespace sarsim::scene::language
