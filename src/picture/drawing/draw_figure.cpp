#include "picture/drawing/draw_figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "picture/drawing/draw_panel.hpp"

namespace sarsim::picture {

namespace {

constexpr double border_px = 8.0;

// Words across the picture; without any they need no room.
class Heading {
 public:
  Heading(const Canvas& canvas, const std::string& text, bool bold)
      : words_(canvas, text, canvas.width() - 2.0 * border_px, bold), empty_(text.empty()) {}

  [[nodiscard]] double height() const { return empty_ ? 0.0 : words_.height() + gap_px; }
  void draw(const Canvas& canvas, double top) const {
    canvas.use(Role::text);
    if (!empty_) words_.draw(border_px, top + 0.5 * gap_px);
  }

 private:
  Words words_;
  bool empty_;
};

// The panels in their places. Margins depend on the marks, and these on the lengths that the margins leave: they are
// found in turns.
std::vector<PlacedPanel> placed_panels(const Canvas& canvas, const Figure& figure, const std::vector<Heading>& titles,
                                       double top, double bottom) {
  constexpr int turns = 3;
  const std::size_t count = figure.panels.size();
  std::vector<Margins> margins(count, {60.0, 60.0, 20.0, 40.0});
  std::vector<PlacedPanel> panels(count);
  for (int turn = 0; turn < turns; ++turn) {
    double left = 0.0;
    double right = 0.0;
    double words = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      left = std::max(left, margins[i].left);
      right = std::max(right, margins[i].right);
      words += margins[i].above + margins[i].below + titles[i].height();
    }
    const double height = std::max((bottom - top - words) / static_cast<double>(count), 1.0);
    double at = top;
    for (std::size_t i = 0; i < count; ++i) {
      at += titles[i].height() + margins[i].above;
      panels[i] = placed(canvas, figure.panels[i], {left, at, canvas.width() - left - right, height});
      at += height + margins[i].below;
    }
    if (turn + 1 < turns) std::ranges::transform(panels, margins.begin(), margins_of);
  }
  return panels;
}

}  // namespace

std::string drawn_figure(const Figure& figure, PictureKind kind, const PictureStyle& style,
                         const core::StopFlag* stop) {
  Canvas canvas(kind, style, figure.title, stop);
  const Heading title(canvas, figure.title, true);
  const Heading note(canvas, figure.note, false);
  std::vector<Heading> titles;
  titles.reserve(figure.panels.size());
  for (const FigurePanel& panel : figure.panels) titles.emplace_back(canvas, panel.title, false);
  const double top = 0.5 * border_px + title.height();
  const double bottom = canvas.height() - 0.5 * border_px - note.height();
  title.draw(canvas, 0.5 * border_px);
  const std::vector<PlacedPanel> panels = placed_panels(canvas, figure, titles, top, bottom);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    titles[i].draw(canvas, panels[i].area.top - margins_of(panels[i]).above - titles[i].height());
    draw_panel(canvas, figure.panels[i], panels[i]);
  }
  note.draw(canvas, bottom);
  return canvas.finish();
}

}  // namespace sarsim::picture
