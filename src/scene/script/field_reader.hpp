#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/maths/vector.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/grammar.hpp"
#include "scene/script/data_file.hpp"
#include "scene/script/field_places.hpp"
#include "scene/script/order.hpp"
#include "scene/script/problem_log.hpp"
#include "scene/script/tokens.hpp"

namespace sarsim::scene::script {

/// What all objects of one reading share.
struct Reading {
  Tokens tokens;
  ProblemLog log;
  FieldPlaces places;
  std::string_view file;
  const DataFileLoader& loader;
};

/// Reads the parameters of one command, one call for each, in their order.
///
/// Each call reports what is wrong with its parameter and leaves its output as it is where nothing usable was found.
/// After a mistake that says where the next parameter stands (a bad number), reading goes on; after one that does not
/// (an unknown keyword, an early end), all further calls do nothing. A keyword in the place of a number means that
/// numbers are missing: the calls up to the next selection do nothing.
class FieldReader {
 public:
  /// @param command  the token of the command, already taken
  /// @param kind     `Subject::kind` of the object
  /// @param index    its position in the scene's list
  FieldReader(Reading& reading, const Token& command, std::string_view kind, std::size_t index);

  /// Notes where the object itself stands.
  void note_object();
  /// The name an object begins with; false where there is none, and then the object cannot be kept.
  bool leading_name(const Field& field, std::string& name);
  /// The fields of an object in their order, those that mean something with what has been read before them.
  template <class Object>
  void read(const Order<Object>& order, Object& object) {
    const FieldTable<Object>& table = table_of<Object>();
    for (const FieldOf<Object>* const field : order)
      if (table.applies(object, *field)) read(*field, object);
  }

  /// One field of an object.
  template <class Object>
  void read(const FieldOf<Object>& field, Object& object) {
    if (field.spec.type == FieldType::function) {
      const FunctionRef function = field.function(object);
      return read_block(field.in_script, *field.spec.block, function.parts, *function.file);
    }
    if (field.number != nullptr && field.spec.quantity != Quantity::count) {
      double value = field.number(object);
      number(parameter(field, object), value);
      return field.set_number(object, value);
    }
    if (field.vector != nullptr) {
      core::Vec3 value = field.vector(object);
      vector(parameter(field, object), value);
      return field.set_vector(object, value);
    }
    FieldValue value = field.get(object);
    read_value(field.spec, parameter(field, object), value);
    field.put(object, value);
  }

  /// A keyword: the position of the one that it is; their number where it is none of them.
  [[nodiscard]] std::size_t keyword(const Field& field, std::span<const std::string_view> words);

  /// Reports a mistake at the next token and reads nothing further of this object.
  void structural_error(const Field& field, Complaint complaint);
  /// Reports a mistake at the next token, passes over `count` values and goes on behind them.
  void pass_over(const Field& field, std::size_t count, Complaint complaint);
  void warning(const Token& token, const Field& field, Complaint complaint) {
    reporter_.warning(token, field.member, std::move(complaint));
  }

  /// Whether a mistake has left unclear where the next parameter stands.
  [[nodiscard]] bool broken() const { return failed_; }
  /// Whether another value follows and reading has not broken off.
  [[nodiscard]] bool more() const { return !failed_ && reading_.tokens.peek().is_value(); }
  [[nodiscard]] const Token& peek() const { return reading_.tokens.peek(); }
  /// For looking further ahead than one token.
  [[nodiscard]] Tokens tokens() const { return reading_.tokens; }

  /// Ends the object: warns of values that were not asked for and goes on to the next command.
  void finish();

 private:
  [[nodiscard]] bool skipping() const { return failed_ || numbers_missing_; }
  bool value_follows(const Field& field, std::string_view kind);
  bool number_follows(const Field& field, std::string_view kind);
  // The common case: a number about which nothing is to be said; false, and nothing is done, for all others.
  bool plain_number_in(const Field& field, double& value);
  void number_in(const Field& field, double& value);
  Token take(const Field& field);
  void note_place(const Field& field, const Token& token);
  void read_value(const FieldSpec& spec, const Field& field, FieldValue& value);
  void text(const Field& field, std::string& text);
  void number(const Field& field, double& value);
  void integer(const Field& field, double& value);
  void seed(const Field& field, std::uint64_t& value);
  void vector(const Field& field, core::Vec3& value);
  void choice(const FieldSpec& spec, const Field& field, FieldValue& value);
  void read_block(const Field& field, const FunctionBlock& block, std::span<core::SampledFunction> parts,
                  std::string& file);
  void read_inline(const Field& field, const FunctionBlock& block, std::span<core::SampledFunction> parts);
  void read_file(const Field& field, const FunctionBlock& block, std::span<core::SampledFunction> parts,
                 std::string& file);

  Reading& reading_;
  Reporter reporter_;
  Token command_;
  bool failed_ = false;
  bool numbers_missing_ = false;
};

}  // namespace sarsim::scene::script
