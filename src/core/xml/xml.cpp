#include "core/xml/xml.hpp"

#include <algorithm>
#include <string>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::core {

namespace {

std::string on_line(std::string_view text, std::ptrdiff_t offset, const std::string& message) {
  const std::size_t end = std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  return "line " + std::to_string(1 + std::ranges::count(text.substr(0, end), '\n')) + ": " + message;
}

/// The first element that lies too deep, or none. Without recursion, because the depth is what is in doubt.
pugi::xml_node too_deep(const pugi::xml_document& document) {
  pugi::xml_node node = document.first_child();
  for (std::size_t depth = 1; node;) {
    if (depth > deepest_xml) return node;
    if (node.first_child()) {
      node = node.first_child();
      ++depth;
      continue;
    }
    while (node && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    node = node.next_sibling();
  }
  return node;
}

}  // namespace

std::string parse_xml(std::string_view text, pugi::xml_document& document) {
  document.reset();
  if (text.size() > longest_xml) {
    return "the XML has " + std::to_string(text.size()) + " bytes; at most " + std::to_string(longest_xml) +
           " are read";
  }
  const auto parts = static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return c == '<' || c == '='; }));
  if (parts > max_xml_parts) {
    return "the XML has " + std::to_string(parts) + " tags and attributes; at most " + std::to_string(max_xml_parts) +
           " are read";
  }
  const pugi::xml_parse_result read =
      document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_auto);
  std::string wrong;
  if (!read) {
    std::string message = read.description();
    if (!message.empty()) message.front() = static_cast<char>(message.front() | 0x20);
    wrong = on_line(text, read.offset, message);
  } else if (std::ranges::any_of(document, [](pugi::xml_node node) { return node.type() == pugi::node_doctype; })) {
    wrong = "the XML has a document type declaration (<!DOCTYPE ...>), which could define entities and is not read";
  } else if (const pugi::xml_node deep = too_deep(document)) {
    wrong =
        on_line(text, deep.offset_debug(), "elements are nested more than " + std::to_string(deepest_xml) + " deep");
  }
  if (!wrong.empty()) document.reset();
  return wrong;
}

std::string_view local_name(pugi::xml_node node) {
  const std::string_view name = node.name();
  return name.substr(name.find(':') + 1);
}

bool same_content(pugi::xml_node a, pugi::xml_node b) {
  if (trimmed(a.child_value()) != trimmed(b.child_value())) return false;
  const auto element_after = [](pugi::xml_node node) {
    while (node && node.type() != pugi::node_element) node = node.next_sibling();
    return node;
  };
  pugi::xml_node of_a = element_after(a.first_child());
  pugi::xml_node of_b = element_after(b.first_child());
  while (of_a && of_b) {
    if (local_name(of_a) != local_name(of_b) || !same_content(of_a, of_b)) return false;
    of_a = element_after(of_a.next_sibling());
    of_b = element_after(of_b.next_sibling());
  }
  return !of_a && !of_b;
}

std::string xml_text(const pugi::xml_document& document) {
  struct Text : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
  } written;
  document.save(written, "  ", pugi::format_indent | pugi::format_no_declaration, pugi::encoding_utf8);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + written.text;
}

pugi::xml_node append_text(pugi::xml_node parent, const char* name, const std::string& text) {
  pugi::xml_node node = parent.append_child(name);
  node.text().set(text.c_str());
  return node;
}

pugi::xml_node append_number(pugi::xml_node parent, const char* name, double value) {
  return append_text(parent, name, format_number(value));
}

pugi::xml_node append_count(pugi::xml_node parent, const char* name, long long value) {
  return append_text(parent, name, std::to_string(value));
}

}  // namespace sarsim::core
