#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "radar/echo/polynomial_fit.hpp"
#include "radar/waveform/pulse.hpp"

namespace sarsim::radar {

/// What multiplies the tone of a hard-edged pulse, as polynomials between borders: the envelope, and for a user-defined
/// pulse its I and Q too. Positions are sampling intervals after the leading edge.
///
/// Linear and cubic curves are such polynomials from knot to knot. Low-pass curves are fitted; where the sum over the
/// nearest grid points changes its terms, they jump (LowPassRule::origin) or bend (first_knot), and a piece ends.
class PulsePieces {
 public:
  /// Keeps a reference to the pulse.
  PulsePieces(const Pulse& pulse, double interval_s);

  /// What the pieces stand for, `t_s` after the leading edge, 0 <= t < Tp.
  [[nodiscard]] std::complex<double> exact(double t_s) const {
    return is_complex() ? pulse_->value(t_s) : pulse_->envelope_value(t_s);
  }
  /// False for a gain, true for I and Q.
  [[nodiscard]] bool is_complex() const { return pulse_->kind == Pulse::Kind::user; }
  /// Largest magnitude that was met.
  [[nodiscard]] double largest() const { return largest_; }
  /// Width of the pulse.
  [[nodiscard]] double width() const { return border_.back(); }

  /// Number of pieces; piece k covers [border(k), border(k + 1)).
  [[nodiscard]] std::size_t size() const { return powers_.size(); }
  [[nodiscard]] double border(std::size_t k) const { return border_[k]; }
  /// The piece that holds a position; the first or the last one outside the pulse.
  [[nodiscard]] std::size_t piece_at(double position) const { return piece_at(position, 0, size()); }
  /// The same among the pieces [first, last).
  [[nodiscard]] std::size_t piece_at(double position, std::size_t first, std::size_t last) const;
  /// The polynomial of a piece: inside the piece within 1e-12 of the largest magnitude, or what rounding of the
  /// position makes of a steep curve; continued outside.
  [[nodiscard]] std::complex<double> value(std::size_t piece, double position) const;
  /// The pulse jumps at a border, or as good as jumps.
  [[nodiscard]] bool is_sharp(std::size_t border) const { return sharp_[border] != 0; }
  /// No polynomial: only `exact` tells.
  [[nodiscard]] bool is_only_exact(std::size_t piece) const { return exact_only_[piece] != 0; }
  /// Only `exact` tells: so close to a jump that rounding decides on which side of it the position lies.
  [[nodiscard]] bool is_in_doubt(std::size_t piece, double position) const;

 private:
  void find_borders();
  void add_curve(const core::Interpolator& curve);
  void add_jumps(const core::Interpolator& curve, double step);
  void find_largest();
  void fit(double begin, double end, int splits);
  void mark_sharp_borders();
  [[nodiscard]] FitTerms values_at_nodes(double begin, double end) const;

  const Pulse* pulse_;
  double interval_s_;
  double largest_ = 0.0;
  std::vector<double> border_;
  std::vector<char> sharp_;
  std::vector<double> jumps_;
  std::vector<double> bends_;  // where a low-pass curve may bend
  std::vector<std::size_t> degree_;
  std::vector<char> exact_only_;  // too short for a position to be sure, or beyond a polynomial
  std::vector<FitTerms> powers_;
};

}  // namespace sarsim::radar
