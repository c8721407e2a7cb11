#pragma once

#include <string>
#include <string_view>

#include "core/maths/vector.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/order.hpp"

namespace sarsim::scene::script {

/// Puts the lines of a script together: a value left-justified in 20 columns, a blank, a comment.
class ScriptLines {
 public:
  /// A line that is only text.
  void plain(std::string_view text);
  /// Empty lines.
  void blank(int count = 1);
  /// Whole lines, made elsewhere.
  /// @param expected_bytes  of these and all that follow them: what room is made for, where any has to be made
  void append(std::string_view lines, std::size_t expected_bytes);
  /// A value and its comment; without the comment's mark where it is empty.
  void value(std::string_view text, std::string_view comment);

  /// The fields of an object that mean something for it, in their order.
  template <class Object>
  void fields(const Order<Object>& order, const Object& object) {
    for (const FieldOf<Object>* const field : order)
      if (table_of<Object>().applies(object, *field)) this->field(*field, object);
  }
  /// One field: a value with its unit and meaning, a keyword, or a block of functions.
  template <class Object>
  void field(const FieldOf<Object>& field, const Object& object) {
    write_field(field.spec, parameter(field, object), field.get(object));
  }
  /// Fields by rows: those of one row on one line, with its comment, where they mean something.
  template <class Object>
  void rows(const std::vector<Row<Object>>& rows, const Object& object) {
    for (const Row<Object>& row : rows) {
      if (row.comment.empty()) {
        fields(row.fields, object);
      } else if (table_of<Object>().applies(object, *row.fields.front())) {
        for (const FieldOf<Object>* const field : row.fields)
          add_to_row(field->in_script, field->get(object), field == row.fields.front());
        end_row(row.fields.front()->in_script, row.comment);
      }
    }
  }

  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  void add_to_row(const Field& field, const FieldValue& value, bool first);
  void end_row(const Field& field, std::string_view comment);
  void write_field(const FieldSpec& spec, const Field& field, const FieldValue& value);
  void number(const Field& field, double number);
  void vector(const Field& field, const core::Vec3& vector);
  void write_block(const FunctionBlock& block, const ConstFunctionRef& function);

  std::string text_;
};

/// "(GHz) Carrier frequency: detail", the comment beside a field's value.
[[nodiscard]] std::string comment_of(const Field& field, std::string_view more = {});

}  // namespace sarsim::scene::script
