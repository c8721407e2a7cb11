#include "cli/shell/figures.hpp"

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::cli {

Figure si_figure(std::string label, std::string key, double value, std::string_view unit) {
  return {std::move(label), core::with_prefix(value, unit), std::move(key), value, {}};
}

Figure figure(std::string label, std::string key, double value) {
  return {std::move(label), fmt::format("{:.6g}", value), std::move(key), value, {}};
}

Figure figure(std::string label, std::string key, double value, std::string text) {
  return {std::move(label), std::move(text), std::move(key), value, {}};
}

Figure word_figure(std::string label, std::string key, std::string word) {
  return {std::move(label), word, std::move(key), 0.0, word};
}

std::string figures_text(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& f : figures) text += fmt::format("  {:<24} {}\n", f.label, f.text);
  return text;
}

void write_json(core::JsonWriter& json, const std::vector<Figure>& figures) {
  for (const Figure& f : figures) {
    if (f.key.empty()) continue;
    if (f.word.empty())
      json.member(f.key, f.value);
    else
      json.member(f.key, f.word);
  }
}

}  // namespace sarsim::cli
