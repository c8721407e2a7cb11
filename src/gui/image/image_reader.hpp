#pragma once

#include <QObject>

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/task/stop.hpp"
#include "gui/image/image_part.hpp"
#include "picture/image/overview.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::gui {

/// What is to be read and painted.
struct PartRequest {
  std::shared_ptr<const raster::Raster> source;
  std::shared_ptr<const picture::Overview> overview;  ///< For peaks of wide spacings; may be null.
  raster::ImageWindow window;
  ImageView seen;
  PartLook look;
};

/// A part that was read and painted.
struct PartResult {
  std::uint64_t request = 0;
  std::shared_ptr<const ImagePart> part;
  PaintedPart painted;
  bool complete = false;  ///< Nothing finer follows.
};

/// Reads and paints parts of images on a thread of its own: at first coarsely, within 30 ms, then as asked. The newest
/// request ends those before it. What was read is painted again, not read again, where only colours change.
class ImageReader : public QObject {
  Q_OBJECT

 public:
  explicit ImageReader(QObject* parent = nullptr);
  ~ImageReader() override;

  /// Asks for a part and returns its number.
  std::uint64_t ask(PartRequest request);
  /// Forgets what was read and asked: the file has changed.
  void forget();

 signals:
  /// Both on the thread of this object, for the newest request only.
  void ready(const sarsim::gui::PartResult& result);
  void failed(const QString& words);  ///< Why samples could not be read.

 private:
  struct Job {
    std::uint64_t number = 0;
    PartRequest request;
    std::shared_ptr<core::StopFlag> stop;
  };
  void work();
  void carry_out(const Job& job);
  void read_peaks(const Job& job, ImagePart& part) const;
  [[nodiscard]] ImagePart read_draft(const Job& job, bool& exact) const;
  [[nodiscard]] ImagePart read(const Job& job) const;
  [[nodiscard]] static core::WorkControl control_of(const Job& job);
  void deliver(const Job& job, const std::shared_ptr<const ImagePart>& part, bool complete);

  std::mutex lock_;  // Of the next five.
  std::condition_variable changed_;
  std::optional<Job> next_;
  std::shared_ptr<core::StopFlag> stop_;  // Of the newest request.
  bool ended_ = false;
  bool forgotten_ = false;
  std::uint64_t newest_ = 0;               // On the thread of this object.
  std::shared_ptr<const ImagePart> kept_;  // On the reading thread, as the next two.
  std::shared_ptr<const raster::Raster> kept_source_;
  bool kept_peak_ = false;
  std::thread thread_;  // Last: uses everything above.
};

}  // namespace sarsim::gui
