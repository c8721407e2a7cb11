#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/ephemeris/file_problems.hpp"

namespace sarsim::scene::ephemeris {

/// What comes next in a text of XML.
enum class XmlEvent {
  open,   ///< `<name attributes>`
  text,   ///< Characters between tags, as they stand, without blanks at their ends; never empty.
  close,  ///< `</name>`, or the end of `<name/>`.
  end,    ///< The text is over, or has a mistake that was reported.
};

/// Takes apart the XML of orbit files, which is a small part of XML: elements, attributes and text. Comments and
/// processing instructions are passed over. Declarations of types, CDATA, and elements that are not closed in order are
/// reported and end the text.
class XmlScan {
 public:
  /// Keeps views of the text and the log.
  XmlScan(std::string_view text, FileProblems& problems);

  /// Goes on to the next event.
  [[nodiscard]] XmlEvent next();

  /// Of the element that was opened, closed, or holds the text; without a prefix "ndm:".
  [[nodiscard]] std::string_view name() const { return name_; }
  /// The characters of a text.
  [[nodiscard]] std::string_view text() const { return piece_; }
  /// The value of an attribute of the element just opened, as it stands; empty where there is none.
  [[nodiscard]] std::string_view attribute(std::string_view attribute_name) const;
  /// How many elements are open.
  [[nodiscard]] std::size_t depth() const { return open_.size(); }
  /// Whether the text ended in order: all elements closed, and at least one seen.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  XmlEvent fail(std::string_view at, const char* message, const char* expected, const char* hint = "");
  [[nodiscard]] bool skip(std::string_view begin, std::string_view end, bool& skipped);
  [[nodiscard]] bool skip_marks(bool& skipped);
  [[nodiscard]] XmlEvent take_text();
  [[nodiscard]] XmlEvent take_tag();
  [[nodiscard]] XmlEvent close_tag(std::string_view raw_name);
  [[nodiscard]] XmlEvent finish();

  std::string_view rest_;
  FileProblems& problems_;
  std::vector<std::string_view> open_;  // names as they stand
  std::string_view name_;
  std::string_view attributes_;
  std::string_view piece_;
  bool close_next_ = false;  // of <name/>
  bool close_done_ = false;  // the element given last is to be taken off
  bool broken_ = false;
  bool any_ = false;
  bool complete_ = false;
};

/// A text with its entities replaced: the five of XML and numbers of characters. Nothing where one is not known.
[[nodiscard]] std::optional<std::string> without_entities(std::string_view text);

}  // namespace sarsim::scene::ephemeris
