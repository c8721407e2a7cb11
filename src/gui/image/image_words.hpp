#pragma once

#include <QCoreApplication>
#include <QString>

#include <optional>

#include "gui/image/image_part.hpp"
#include "picture/image/point_reading.hpp"
#include "picture/image/selection_statistics.hpp"
#include "raster/table/raster.hpp"

namespace sarsim::gui {

class ImagePlot;
struct SamplePlace;

/// Six digits and a unit, if there is one.
[[nodiscard]] QString number_text(double value, const QString& unit = {});

/// What is said of the samples of an image: of one, of two, of many, of a point.
struct ImageWords {
  Q_DECLARE_TR_FUNCTIONS(ImageWords)

 public:
  const raster::Raster* source;  ///< Null where there is none.
  const std::optional<raster::RasterAxes>& axes;
  const PartLook& look;
  bool focused;  ///< The file says by which algorithm it was made.

  /// "V" where the samples are volts.
  [[nodiscard]] QString value_unit() const;
  /// Of what is drawn.
  [[nodiscard]] QString unit() const;
  /// Of levels.
  [[nodiscard]] QString decibel_unit() const;
  /// Of the sample next to a place; empty where none was read.
  [[nodiscard]] QString at(const ImagePlot& plot, SamplePlace place) const;
  /// From the first cursor to the second; empty where there are not both.
  [[nodiscard]] QString difference(const ImagePlot& plot) const;
  /// What is measured of what is drawn, what it has to be multiplied by, and its unit then.
  /// @{
  [[nodiscard]] picture::SampleQuantity measured_quantity() const;
  [[nodiscard]] double measured_scale() const;
  [[nodiscard]] QString measured_unit() const;
  /// @}
  /// @param selected  whether these are selected samples, and not all in view
  [[nodiscard]] QString of_selection(const picture::SelectionStatistics& statistics, bool selected) const;
  /// What was measured of the response of a point.
  [[nodiscard]] QString of_point(const picture::PointReading& r) const;
};

}  // namespace sarsim::gui
