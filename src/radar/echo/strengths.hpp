#pragma once

#include <algorithm>
#include <complex>
#include <span>
#include <vector>

#include "core/os/aligned_vector.hpp"
#include "radar/echo/echo_batch.hpp"

namespace sarsim::radar {

/// What the row of one pulse needs to know of its echoes to turn them into positions and phasors.
struct RowFrame {
  double carrier_hz = 0.0;
  double origin_s = 0.0;  ///< Delay at which an echo's leading edge falls on the row's first sample.
  double interval_s = 1.0;
  double from = 0.0;  ///< Echoes with leading edges in (from, to), in samples, touch the row.
  double to = 0.0;
};

/// What D and a of echoes lie between; 0 without echoes.
struct MotionSpan {
  double lowest_doppler = 0.0;
  double highest_doppler = 0.0;
  double lowest_bend = 0.0;
  double highest_bend = 0.0;

  /// Whether any D or a is not 0.
  [[nodiscard]] bool moving() const {
    return lowest_doppler != 0.0 || highest_doppler != 0.0 || lowest_bend != 0.0 || highest_bend != 0.0;
  }
  /// The span of these echoes and of others.
  [[nodiscard]] MotionSpan with(const MotionSpan& other) const {
    return {std::min(lowest_doppler, other.lowest_doppler), std::max(highest_doppler, other.highest_doppler),
            std::min(lowest_bend, other.lowest_bend), std::max(highest_bend, other.highest_bend)};
  }
};

/// The echoes of one pulse, or of a part of it, that touch its row.
template <class Real>
struct Strengths {
  core::AlignedVector<double> position;              ///< Of the leading edge, samples after the row's first.
  core::AlignedVector<std::complex<Real>> strength;  ///< A exp(-j 2 pi (f tau - phi)).
  core::AlignedVector<double> doppler;               ///< D.
  core::AlignedVector<double> dilation_rate;         ///< a; empty where the batch has none.
  MotionSpan motion;                                 ///< Of `doppler` and `dilation_rate`.
  core::AlignedVector<double> room;                  ///< For changes of their order.
  core::AlignedVector<std::complex<Real>> strength_room;

  /// How echo k is stretched.
  [[nodiscard]] PulseClock clock(std::size_t k) const {
    return {doppler[k], dilation_rate.empty() ? 0.0 : dilation_rate[k]};
  }
};

/// Computes strengths in SIMD, in the order of the batch; the phase is reduced in double precision before the phasor is
/// taken, which is exact to that of `Real`.
template <class Real>
void gather_strengths(const EchoBatch& echoes, const RowFrame& frame, Strengths<Real>& out);

/// Takes echoes from sixteen parts in turn where neighbours mostly fall on the same samples: added one by one, each
/// would wait for what the last has just stored.
template <class Real>
void part_neighbours(Strengths<Real>& echoes);

/// D' = late_of(e)/e of each echo, what it is late by for each second that a part of the pulse was sent after its
/// middle; in SIMD.
/// @param dilation_rate  a of each echo, or empty
/// @param sent_s      e
void late_rates(std::span<const double> doppler, std::span<const double> dilation_rate, double sent_s,
                std::span<double> rate);

/// A span of D, or of a.
struct DopplerSpan {
  double middle = 0.0;
  double half = 0.0;
  friend bool operator==(const DopplerSpan&, const DopplerSpan&) = default;
};

/// The node in [-1, 1] that term `r` of an interpolation in D stands at: Chebyshev's points.
[[nodiscard]] double doppler_node(std::size_t r, std::size_t terms);

/// Strengths of the echoes for each node of an interpolation: times Lagrange's polynomials, in SIMD.
/// @param strength       of each echo
/// @param at             where each echo stands in the span: its D, or its a
/// @param terms          at most `max_doppler_terms`
/// @param[out] weighted  terms x echoes, term-major
template <class Real>
void weigh_strengths(std::span<const std::complex<Real>> strength, std::span<const double> at, const DopplerSpan& span,
                     std::size_t terms, std::span<std::complex<Real>> weighted);

inline constexpr std::size_t max_doppler_terms = 24;

}  // namespace sarsim::radar
