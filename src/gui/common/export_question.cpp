#include "gui/common/export_question.hpp"

#include <QFileDialog>

#include <algorithm>
#include <vector>

#include "gui/common/text.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::gui {

namespace {

std::vector<const raster::Format*> kinds() { return raster::offered_formats(&raster::FormatPlaces::exported); }

// Without its point.
QString ending_of(const raster::Format& format) { return text_of(format.extensions.front().substr(1)); }

QString filter_of(const raster::Format& format) {
  return QStringLiteral("%1 (*.%2)").arg(text_of(format.name), ending_of(format));
}

const raster::Format& kind_of(const QString& filter) {
  const auto all = kinds();
  const auto found = std::ranges::find_if(all, [&](const raster::Format* kind) { return filter_of(*kind) == filter; });
  return found == all.end() ? *all.front() : **found;
}

}  // namespace

std::optional<ExportChoice> ask_export(QWidget* parent) {
  QStringList filters;
  for (const raster::Format* kind : kinds()) filters << filter_of(*kind);
  // The dialog adds the ending itself, so that it asks about the file that is really written.
  QFileDialog dialog(parent, QFileDialog::tr("Export samples"));
  dialog.setObjectName("export_dialog");
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(filters);
  dialog.setDefaultSuffix(ending_of(kind_of(dialog.selectedNameFilter())));
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                   [&](const QString& filter) { dialog.setDefaultSuffix(ending_of(kind_of(filter))); });
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  const QString path = dialog.selectedFiles().value(0);
  if (path.isEmpty()) return std::nullopt;
  const auto typed = raster::format_from_path(path.toStdString());
  return ExportChoice{path, typed.value_or(kind_of(dialog.selectedNameFilter()).recording.value())};
}

}  // namespace sarsim::gui
