#include "picture/figure/picture_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/os/free_memory.hpp"
#include "core/os/output_file.hpp"
#include "core/report/expect.hpp"
#include "core/text/number_text.hpp"
#include "picture/figure/load_drawing.hpp"

namespace sarsim::picture {

std::optional<PictureKind> picture_kind_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [name, kind] :
       {std::pair(".png", PictureKind::png), std::pair(".svg", PictureKind::svg), std::pair(".pdf", PictureKind::pdf)})
    if (ending == name) return kind;
  return std::nullopt;
}

namespace {

// The libraries that draw end the process where they get no memory for a thread or a font, and each thread takes some
// for its heap.
void expect_memory(PictureKind kind, const PictureStyle& style) {
  constexpr std::uint64_t of_libraries = std::uint64_t{112} << 20U;
  constexpr double bytes_a_dot = 8.0;
  const double dots = style.width_px * style.scale * style.height_px * style.scale;
  const std::uint64_t of_dots = kind == PictureKind::png ? static_cast<std::uint64_t>(bytes_a_dot * dots) : 0;
  if (core::can_map(of_libraries + of_dots)) return;
  throw std::runtime_error(
      fmt::format("no picture can be drawn: {} of memory cannot be had; raise the limit (ulimit -v)",
                  core::bytes_text(static_cast<double>(of_libraries + of_dots))));
}

}  // namespace

std::string draw_picture(const Figure& figure, PictureKind kind, const PictureStyle& style,
                         const core::StopFlag* stop) {
  CORE_EXPECT(style.width_px > 0 && style.height_px > 0);
  CORE_EXPECT(style.scale > 0.0);
  const auto& module = drawing_module();  // Takes its part of the memory first.
  expect_memory(kind, style);
  return module.draw(figure, kind, style, stop);
}

std::string draw_sheet(const Sheet& sheet, PictureKind kind, const PictureStyle& style, const core::StopFlag* stop) {
  CORE_EXPECT(style.width_px > 0 && style.height_px > 0);
  CORE_EXPECT(style.scale > 0.0);
  const auto& module = drawing_module();
  expect_memory(kind, style);
  return module.draw_sheet(sheet, kind, style, stop);
}

namespace {

PictureKind kind_by_name(const std::filesystem::path& path) {
  const std::optional<PictureKind> kind = picture_kind_of(path);
  CORE_EXPECT(kind.has_value());
  return *kind;
}

void write_bytes(const std::string& bytes, const std::filesystem::path& path) {
  core::OutputFile file(path, true);
  file.write(std::as_bytes(std::span(bytes)));
  file.commit();
}

}  // namespace

void write_picture(const Figure& figure, const std::filesystem::path& path, const PictureStyle& style,
                   const core::StopFlag* stop) {
  write_bytes(draw_picture(figure, kind_by_name(path), style, stop), path);
}

void write_picture(const Sheet& sheet, const std::filesystem::path& path, const PictureStyle& style,
                   const core::StopFlag* stop) {
  write_bytes(draw_sheet(sheet, kind_by_name(path), style, stop), path);
}

}  // namespace sarsim::picture
