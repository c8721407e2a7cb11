#include "cli/shell/progress_display.hpp"

#include <algorithm>
#include <chrono>
#include <ostream>

#include <fmt/format.h>

#include "core/report/problem.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::cli {

namespace {

constexpr double redraw_interval_s = 0.1;
constexpr double shortest_told_s = 0.5;  // Lines about work that takes less, as far as one knows, are noise in a log.
constexpr int bar_cells = 24;

double machine_time_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// "12.3 Msamples/s, 20 s left"
std::string figures_text(const core::Progress& progress, double elapsed_s) {
  if (elapsed_s <= 0.0 || progress.done == 0) return {};
  std::string text;
  const double rows_per_s = static_cast<double>(progress.done) / elapsed_s;
  if (progress.columns > 0)
    text = core::with_prefix(rows_per_s * static_cast<double>(progress.columns), "samples/s", 3);
  else
    text = core::with_prefix(rows_per_s, "lines/s", 3);
  if (progress.done < progress.total)
    text += ", " + core::duration_text(static_cast<double>(progress.total - progress.done) / rows_per_s) + " left";
  return text;
}

}  // namespace

ProgressDisplay::ProgressDisplay(std::ostream& out, Style style, std::string label, std::function<double()> now_s)
    : out_(out), style_(style), label_(core::printable(label)), now_s_(now_s ? std::move(now_s) : machine_time_s) {
  begin_s_ = now_s_();
}

ProgressDisplay::~ProgressDisplay() {
  if (drawn_width_ > 0) out_ << '\r' << std::string(drawn_width_, ' ') << '\r' << std::flush;
}

void ProgressDisplay::update(const core::Progress& progress) {
  if (style_ == Style::none || progress.total == 0) return;
  const double now_s = now_s_();
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const std::string figures = figures_text(progress, now_s - begin_s_);
  if (style_ == Style::bar)
    draw_bar(share, figures, now_s);
  else
    print_line(share, figures, now_s - begin_s_);
}

void ProgressDisplay::draw_bar(double share, const std::string& figures, double now_s) {
  if (last_drawn_s_ >= 0.0 && now_s - last_drawn_s_ < redraw_interval_s) return;
  last_drawn_s_ = now_s;
  const int full = std::clamp(static_cast<int>(share * bar_cells), 0, bar_cells);
  const std::string bar =
      std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(bar_cells - full), '.');
  const std::string line = fmt::format("{} [{}] {:3.0f} % {}", label_, bar, 100.0 * share, figures);
  const std::size_t blanks = drawn_width_ > line.size() ? drawn_width_ - line.size() : 0;
  out_ << '\r' << line << std::string(blanks, ' ') << std::flush;
  drawn_width_ = std::max(drawn_width_, line.size());
}

void ProgressDisplay::print_line(double share, const std::string& figures, double elapsed_s) {
  const int tenths = static_cast<int>(share * 10.0 + 1e-9);
  if (tenths <= tenths_told_) return;
  tenths_told_ = tenths;
  if (elapsed_s < shortest_told_s * share) return;
  out_ << fmt::format("{}: {} %{}{}\n", label_, 10 * tenths, figures.empty() ? "" : ", ", figures) << std::flush;
}

}  // namespace sarsim::cli
