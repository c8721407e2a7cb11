#pragma once

#include <cstddef>
#include <optional>

#include "core/task/stop.hpp"
#include "picture/figure/figure.hpp"

namespace sarsim::picture {

/// An image for no more than so many dots: where it has more cells, each dot has the colour of the strongest of its
/// cells, so that no point is lost that is one cell wide. What is strong, the colour bar says: the largest value, of a
/// diverging map that furthest from zero; of a cyclic map no value is stronger than another. Colours that are not in
/// the bar, and all without a bar, are equally weak. An image that has no more cells stays as it is.
/// @param columns, rows  dots across and up, at least one each
/// @param stop           asked before each row; a requested stop throws Interrupted
[[nodiscard]] FigureImage fitted(const FigureImage& image, const std::optional<FigureColourBar>& bar,
                                 std::size_t columns, std::size_t rows, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::picture
