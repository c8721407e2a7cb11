#pragma once

#include <QString>
#include <filesystem>
#include <string>
#include <string_view>

namespace sarsim::gui {

/// A text, in UTF-8, as Qt has it.
[[nodiscard]] inline QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

[[nodiscard]] inline QString text_of(const std::string& text) { return QString::fromStdString(text); }

/// A path as people read it.
[[nodiscard]] inline QString text_of(const std::filesystem::path& path) { return text_of(path.string()); }

/// Steps of a progress bar.
inline constexpr int bar_steps = 1000;

}  // namespace sarsim::gui
