#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace sarsim::core {

/// Longest XML text that `parse_xml` takes, in bytes.
inline constexpr std::size_t longest_xml = std::size_t{64} << 20U;
/// Most tags and attributes together that `parse_xml` takes: their tree stays below 300 MB.
inline constexpr std::size_t max_xml_parts = std::size_t{4} << 20U;
/// Deepest nesting of elements that `parse_xml` takes, so that whoever walks the tree may do so by recursion.
inline constexpr std::size_t deepest_xml = 100;

/// Reads a text that comes with a file from anywhere into `document`, which is emptied before. Without a byte order
/// mark or a declaration of another encoding the text is UTF-8; the tree always is. A document type declaration is
/// refused, and with it every entity that a file could define: none of the formats we read has one, and what they
/// expand to has no bound. Returns what is wrong ("line 3: an end tag does not belong to the start tag before it"), or
/// an empty text.
[[nodiscard]] std::string parse_xml(std::string_view text, pugi::xml_document& document);

/// The name of an element without the prefix of its name space.
[[nodiscard]] std::string_view local_name(pugi::xml_node node);

/// Whether two elements hold the same texts and elements (`local_name`), blanks at the ends of texts aside; attributes
/// are not compared.
[[nodiscard]] bool same_content(pugi::xml_node a, pugi::xml_node b);

/// The document as UTF-8 with a declaration, one element per line, indented by two blanks; the same bytes for the same
/// tree.
[[nodiscard]] std::string xml_text(const pugi::xml_document& document);

/// Appends an element with a text to `parent` and returns it.
pugi::xml_node append_text(pugi::xml_node parent, const char* name, const std::string& text);

/// Appends an element with a number, as the shortest decimal text that reads back as the same number. `value` is
/// finite.
pugi::xml_node append_number(pugi::xml_node parent, const char* name, double value);

/// Appends an element with a whole number.
pugi::xml_node append_count(pugi::xml_node parent, const char* name, long long value);

}  // namespace sarsim::core
