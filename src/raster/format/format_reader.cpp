#include "raster/format/format_reader.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "raster/format/array_reader.hpp"
#include "raster/format/envi_reader.hpp"
#include "raster/format/image_openers.hpp"
#include "raster/format/text_reader.hpp"

namespace sarsim::raster {

namespace {

const Format* with_signature(const core::InputFile& file, bool pictures) {
  std::array<char, 8> begin{};
  const std::size_t got = file.read_at(0, std::as_writable_bytes(std::span(begin)));
  const std::string_view bytes(begin.data(), got);
  const auto found = std::ranges::find_if(formats(), [&](const Format& row) {
    return !row.signature.empty() && bytes.starts_with(row.signature) && (pictures || !row.picture);
  });
  return found == formats().end() ? nullptr : &*found;
}

const Format* in_style(TextStyle style) { return &*std::ranges::find(recording_formats(), style, &Format::text); }

// The format of files that have nothing but their numbers.
const Format* bare_numbers() {
  return &*std::ranges::find_if(recording_formats(),
                                [](const Format& row) { return !row.is_text() && row.signature.empty(); });
}

}  // namespace

const FormatReader text_reader{
    .samples = [](core::InputFile file, const Format& format,
                  const SampleFileHints& hints) { return open_text(std::move(file), format.text, hints); },
    .image = [](core::InputFile file, const Format& format,
                const ImageHints& hints) { return open_text_image(std::move(file), format.text, hints.samples); }};

const FormatReader binary_reader{
    .samples = [](core::InputFile file, const Format&,
                  const SampleFileHints& hints) { return open_binary(std::move(file), hints); },
    .image = [](core::InputFile file, const Format&,
                const ImageHints& hints) { return open_binary_image(std::move(file), hints.samples); }};

const FormatReader npy_reader{
    .samples = [](core::InputFile file, const Format&,
                  const SampleFileHints& hints) { return open_npy(std::move(file), hints); },
    .image = [](core::InputFile file, const Format&,
                const ImageHints& hints) { return open_npy_image(std::move(file), hints.samples); }};

const FormatReader envi_file_reader{
    .samples = [](core::InputFile file, const Format&, const SampleFileHints&) { return open_envi(file.path()); }};

const FormatReader sun_reader{
    .image = [](core::InputFile file, const Format&, const ImageHints&) { return open_sun_image(std::move(file)); }};

const FormatReader custom_reader{.image = [](core::InputFile file, const Format&, const ImageHints& hints) {
  return open_raw_image(std::move(file), hints.raw.value());
}};

const Format* detect_format(const core::InputFile& file, const SampleFileHints& hints, bool pictures) {
  if (hints.format) return &format_of(*hints.format);
  if (const Format* const row = with_signature(file, pictures)) return row;
  const auto recording = format_from_path(file.path());
  const Format* const named = recording ? &format_of(*recording) : nullptr;
  if (named != nullptr && !named->is_text()) return named;
  if (const TextStyle style = style_of_text(file); style != TextStyle::none) return in_style(style);
  if (hints.columns > 0 && hints.bits > 0) return bare_numbers();
  return named;
}

}  // namespace sarsim::raster
