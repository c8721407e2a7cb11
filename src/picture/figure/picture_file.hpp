#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/task/stop.hpp"
#include "picture/figure/figure.hpp"
#include "picture/figure/picture_style.hpp"
#include "picture/figure/sheet.hpp"

namespace sarsim::picture {

/// The kind that a file's name ends with, in capitals or not; nothing where it ends otherwise.
[[nodiscard]] std::optional<PictureKind> picture_kind_of(const std::filesystem::path& path);
/// How names may end, for messages.
inline constexpr std::string_view picture_endings = ".png, .svg or .pdf";

/// The bytes of a picture: the same for equal figures and the same fonts, but that the parts of an SVG are numbered on
/// from those of the SVGs that the process drew before. Needs no display. Where an image has metres
/// along both axes and one side is at most three times the other, a metre is as long on both.
/// @param stop  asked now and then; a requested stop throws Interrupted
/// @throws std::runtime_error where the module that draws cannot be loaded, or the picture is too large to be drawn
[[nodiscard]] std::string draw_picture(const Figure& figure, PictureKind kind, const PictureStyle& style,
                                       const core::StopFlag* stop = nullptr);

/// The same of a sheet, whose places fit the size of the style.
[[nodiscard]] std::string draw_sheet(const Sheet& sheet, PictureKind kind, const PictureStyle& style,
                                     const core::StopFlag* stop = nullptr);

/// Draws a figure into a file, whose name must end as a picture's; what stood there stays until the picture is whole.
/// @throws as `draw_picture`; std::system_error where the file cannot be written
void write_picture(const Figure& figure, const std::filesystem::path& path, const PictureStyle& style,
                   const core::StopFlag* stop = nullptr);
/// The same of a sheet.
void write_picture(const Sheet& sheet, const std::filesystem::path& path, const PictureStyle& style,
                   const core::StopFlag* stop = nullptr);

}  // namespace sarsim::picture
