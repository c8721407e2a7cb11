#pragma once

#include <QString>
#include <filesystem>
#include <string>
#include <string_view>

#include "picture/facts/display_text.hpp"

namespace sarsim::gui {

/// A text, in UTF-8, as Qt has it.
[[nodiscard]] inline QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

[[nodiscard]] inline QString text_of(const std::string& text) { return QString::fromStdString(text); }

/// A quantity as a field shows it, with µ and ² (picture/facts/display_text.hpp).
[[nodiscard]] inline QString display_of(const std::string& quantity) {
  return text_of(picture::display_text(quantity));
}

/// The same where it is only read, with the sign of minus.
[[nodiscard]] inline QString read_out(const std::string& quantity) { return text_of(picture::read_out_text(quantity)); }

/// A path as people read it.
[[nodiscard]] inline QString text_of(const std::filesystem::path& path) { return text_of(path.string()); }

/// Steps of a progress bar.
inline constexpr int bar_steps = 1000;

/// How far long work is, and how long it still takes.
/// @param seconds_left  below 0: not known yet, and not said
[[nodiscard]] QString with_time_left(const QString& done, double seconds_left);
/// The same of a share, 0 to 1: "42 %, about 3 s left".
[[nodiscard]] QString share_with_time_left(double fraction, double seconds_left);

}  // namespace sarsim::gui
