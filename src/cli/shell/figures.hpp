#pragma once

#include <string>
#include <vector>

#include "core/text/json.hpp"

namespace sarsim::cli {

/// One derived quantity, for people and for programs.
struct Figure {
  std::string label;  ///< "range resolution"
  std::string text;   ///< "1.49896 m"
  std::string key;    ///< "range_resolution_m"; empty: for people only.
  double value = 0.0;
  std::string word;  ///< Instead of the value, where not empty.
};

/// A number with its unit, with an SI prefix.
[[nodiscard]] Figure si_figure(std::string label, std::string key, double value, std::string_view unit);
/// A plain number.
[[nodiscard]] Figure figure(std::string label, std::string key, double value);
/// A number whose text for people is written by hand.
[[nodiscard]] Figure figure(std::string label, std::string key, double value, std::string text);
/// A word.
[[nodiscard]] Figure word_figure(std::string label, std::string key, std::string word);

/// "  label   text" lines.
[[nodiscard]] std::string figures_text(const std::vector<Figure>& figures);

/// Members of the open JSON object.
void write_json(core::JsonWriter& json, const std::vector<Figure>& figures);

}  // namespace sarsim::cli
