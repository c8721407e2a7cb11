#pragma once

#include <QAbstractItemView>
#include <QItemSelectionModel>

namespace sarsim::gui {

/// Selects rows of a view in place of those that are selected. Qt compares each range that was selected with each that
/// will be, which takes the square of their number; of many ranges nothing is compared.
void show_selected(QAbstractItemView& view, const QItemSelection& rows);

}  // namespace sarsim::gui
