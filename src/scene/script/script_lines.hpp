#pragma once

#include <string>
#include <string_view>

#include "core/maths/angle.hpp"
#include "core/maths/vector.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/schema/scene_grammar.hpp"
#include "scene/script/data_file.hpp"

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

  /// A name, in quotes where it needs them.
  void name(const Field& field, std::string_view name);
  /// A number from SI units (angles and decibels: as typed) in the unit of the script.
  void number(const Field& field, double value);
  /// A whole number.
  void integer(const Field& field, int value);
  /// Three numbers on a line each, x, y and z.
  void vector(const Field& field, const core::Vec3& value);
  /// Three angles on a line each, in degrees as typed.
  void angles(const Field& field, const std::array<core::Angle, 3>& value);
  /// Some numbers on one line, with a comment.
  void row(std::initializer_list<double> values, std::string_view comment);

  template <class Value, std::size_t N>
  void choice(const Alternatives<Value, N>& alternatives, Value chosen) {
    for (const auto& alternative : alternatives)
      if (alternative.value == chosen) return value(alternative.word, alternative.meaning);
  }

  template <std::size_t N>
  void function(const FunctionBlock& block, const UserFunction<N>& function) {
    write_block(block, function.part, function.file);
  }

  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  void write_block(const FunctionBlock& block, std::span<const core::SampledFunction> parts, std::string_view file);

  std::string text_;
};

/// "(GHz) Carrier frequency: detail", the comment beside a field's value.
[[nodiscard]] std::string comment_of(const Field& field, std::string_view more = {});

}  // namespace sarsim::scene::script
