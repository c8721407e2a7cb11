#include "core/text/separated.hpp"

#include "core/text/number_text.hpp"

namespace sarsim::core {

std::optional<std::vector<double>> numbers_between_commas(std::string_view text) {
  std::vector<double> numbers;
  bool good = true;
  each_piece(text, ',', [&](std::string_view piece) {
    const auto number = good ? parse_number(piece) : std::nullopt;
    good = number.has_value();
    if (good) numbers.push_back(*number);
  });
  if (!good) return std::nullopt;
  return numbers;
}

std::optional<std::vector<double>> numbers_of_list(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return std::vector<double>();
  if (text.ends_with(',')) text.remove_suffix(1);
  return numbers_between_commas(text);
}

}  // namespace sarsim::core
