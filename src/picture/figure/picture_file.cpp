#include "picture/figure/picture_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <utility>

#include "core/os/output_file.hpp"
#include "core/report/expect.hpp"
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

std::string draw_picture(const Figure& figure, PictureKind kind, const PictureStyle& style) {
  CORE_EXPECT(style.width_px > 0 && style.height_px > 0);
  CORE_EXPECT(style.scale > 0.0);
  return drawing_module().draw(figure, kind, style);
}

std::string draw_sheet(const Sheet& sheet, PictureKind kind, const PictureStyle& style) {
  CORE_EXPECT(style.width_px > 0 && style.height_px > 0);
  CORE_EXPECT(style.scale > 0.0);
  return drawing_module().draw_sheet(sheet, kind, style);
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

void write_picture(const Figure& figure, const std::filesystem::path& path, const PictureStyle& style) {
  write_bytes(draw_picture(figure, kind_by_name(path), style), path);
}

void write_picture(const Sheet& sheet, const std::filesystem::path& path, const PictureStyle& style) {
  write_bytes(draw_sheet(sheet, kind_by_name(path), style), path);
}

}  // namespace sarsim::picture
