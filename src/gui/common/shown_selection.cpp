#include "gui/common/shown_selection.hpp"

namespace sarsim::gui {

void show_selected(QAbstractItemView& view, const QItemSelection& rows) {
  constexpr qsizetype many_ranges = 64;
  QItemSelectionModel& selected = *view.selectionModel();
  if (rows.size() > many_ranges || selected.selection().size() > many_ranges) {
    const QModelIndex current = selected.currentIndex();
    selected.reset();  // Says nothing, and forgets the current row.
    selected.setCurrentIndex(current, QItemSelectionModel::NoUpdate);
    view.viewport()->update();
  }
  selected.select(rows, QItemSelectionModel::ClearAndSelect);
}

}  // namespace sarsim::gui
