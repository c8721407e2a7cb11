#pragma once

#include <QDialog>
#include <QImage>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

#include "gui/common/latest_only_work.hpp"
#include "raster/format/open_raster.hpp"
#include "scene/model/scene.hpp"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace sarsim::gui {

class ProblemLine;
struct FilePreview;
struct FoundOut;

/// Which file is to be looked at and how it is stored: by itself, one of Sarsim's formats, or described by hand with
/// guesses to choose from. A preview shows what comes of it.
class OpenImageDialog : public QDialog {
  Q_OBJECT

 public:
  explicit OpenImageDialog(QWidget* parent = nullptr);
  ~OpenImageDialog() override;

  /// The scene that knows shape and bits of the files its simulations write.
  void set_scene(const scene::Scene& scene) { scene_ = scene; }
  /// Looks at a file, at first as it is said to be stored.
  void show_file(const QString& path, const raster::RasterHints& hints);
  /// The file that is named.
  [[nodiscard]] QString path() const;
  /// How it is said to be stored.
  [[nodiscard]] raster::RasterHints hints() const;
  /// Guesses for the file, likeliest first.
  [[nodiscard]] const std::vector<raster::RawGuess>& guesses() const { return guesses_; }
  /// Whether the preview shows something.
  [[nodiscard]] bool has_preview() const;

 private:
  // Places in the list of kinds: behind the first stand the formats that files do not say themselves.
  static constexpr int by_content = 0;
  [[nodiscard]] int custom_kind() const { return static_cast<int>(described_.size()) + 1; }
  void make_file_row(QFormLayout* form);
  void make_sample_rows(QFormLayout* form);
  void make_raw_rows(QFormLayout* form);
  QLineEdit* add_number(QFormLayout* form, const QString& label, const char* name, const QString& tip);
  [[nodiscard]] std::optional<int> kind_of(const raster::RasterHints& hints) const;
  void find_file();
  void take_file();
  void show_found(bool good, const QString& failure);
  void take_guess(int index);
  void show_layout(const raster::RawLayout& layout);
  [[nodiscard]] raster::RawLayout layout() const;
  void choose();
  void changed();
  void show_rows();
  [[nodiscard]] QStringList objections() const;
  void begin_preview();
  void show_preview(bool good, const QString& failure);
  void show_picture(const QImage& picture, const QString& instead);

  const std::vector<const raster::Format*> described_ = raster::offered_formats(&raster::FormatPlaces::described);
  scene::Scene scene_;
  std::vector<raster::RawGuess> guesses_;
  bool chosen_ = false;  // The user has said how the file is read.
  QFormLayout* form_ = nullptr;
  QLineEdit* path_ = nullptr;
  QComboBox* kind_ = nullptr;
  QLineEdit* columns_ = nullptr;
  QLineEdit* bits_ = nullptr;
  QComboBox* guess_ = nullptr;
  QLineEdit* header_ = nullptr;
  QLineEdit* width_ = nullptr;
  QLineEdit* height_ = nullptr;
  QComboBox* number_ = nullptr;
  QComboBox* value_ = nullptr;
  QLineEdit* offset_ = nullptr;
  QCheckBox* big_endian_ = nullptr;
  QCheckBox* q_first_ = nullptr;
  QLabel* preview_ = nullptr;
  ProblemLine* problems_ = nullptr;
  QPushButton* open_ = nullptr;
  QTimer debounce_;
  std::shared_ptr<FoundOut> found_;
  std::shared_ptr<FilePreview> shown_;
  LatestOnlyWork finding_;
  LatestOnlyWork previewing_;
};

}  // namespace sarsim::gui
