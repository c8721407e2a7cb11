#include "gui/common/export_question.hpp"

#include <QFileDialog>

#include <algorithm>
#include <iterator>

#include "raster/table/formats.hpp"

namespace sarsim::gui {

namespace {

struct ExportKind {
  scene::FileFormat format;
  const char* name;
  const char* ending;
};
constexpr ExportKind kinds[] = {{scene::FileFormat::hdf5, "HDF5", "h5"},
                                {scene::FileFormat::npy, "NumPy", "npy"},
                                {scene::FileFormat::csv, "CSV", "csv"},
                                {scene::FileFormat::binary, "Sarsim BINARY", "bin"},
                                {scene::FileFormat::ascii, "Sarsim ASCII", "asc"},
                                {scene::FileFormat::bracket, "Sarsim BRACKET", "brk"}};

QString filter_of(const ExportKind& kind) { return QStringLiteral("%1 (*.%2)").arg(kind.name, kind.ending); }

const ExportKind& kind_of(const QString& filter) {
  const auto* const found =
      std::ranges::find_if(kinds, [&](const ExportKind& kind) { return filter_of(kind) == filter; });
  return found == std::end(kinds) ? kinds[0] : *found;
}

}  // namespace

std::optional<ExportChoice> ask_export(QWidget* parent) {
  QStringList filters;
  for (const ExportKind& kind : kinds) filters << filter_of(kind);
  // The dialog adds the ending itself, so that it asks about the file that is really written.
  QFileDialog dialog(parent, QFileDialog::tr("Export samples"));
  dialog.setObjectName("export_dialog");
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(filters);
  dialog.setDefaultSuffix(kind_of(dialog.selectedNameFilter()).ending);
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                   [&](const QString& filter) { dialog.setDefaultSuffix(kind_of(filter).ending); });
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  const QString path = dialog.selectedFiles().value(0);
  if (path.isEmpty()) return std::nullopt;
  const auto typed = raster::format_from_path(path.toStdString());
  return ExportChoice{path, typed.value_or(kind_of(dialog.selectedNameFilter()).format)};
}

}  // namespace sarsim::gui
