#include "signal/sar/sar_window.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/window.hpp"
#include "core/maths/window_labels.hpp"
#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::signal {

namespace {

// F[1] ... F[nbar - 1] of Taylor's weights; F[0] = 1.
std::vector<double> taylor_coefficients(double sidelobes_db, int equal_sidelobes) {
  const double a = std::acosh(std::pow(10.0, sidelobes_db / 20.0)) / core::pi;
  const double n = equal_sidelobes;
  const double dilation = n * n / (a * a + (n - 0.5) * (n - 0.5));
  std::vector<double> coefficients{1.0};
  for (int m = 1; m < equal_sidelobes; ++m) {
    double above = 1.0;
    double below = 1.0;
    for (int k = 1; k < equal_sidelobes; ++k) {
      above *= 1.0 - m * m / (dilation * (a * a + (k - 0.5) * (k - 0.5)));
      if (k != m) below *= 1.0 - static_cast<double>(m) * m / (static_cast<double>(k) * k);
    }
    coefficients.push_back((m % 2 == 1 ? 0.5 : -0.5) * above / below);
  }
  return coefficients;
}

double taylor_weight(const std::vector<double>& coefficients, double u) {
  double sum = 1.0;
  for (std::size_t m = 1; m < coefficients.size(); ++m)
    sum += 2.0 * coefficients[m] * std::cos(2.0 * core::pi * static_cast<double>(m) * u);
  return sum;
}

// The part of `text` before the next colon, which is taken away with it.
std::string_view next_word(std::string_view& text) {
  const std::size_t colon = text.find(':');
  const std::string_view word = text.substr(0, colon);
  text = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  return word;
}

std::optional<SarWindow> kaiser_from_text(std::string_view rest) {
  SarWindow window{.kind = SarWindow::Kind::kaiser};
  if (!rest.empty()) {
    const auto beta = core::parse_number(rest);
    if (!beta || !(*beta >= 0.0 && *beta <= 20.0)) return std::nullopt;
    window.beta = *beta;
  }
  return window;
}

std::optional<SarWindow> taylor_from_text(std::string_view rest) {
  SarWindow window{.kind = SarWindow::Kind::taylor};
  if (!rest.empty()) {
    const auto sidelobes = core::parse_number(next_word(rest));
    const auto count = core::parse_integer(rest);
    if (!sidelobes || !count || !(*sidelobes >= 10.0 && *sidelobes <= 100.0) || *count < 1 || *count > 30)
      return std::nullopt;
    window.sidelobes_db = *sidelobes;
    window.equal_sidelobes = static_cast<int>(*count);
  }
  return window;
}

}  // namespace

std::function<double(double)> weight_of(const SarWindow& window) {
  CORE_EXPECT(window.beta >= 0.0);
  CORE_EXPECT(window.sidelobes_db > 0.0);
  CORE_EXPECT(window.equal_sidelobes >= 1);
  const auto inside = [](auto weight) { return [weight](double u) { return std::abs(u) <= 0.5 ? weight(u) : 0.0; }; };
  switch (window.kind) {
    case SarWindow::Kind::hamming: return inside([](double u) { return core::hamming_window(u + 0.5); });
    case SarWindow::Kind::hann: return inside([](double u) { return core::hanning_window(u + 0.5, 0.0); });
    case SarWindow::Kind::bartlett: return inside([](double u) { return core::bartlett_window(u + 0.5); });
    case SarWindow::Kind::blackman: return inside([](double u) { return core::blackman_window(u + 0.5); });
    case SarWindow::Kind::kaiser: return [beta = window.beta](double u) { return core::kaiser_window(2.0 * u, beta); };
    case SarWindow::Kind::taylor:
      return inside([c = taylor_coefficients(window.sidelobes_db, window.equal_sidelobes)](double u) {
        return taylor_weight(c, u);
      });
    case SarWindow::Kind::rectangular: break;
  }
  return inside([](double) { return 1.0; });
}

double mean_weight(const SarWindow& window) {
  CORE_EXPECT(window.beta >= 0.0);
  CORE_EXPECT(window.sidelobes_db > 0.0);
  CORE_EXPECT(window.equal_sidelobes >= 1);
  // The midpoint rule: exact for sums of cosines and for a triangle, and Kaiser's weights are smooth.
  constexpr int steps = 4096;
  const auto weight = weight_of(window);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += weight((i + 0.5) / steps - 0.5);
  return sum / steps;
}

std::optional<SarWindow> window_from_text(std::string_view text) {
  std::string_view rest = text;
  const std::string_view word = core::window_word(next_word(rest));
  if (word == "kaiser") return kaiser_from_text(rest);
  if (word == "taylor") return taylor_from_text(rest);
  if (text.find(':') != std::string_view::npos) return std::nullopt;
  using Kind = SarWindow::Kind;
  static constexpr std::array<std::pair<std::string_view, Kind>, 5> plain{{{"rectangular", Kind::rectangular},
                                                                           {"hamming", Kind::hamming},
                                                                           {"hann", Kind::hann},
                                                                           {"bartlett", Kind::bartlett},
                                                                           {"blackman", Kind::blackman}}};
  for (const auto& [name, kind] : plain)
    if (name == word) return SarWindow{.kind = kind};
  return std::nullopt;
}

std::string to_string(const SarWindow& window) {
  switch (window.kind) {
    case SarWindow::Kind::hamming: return "hamming";
    case SarWindow::Kind::hann: return "hann";
    case SarWindow::Kind::bartlett: return "bartlett";
    case SarWindow::Kind::blackman: return "blackman";
    case SarWindow::Kind::kaiser: return fmt::format("kaiser:{}", window.beta);
    case SarWindow::Kind::taylor: return fmt::format("taylor:{}:{}", window.sidelobes_db, window.equal_sidelobes);
    case SarWindow::Kind::rectangular: break;
  }
  return "rectangular";
}

}  // namespace sarsim::signal
