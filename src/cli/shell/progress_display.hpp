#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "core/task/progress.hpp"

namespace sarsim::cli {

/// Shows how far work has come: on a terminal a bar that is drawn in place at most ten times a second and wiped out at
/// the end, elsewhere one line for every 10 %.
class ProgressDisplay {
 public:
  /// Nothing, a line for every 10 %, or a bar that is drawn in place.
  enum class Style { none, lines, bar };

  /// @param label  what is being made
  /// @param now_s  a clock, for tests; empty: the machine's
  ProgressDisplay(std::ostream& out, Style style, std::string label, std::function<double()> now_s = {});
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;
  ~ProgressDisplay();

  /// Shows where the work has come to, where that is worth a new line or picture.
  void update(const core::Progress& progress);

 private:
  void draw_bar(double share, const std::string& figures, double now_s);
  void print_line(double share, const std::string& figures, double elapsed_s);

  std::ostream& out_;
  Style style_;
  std::string label_;
  std::function<double()> now_s_;
  double begin_s_ = 0.0;
  double last_drawn_s_ = -1.0;
  std::size_t drawn_width_ = 0;
  int tenths_told_ = 0;
};

}  // namespace sarsim::cli
