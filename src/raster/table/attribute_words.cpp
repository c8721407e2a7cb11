#include "raster/table/attribute_words.hpp"

#include <algorithm>
#include <array>

namespace sarsim::raster {

namespace {

constexpr std::array<std::pair<std::string_view, scene::Processing>, 3> processing_words{
    {{"raw", scene::Processing::raw},
     {"matched_filter", scene::Processing::matched_filter},
     {"srp", scene::Processing::srp}}};

}  // namespace

std::string attribute_of(const FileAttributes& attributes, std::string_view name) {
  const auto found =
      std::ranges::find(attributes, name, [](const auto& pair) -> std::string_view { return pair.first; });
  return found == attributes.end() ? std::string() : found->second;
}

std::string attribute_word(scene::Processing processing) {
  const auto* const found =
      std::ranges::find_if(processing_words, [&](const auto& known) { return known.second == processing; });
  return std::string((found == processing_words.end() ? processing_words.front() : *found).first);
}

std::optional<scene::Processing> processing_of(std::string_view word) {
  const auto* const found =
      std::ranges::find_if(processing_words, [&](const auto& known) { return known.first == word; });
  return found == processing_words.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace sarsim::raster
