#pragma once

#include <optional>
#include <span>
#include <string>

#include "picture/figure/figure.hpp"

namespace sarsim::picture {

/// Colours for so many curves in one pair of axes can be told apart.
inline constexpr std::size_t max_overlaid_curves = 5;

/// A figure whose curves are laid over those of others.
struct OverlaidFigure {
  std::string name;  ///< For the legend.
  Figure figure;
};

/// The curves of all figures in the axes of the first, panel by panel, each in a colour of its own and with the name of
/// its figure; the axes reach as far as those of any of them.
/// @return nothing where that makes no sense: an image, bars, other numbers of panels, other quantities on their axes,
///         or more than `max_overlaid_curves` in a panel
[[nodiscard]] std::optional<Figure> overlaid(std::span<const OverlaidFigure> figures);

}  // namespace sarsim::picture
