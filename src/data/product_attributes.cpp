#include "data/product_attributes.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "base/number_text.hpp"

namespace sarsim {

namespace {

// One of the words that an attribute may have.
template <class Value>
void take_word(const std::string& word, std::initializer_list<std::pair<std::string_view, Value>> words, Value& value) {
  for (const auto& [name, meant] : words)
    if (word == name) value = meant;
}

}  // namespace

std::string attribute_of(const FileAttributes& attributes, std::string_view name) {
  const auto found =
      std::ranges::find(attributes, name, [](const auto& pair) -> std::string_view { return pair.first; });
  return found == attributes.end() ? std::string() : found->second;
}

void take_origin(const FileAttributes& attributes, Product& product) {
  const auto value = [&](std::string_view name) { return attribute_of(attributes, name); };
  RunOptions& options = product.options;
  if (std::string radar = value("radar"); !radar.empty()) product.radar = std::move(radar);
  if (std::string engine = value("engine"); !engine.empty()) product.engine = std::move(engine);
  take_word(value("processing"),
            {{"raw", Processing::raw}, {"matched_filter", Processing::matched_filter}, {"srp", Processing::srp}},
            product.processing);
  take_word(value("profile"), {{"physical", Profile::physical}, {"classic", Profile::classic}}, options.profile);
  take_word(value("pulse"), {{"ideal", PulseDefinition::ideal}, {"band_limited", PulseDefinition::band_limited}},
            options.pulse);
  const std::string seed = value("seed");
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(seed.data(), seed.data() + seed.size(), number);
  if (error == std::errc() && end == seed.data() + seed.size()) options.seed = number;
  if (const auto tolerance = parse_number(value("tolerance"))) options.tolerance = *tolerance;
}

}  // namespace sarsim
