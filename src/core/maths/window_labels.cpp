#include "core/maths/window_labels.hpp"

#include <array>
#include <utility>

#include "core/text/number_text.hpp"

namespace sarsim::core {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 26> spellings_of_windows{{
    {"rectangular", "rectangular"},
    {"rect", "rectangular"},
    {"rectwin", "rectangular"},
    {"rectangle", "rectangular"},
    {"none", "rectangular"},
    {"uniform", "rectangular"},
    {"boxcar", "rectangular"},
    {"dirichlet", "rectangular"},
    {"unweighted", "rectangular"},
    {"hann", "hann"},
    {"hanning", "hann"},
    {"von-hann", "hann"},
    {"vonhann", "hann"},
    {"hannwin", "hann"},
    {"hamming", "hamming"},
    {"hamm", "hamming"},
    {"bartlett", "bartlett"},
    {"triangular", "bartlett"},
    {"triang", "bartlett"},
    {"triangle", "bartlett"},
    {"blackman", "blackman"},
    {"kaiser", "kaiser"},
    {"kaiser-bessel", "kaiser"},
    {"taylor", "taylor"},
    {"taylorwin", "taylor"},
    {"taylor-window", "taylor"},
}};

}  // namespace

std::string_view window_word(std::string_view typed) {
  for (const auto& [spelling, word] : spellings_of_windows)
    if (equal_ignoring_case(spelling, typed)) return word;
  return typed;
}

}  // namespace sarsim::core
