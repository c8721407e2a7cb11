#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace sarsim::signal {

/// A weight over a band or an aperture: what trades the width of a response for its sidelobes.
struct SarWindow {
  /// The families of windows.
  enum class Kind { rectangular, hamming, hann, kaiser, taylor, bartlett, blackman };

  Kind kind = Kind::rectangular;
  double beta = 2.5;           ///< Kind::kaiser, at least 0.
  double sidelobes_db = 35.0;  ///< Kind::taylor: how far sidelobes lie below the peak, above 0.
  int equal_sidelobes = 5;     ///< Kind::taylor: nbar, at least 1.

  friend bool operator==(const SarWindow&, const SarWindow&) = default;
};

/// The weight against u in [-1/2, 1/2]; 0 outside, and 1 everywhere inside for a rectangular window. Taylor's is the
/// sum 1 + 2 sum over m = 1 ... nbar - 1 of F[m] cos 2 pi m u (T. T. Taylor, IRE Trans. AP-3, 1955; Carrara, Goodman,
/// Majewski, "Spotlight Synthetic Aperture Radar", 1995, app. D), not scaled to 1 in the middle.
[[nodiscard]] std::function<double(double)> weight_of(const SarWindow& window);

/// The mean of the weights over the band.
[[nodiscard]] double mean_weight(const SarWindow& window);

/// The names of windows in options, for messages and help.
inline constexpr std::string_view window_texts =
    "rectangular, hann, hamming, bartlett, blackman, kaiser[:BETA] or taylor[:DB:NBAR]";

/// One of `window_texts` in any spelling that `core::window_word` knows ("hanning", "none", "triangular"), ignoring
/// case; nothing for another text or a parameter out of range (beta 0 to 20, 10 to 100 dB, nbar 1 to 30).
[[nodiscard]] std::optional<SarWindow> window_from_text(std::string_view text);

/// The text that `window_from_text` reads, with the canonical word.
[[nodiscard]] std::string to_string(const SarWindow& window);

}  // namespace sarsim::signal
