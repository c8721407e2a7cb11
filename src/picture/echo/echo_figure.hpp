#pragma once

#include <string>

#include "picture/echo/echo_matrix.hpp"
#include "picture/echo/echo_picture.hpp"
#include "picture/echo/echo_window.hpp"
#include "picture/figure/figure.hpp"

namespace sarsim::picture {

/// What a simulation window shows, as a figure: coloured pixels with their colour bar, or curves; slant range (and
/// delay as its twin) across, azimuth time upwards, the highest magnitude as the note.
/// @param how  quantity, colours, draw-as and placing
[[nodiscard]] Figure echo_figure(const EchoMatrix& matrix, const EchoWindow& how);

/// The values of one pulse against range, and of one range against time, below each other; the shown quantity.
/// @param row, column  of the matrix
[[nodiscard]] Figure cut_figure(const EchoMatrix& matrix, const EchoColours& colours, std::size_t row,
                                std::size_t column);

/// One pulse as text for a spreadsheet: a header line, then for each column range, I, Q, magnitude and phase.
/// @param row  of the matrix, ready
[[nodiscard]] std::string pulse_table(const EchoMatrix& matrix, std::size_t row, char separator);

}  // namespace sarsim::picture
