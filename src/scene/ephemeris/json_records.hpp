#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "scene/ephemeris/file_problems.hpp"

namespace sarsim::scene::ephemeris {

/// One member of an object of JSON.
struct JsonMember {
  std::string key;
  std::string value;  ///< Of a string its characters, of a number its text; empty for null, true, false and what nests.
  std::string_view at;  ///< Where the value stands.
};

/// What comes next in a list of flat objects.
enum class JsonEvent {
  open,    ///< An object begins.
  member,  ///< A member of it.
  close,   ///< It ends.
  end,     ///< The text is over, or has a mistake that was reported.
};

/// Takes apart a text of JSON (RFC 8259) that is one object or an array of objects. Values that nest are passed over.
class JsonRecords {
 public:
  /// Keeps views of the text and the log.
  JsonRecords(std::string_view text, FileProblems& problems);

  /// Goes on to the next event.
  [[nodiscard]] JsonEvent next();
  /// The member just met.
  [[nodiscard]] const JsonMember& member() const { return member_; }
  /// Where the object just opened begins.
  [[nodiscard]] std::string_view at() const { return at_; }

 private:
  enum class Part { begin, objects, members, done };

  JsonEvent fail(const char* message, const char* expected);
  void skip_blanks();
  [[nodiscard]] bool take(char c);
  [[nodiscard]] bool take_string(std::string& value);
  [[nodiscard]] bool take_escape(std::string& value);
  [[nodiscard]] bool take_code(std::uint32_t& code);
  [[nodiscard]] bool take_value();
  [[nodiscard]] bool take_nested();
  [[nodiscard]] JsonEvent open_object();
  [[nodiscard]] JsonEvent next_object();
  [[nodiscard]] JsonEvent next_member();

  std::string_view rest_;
  FileProblems& problems_;
  JsonMember member_;
  std::string_view at_;
  Part part_ = Part::begin;
  bool in_array_ = false;
  bool first_ = true;  // of the array or object
};

}  // namespace sarsim::scene::ephemeris
