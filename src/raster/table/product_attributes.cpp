#include "raster/table/product_attributes.hpp"

#include <algorithm>
#include <system_error>

#include "core/text/number_text.hpp"
#include "scene/schema/option_words.hpp"

namespace sarsim::raster {

namespace {

bool take_processing(const std::string& text, scene::Processing& value) {
  const auto found = processing_of(text);
  if (found) value = *found;
  return found.has_value();
}

bool take_text(std::string text, std::string& value) {
  if (text.empty()) return false;
  value = std::move(text);
  return true;
}

bool take_whole(const std::string& text, std::uint64_t& value) {
  const auto number = core::parse_whole(text);
  if (number) value = *number;
  return number.has_value();
}

bool take_number(const std::string& text, double& value) {
  const auto number = core::parse_number(text);
  if (number) value = *number;
  return number.has_value();
}

}  // namespace

void take_origin(const FileAttributes& attributes, Product& product) {
  scene::RunOptions& options = product.options;
  const auto take = [&](const char* name, const auto& taker) {
    if (!taker(attribute_of(attributes, name))) product.unknown.emplace_back(name);
  };
  take("radar", [&](const std::string& text) { return take_text(text, product.radar); });
  take("engine", [&](const std::string& text) { return take_text(text, product.engine); });
  take("processing", [&](const std::string& text) { return take_processing(text, product.processing); });
  for (const auto& [id, word] : scene::option_words(options))
    take(id.c_str(), [&](const std::string& text) { return scene::take_option_word(options, id, text); });
  take("seed", [&](const std::string& text) { return take_whole(text, options.seed); });
  take("tolerance", [&](const std::string& text) { return take_number(text, options.tolerance); });
}

}  // namespace sarsim::raster
