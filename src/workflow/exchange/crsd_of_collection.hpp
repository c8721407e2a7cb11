#pragma once

#include "raster/cphd/crsd.hpp"
#include "workflow/exchange/cphd_of_collection.hpp"

namespace sarsim::workflow {

/// Refuses what CRSD cannot say of a recording: pulses that are no chirps, windows that do not begin a whole number of
/// sample periods after one another or that overlap, sampling below 1.1 times the bandwidth.
void expect_receivable(const simulate::Acquisition& acquisition);

/// What the XML of a CRSD file says of a collection; looks at no samples.
/// @param cphd  what CPHD would say of it
[[nodiscard]] raster::CrsdDescription crsd_of(const Collection& collection, const CollectionExtent& extent,
                                              const raster::CphdDescription& cphd);

/// The pulses of a collection with the rows that were recorded after them; each thread has its own.
class ReceivedPulses {
 public:
  /// Keeps a reference.
  explicit ReceivedPulses(const Collection& collection);
  /// The pulse of a row: the row's first sample is taken `window` after the middle of the pulse has left.
  [[nodiscard]] raster::ReceivedPulse pulse_of(std::size_t row);

 private:
  const Collection* collection_;
  CollectionGeometry geometry_;
};

}  // namespace sarsim::workflow
