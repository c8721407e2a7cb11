#pragma once

#include <string>
#include <vector>

#include "picture/figure/figure.hpp"

/// Axes and panels that figures of curves have in common.
namespace sarsim::picture {

/// Decibels below the largest value of a curve that are still drawn; silence would hide everything else.
inline constexpr double deepest_db = 120.0;

/// Gives an axis the limits of the finite values with a margin about them; 1 apart on either side where they coincide.
void fit(FigureAxis& axis, const std::vector<double>& values);

/// An axis from the smallest value to the largest, however few there are.
[[nodiscard]] FigureAxis axis_along(std::string label, std::string unit, const std::vector<double>& values);

/// Breaks a curve before every point that lies to the left of the one before it, as the ranges of synthetic range
/// profiles do, which overlap from gate to gate.
void break_where_it_turns_back(FigureCurve& curve);

/// A panel with one curve; `up` is fitted to it.
[[nodiscard]] FigurePanel curve_panel(std::string title, FigureAxis across, FigureAxis up, std::vector<double> x,
                                      std::vector<double> y);

/// factor log10 of each value (10: powers, 20: magnitudes), not more than `depth_db` below the largest.
[[nodiscard]] std::vector<double> decibels_of(std::vector<double> values, double factor, double depth_db = deepest_db);

/// Marks the highest maxima of a panel's first curve with their places along x, highest first: between samples by the
/// parabola through the three about a maximum. Marks whose words would stand on others' have none. A maximum is higher
/// than the sample before it and not lower than the one after it. The axis upwards gets room for the words.
/// @param count  at most so many
void mark_peaks(FigurePanel& panel, std::size_t count);

}  // namespace sarsim::picture
