#include "workflow/image/image_facts.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "raster/table/product_attributes.hpp"
#include "workflow/image/image_fields.hpp"

namespace sarsim::workflow {

namespace {

std::string exchanged(std::string_view text, char from, char to) {
  std::string result(text);
  std::ranges::replace(result, from, to);
  return result;
}

std::string attribute_name(std::string_view field) {
  return field == "script" ? "script_file" : exchanged(field, ' ', '_');
}

// Which fields a header of a focused image has, whatever it says, but for the map.
raster::EnviHeader named_fields() {
  ImageOrigin named;
  named.settings = "some";
  named.anchor.emplace();
  raster::EnviHeader header = header_of({}, named);
  for (const char* name : {"source from image", "script from image", "script checksum", "source checksum"})
    header.fields.emplace_back(name, "");
  return header;
}

}  // namespace

raster::Facts facts_of_header(const raster::EnviHeader& header) {
  raster::Facts facts;
  for (const auto& [name, ignored] : named_fields().fields)
    if (const auto value = header.field(name)) facts.emplace_back(attribute_name(name), *value);
  return facts;
}

std::optional<raster::EnviHeader> header_of_facts(const raster::Raster& file) {
  const raster::FileAttributes& attributes = file.info().attributes;
  if (raster::attribute_of(attributes, "image_plane").empty()) return std::nullopt;
  raster::EnviHeader header = named_fields();
  header.samples = file.columns();
  header.lines = file.rows();
  for (auto& [name, value] : header.fields) value = raster::attribute_of(attributes, attribute_name(name));
  std::erase_if(header.fields, [](const auto& field) {
    return field.second.empty() &&
           (field.first == "settings" || field.first == "world anchor" || field.first == "source checksum");
  });
  return header;
}

}  // namespace sarsim::workflow
