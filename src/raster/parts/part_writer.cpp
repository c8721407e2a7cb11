#include "raster/parts/part_writer.hpp"

#include <algorithm>
#include <string>

#include "core/task/clock.hpp"

namespace sarsim::raster {

PartWriter::PartWriter(PlacedRows& rows, core::JournalFile& journal, const RowPlaces& places, const JournalPace& pace)
    : rows_(rows),
      journal_(journal),
      places_(places),
      pace_(pace),
      rows_end_(places.row_bytes > 0 ? 0 : rows.file().size()),
      settled_at_s_(core::now_s()),
      next_settling_s_(settled_at_s_ + pace.seconds) {}

void PartWriter::take(const EncodedRows& block) {
  const std::uint64_t offset = places_.row_bytes > 0 ? places_.of(block.rows.first) : rows_end_;
  rows_.write_at(offset, block.bytes);
  rows_end_ = offset + block.bytes.size();
  if (pending_.empty() || pending_.back().claim.rows.end() != block.rows.first) {
    Pending next;
    next.claim.rows.first = block.rows.first;
    next.claim.offset = offset;
    pending_.push_back(next);
  }
  Pending& last = pending_.back();
  last.claim.rows.count += block.rows.count;
  last.claim.bytes += block.bytes.size();
  last.claim.tally.add(block.tally);
  last.sum.add(block.bytes);
  if (core::now_s() >= next_settling_s_) settle();
}

void PartWriter::settle() {
  if (pending_.empty()) return;
  const double begin_s = core::now_s();
  rows_.sync();
  std::string text;
  for (Pending& pending : pending_) {
    Claim& claim = pending.claim;
    claim.checksum = pending.sum.value();
    // Where several stretches are vouched for together, each has its share of the time.
    claim.seconds = (begin_s - settled_at_s_) / static_cast<double>(pending_.size());
    text += text_of(claim);
    claims_.push_back(claim);
  }
  pending_.clear();
  journal_.add(text);
  settled_at_s_ = core::now_s();
  const double cost_s = settled_at_s_ - begin_s;
  settling_s_ += cost_s;
  const double pause_s = pace_.seconds > 0.0 ? std::max(pace_.seconds, cost_s / pace_.max_share) : 0.0;
  next_settling_s_ = settled_at_s_ + pause_s;
}

}  // namespace sarsim::raster
