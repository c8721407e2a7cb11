#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "simulate/run/run.hpp"

namespace sarsim::workflow {

/// Which share of each recording is made, and how it is kept.
struct PartChoice {
  /// One of several equal shares of the rows.
  struct Share {
    std::int64_t number = 1;  ///< From 1.
    std::int64_t count = 1;
  };
  /// Pulses by their numbers within the recording.
  struct Span {
    std::int64_t first = 1;            ///< Pulses from 1.
    std::optional<std::int64_t> last;  ///< Itself included; none: to the end.
  };
  std::optional<Share> share;
  std::optional<Span> span;            ///< Not with a share.
  bool resume = false;                 ///< Go on where an earlier run of it ended.
  bool own_file = false;               ///< Keep the share in a file of its own, to be merged.
  std::optional<double> save_every_s;  ///< From one entry of the journal to the next; none: as the disk allows.

  /// Whether a journal is kept, by which somebody can go on.
  [[nodiscard]] bool journaled() const { return share || span || resume; }
  /// Whether the share holds the first pulse: then it also makes what cannot be shared.
  [[nodiscard]] bool first() const { return share ? share->number == 1 : !span || span->first == 1; }
};

/// The share that "3/8" means, at most a million of them; nothing for another text.
[[nodiscard]] std::optional<PartChoice::Share> share_from(const std::string& text);
/// The pulses that "101:200" means; an end may be left out. Nothing for another text.
[[nodiscard]] std::optional<PartChoice::Span> span_from(const std::string& text);

/// The rows of a recording that are chosen; none where it has not so many. Shares 1 to N are the whole. They differ by
/// one row at most or, where a file holds rows in pieces of which there are as many as shares, by one piece: then no
/// piece belongs to two shares.
[[nodiscard]] raster::RowRange rows_of(const PartChoice& choice, std::size_t rows, std::size_t piece_rows = 1);

/// "3/8", "101:200"; "1/1" for the whole.
[[nodiscard]] std::string words_of(const PartChoice& choice);
/// The same as the beginning of a file's name: "part-3-of-8", "pulses-101-200".
[[nodiscard]] std::string file_name_of(const PartChoice& choice);

}  // namespace sarsim::workflow
