#include "gui/common/figure_text.hpp"

#include <algorithm>

namespace sarsim::gui {

namespace {

constexpr int max_lines = 3;
constexpr int flags = Qt::AlignCenter | Qt::TextWordWrap;

}  // namespace

FigureText::FigureText(QCustomPlot* plot, const QString& text, const QFont& font) : QCPTextElement(plot, text, font) {
  setTextFlags(flags);
}

// The width of the last layout, or of the whole picture before there was one.
int FigureText::width_px() const {
  const int sides = mMargins.left() + mMargins.right();
  const QCPLayout* const all = layout();
  const int laid_out = mParentPlot != nullptr ? mParentPlot->viewport().width() : 0;
  const int other = all != nullptr ? outerRect().width() : 0;
  const int width = other > sides && other <= laid_out ? other : laid_out;
  return std::max(width - sides, 1);
}

QString FigureText::fitting(int width_px) const {
  const QFontMetrics metrics(mFont);
  const auto fits = [&](const QString& text) {
    const QRect needed = metrics.boundingRect(QRect(0, 0, width_px, 1 << 20), flags, text);
    return needed.width() <= width_px && needed.height() < (max_lines + 0.5) * metrics.lineSpacing();
  };
  if (fits(mText)) return mText;
  // Lines break between words, which leaves some of each empty; a word that is longer than a line has one alone.
  for (const double lines : {3.0, 2.8, 2.6, 2.4, 2.2, 2.0, 1.5, 1.0}) {
    const QString shorter = metrics.elidedText(mText, Qt::ElideRight, static_cast<int>(lines * width_px));
    if (fits(shorter)) return shorter;
  }
  return metrics.elidedText(mText, Qt::ElideRight, width_px);
}

// A pixel more than the letters: in a picture of another scale they are not as high as here.
int FigureText::height_px(int width_px) const {
  const QFontMetrics metrics(mFont);
  const QRect words = metrics.boundingRect(QRect(0, 0, width_px, 1 << 20), flags, fitting(width_px));
  return words.height() + metrics.descent() / 2 + 1 + mMargins.top() + mMargins.bottom();
}

void FigureText::draw(QCPPainter* painter) {
  painter->setFont(mFont);
  painter->setPen(QPen(mTextColor));
  painter->drawText(mRect, flags | Qt::TextDontClip, fitting(mRect.width()), &mTextBoundingRect);
}

QSize FigureText::minimumOuterSizeHint() const { return {0, height_px(width_px())}; }

QSize FigureText::maximumOuterSizeHint() const { return {QWIDGETSIZE_MAX, height_px(width_px())}; }

}  // namespace sarsim::gui
