#include "gui/image/image_reader.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace sarsim::gui {

namespace {

constexpr double draft_s = 0.03;

bool wants_peaks(const PartRequest& request) {
  const picture::DisplayQuantity quantity = request.look.quantity;
  return request.look.wants_peaks() &&
         (quantity == picture::DisplayQuantity::magnitude || quantity == picture::DisplayQuantity::decibels) &&
         (request.window.row_step > 1 || request.window.col_step > 1) &&
         request.source->info().value != raster::ImageValue::rgb;
}

}  // namespace

ImageReader::ImageReader(QObject* parent) : QObject(parent) {
  thread_ = std::thread([this] { work(); });
}

ImageReader::~ImageReader() {
  {
    const std::scoped_lock hold(lock_);
    ended_ = true;
    if (stop_) stop_->request();
  }
  changed_.notify_all();
  thread_.join();
}

std::uint64_t ImageReader::ask(PartRequest request) {
  auto stop = std::make_shared<core::StopFlag>();
  {
    const std::scoped_lock hold(lock_);
    if (stop_) stop_->request();
    stop_ = stop;
    next_ = Job{++newest_, std::move(request), std::move(stop)};
  }
  changed_.notify_all();
  return newest_;
}

void ImageReader::forget() {
  const std::scoped_lock hold(lock_);
  ++newest_;
  if (stop_) stop_->request();
  next_.reset();
  forgotten_ = true;
}

void ImageReader::work() {
  for (;;) {
    Job job;
    {
      std::unique_lock hold(lock_);
      changed_.wait(hold, [&] { return ended_ || next_; });
      if (ended_) return;
      job = std::move(*next_);
      next_.reset();
      if (std::exchange(forgotten_, false)) kept_.reset();
    }
    QString failure;
    try {
      carry_out(job);
    } catch (const core::Interrupted&) {
    } catch (const std::bad_alloc&) {
      failure = tr("There is not enough memory for this part of the file.");
    } catch (const std::exception& error) {
      failure = QString::fromUtf8(error.what());
    }
    if (!failure.isEmpty())
      QMetaObject::invokeMethod(
          this,
          [this, failure, number = job.number] {
            if (number == newest_) emit failed(failure);
          },
          Qt::QueuedConnection);
  }
}

void ImageReader::carry_out(const Job& job) {
  const PartRequest& request = job.request;
  const bool peaks = wants_peaks(request);
  const bool same = kept_ && kept_source_ == request.source && kept_->window == request.window && kept_peak_ == peaks;
  if (!same) {
    kept_.reset();
    const bool slow = request.source->read_cost_s(request.window) > draft_s || peaks;
    if (slow && request.source->info().value != raster::ImageValue::rgb) {
      bool exact = false;
      auto draft = std::make_shared<const ImagePart>(read_draft(job, exact));
      exact = exact && !peaks;
      if (exact)
        kept_ = std::move(draft);
      else
        deliver(job, draft, false);
    }
    if (!kept_) kept_ = std::make_shared<const ImagePart>(read(job));
    kept_source_ = request.source;
    kept_peak_ = peaks;
  }
  deliver(job, kept_, true);
}

void ImageReader::read_peaks(const Job& job, ImagePart& part) const {
  const PartRequest& request = job.request;
  // Cells of an overview have sides of powers of two.
  const auto row_log2 = static_cast<unsigned>(std::bit_width(part.window.row_step) - 1);
  const auto col_log2 = static_cast<unsigned>(std::bit_width(part.window.col_step) - 1);
  std::vector<float> cells(part.window.samples());
  const picture::Overview* const overview = request.overview.get();
  const bool by_overview =
      overview != nullptr && std::has_single_bit(part.window.row_step) && std::has_single_bit(part.window.col_step) &&
      row_log2 >= overview->base().row_log2 && col_log2 >= overview->base().col_log2 &&
      (part.window.row0 >> row_log2) + part.window.rows <= overview->level(row_log2, col_log2).rows;
  if (by_overview)
    overview->read(row_log2, col_log2, part.window.row0 >> row_log2, part.window.rows, part.window.col0 >> col_log2,
                   part.window.cols, cells);
  else
    picture::reduce_plane(*request.source, picture::OverviewKind::peak, part.window.row0, part.window.rows,
                          part.window.row_step, part.window.col0, part.window.cols, part.window.col_step, cells,
                          job.stop.get());
  part.samples.assign(cells.begin(), cells.end());
  part.peaks = true;
}

ImagePart ImageReader::read_draft(const Job& job, bool& exact) const {
  const PartRequest& request = job.request;
  std::vector<std::complex<float>> samples(request.window.samples());
  const raster::ImageWindow taken = request.source->read_draft(request.window, draft_s, samples, control_of(job));
  exact = taken == request.window;
  ImagePart part;
  part.window = request.window;
  part.value = request.source->info().value;
  part.samples.assign(samples.begin(), samples.end());
  return part;
}

ImagePart ImageReader::read(const Job& job) const {
  const PartRequest& request = job.request;
  const raster::Raster& source = *request.source;
  ImagePart part;
  part.window = request.window;
  part.value = source.info().value;
  if (wants_peaks(request)) {
    read_peaks(job, part);
    return part;
  }
  std::vector<std::complex<float>> samples(part.window.samples());
  source.read_window(part.window, samples, control_of(job));
  part.samples.assign(samples.begin(), samples.end());
  if (part.value == raster::ImageValue::rgb) {
    part.colours.resize(part.window.samples());
    source.read_rgb(part.window, part.colours, control_of(job));
  }
  return part;
}

core::WorkControl ImageReader::control_of(const Job& job) {
  return {std::min(core::thread_count(0), 4U), job.stop.get()};
}

void ImageReader::deliver(const Job& job, const std::shared_ptr<const ImagePart>& part, bool complete) {
  if (job.stop->requested()) throw core::Interrupted();
  PartResult result{job.number, part, paint(*part, job.request.look, job.request.seen), complete};
  QMetaObject::invokeMethod(
      this,
      [this, result = std::move(result)] {
        if (result.request == newest_) emit ready(result);
      },
      Qt::QueuedConnection);
}

}  // namespace sarsim::gui
