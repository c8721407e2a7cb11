#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radar/echo/shape_table.hpp"
#include "radar/echo/tones.hpp"

namespace sarsim::radar {

/// Samples of one echo that a shape multiplies: its tones lie within them.
struct ShapedEcho {
  ShapePlace place;
  std::size_t first_tone = 0;
  std::size_t last_tone = 0;  ///< One past.
};

/// Room that `add_shaped_tones` works in; one per thread.
struct ShapeScratch {
  std::vector<ShapeTable::Block<float>> re_single;
  std::vector<ShapeTable::Block<float>> im_single;
  std::vector<ShapeTable::Block<double>> re_double;
  std::vector<ShapeTable::Block<double>> im_double;
};

/// Adds tones times the shape of their pulse to a row in SIMD: as `add_tones`, each sample times the value of the
/// table. Single precision (that of the table): each sample within 5e-7 of its tone's amplitude times the largest
/// magnitude of the shape; double precision: within 1e-11.
void add_shaped_tones(const ShapeTable& table, std::span<const ShapedEcho> echoes, std::span<const Tone> tones,
                      SplitRow& row, ToneScratch& scratch, ShapeScratch& shape);

}  // namespace sarsim::radar
