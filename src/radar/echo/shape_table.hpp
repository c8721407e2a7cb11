#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "radar/echo/pulse_pieces.hpp"
#include "radar/echo/reference_kernel.hpp"

namespace sarsim::radar {

/// Where consecutive samples of an echo stand in the shape of the pulse.
struct ShapePlace {
  double delay_s = 0.0;
  PulseClock clock;
  std::size_t sample = 0;  ///< The first one in the row.
  std::size_t count = 0;   ///< As many as stay in the same part of their cells.
  std::size_t cell = 0;    ///< That of the first sample; each further sample stands in the next one.
  std::size_t part = 0;    ///< Of the cell, the same for all samples.
  double y = 0.0;          ///< Place of the first sample in the part, -1 to 1,
  double y_step = 0.0;     ///< and what it changes by from sample to sample, as the echo is stretched.
  double position = 0.0;   ///< Of the first sample, sampling intervals after the origin of the table,
  double drift = 0.0;      ///< and by how much more than one it grows from sample to sample.
};

/// The shape of a pulse, what multiplies the tone of an echo, for SIMD: the samples of an echo are one interval apart,
/// so that all of them stand at the same place within their cells of one interval. Each cell is divided into a few
/// parts, and in each part the shape is a polynomial of the place. The coefficients of a degree lie one after the other
/// for consecutive cells, 16 at a time.
///
/// A cell where the shape jumps or bends has a patch: it is evaluated on its own from the pieces of the pulse.
class ShapeTable {
 public:
  static constexpr std::size_t cells_per_block = 16;
  template <class T>
  struct alignas(64) Block {
    T value[cells_per_block] = {};
  };

  /// Shape of an echo: the envelope of a hard-edged pulse, a gain; I and Q of a user-defined pulse; a band-limited
  /// pulse with its sweep. Within 1e-7 (single precision) or 1e-11 of the largest magnitude. Keeps a reference to the
  /// pulse.
  ShapeTable(const EchoPulse& pulse, const SampleGrid& grid, bool single_precision);

  /// Whether a table takes at most 32 MB; otherwise none is made.
  [[nodiscard]] static bool is_worth_making(const EchoPulse& pulse, const SampleGrid& grid, bool single_precision);
  /// False where none was made: the table is empty then.
  [[nodiscard]] bool is_usable() const { return cells_ > 0; }
  [[nodiscard]] bool is_complex() const { return complex_; }
  [[nodiscard]] bool is_single_precision() const { return single_precision_; }
  [[nodiscard]] std::size_t degree() const { return degree_; }
  [[nodiscard]] std::size_t parts() const { return parts_; }
  [[nodiscard]] std::size_t cells() const { return cells_; }

  /// Where samples of the row stand in an echo with this delay and stretch, which touches them all: of those from
  /// `span.begin` on that share a part, at least one.
  [[nodiscard]] ShapePlace place(const SampleSpan& span, double delay_s, const PulseClock& clock) const;

  /// Coefficients from the block of cells on that holds `cell`: for each block the real parts by ascending degree,
  /// then, if complex, the imaginary parts.
  template <class T>
  [[nodiscard]] const Block<T>* coefficients(std::size_t part, std::size_t cell) const {
    if constexpr (sizeof(T) == 4)
      return single_.data() + block_index(part, cell);
    else
      return double_.data() + block_index(part, cell);
  }

  /// Overwrites values of samples in cells with a patch; re[0] and im[0] belong to cell `first_cell`.
  template <class T>
  void patch(const ShapePlace& place, std::size_t first_cell, T* re, T* im) const;

  /// A run of cells where the shape is one real number.
  struct Constant {
    double gain = 0.0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  /// The longest one; empty if it is short.
  [[nodiscard]] const Constant& constant() const { return constant_; }

 private:
  struct Fits;
  [[nodiscard]] std::size_t block_index(std::size_t part, std::size_t cell) const {
    return (part * cells_ + cell) / cells_per_block * (complex_ ? 2 : 1) * (degree_ + 1);
  }
  struct Patch {
    std::size_t cell;
    std::size_t first_piece;
    std::size_t last_piece;
  };
  // The end of a band-limited pulse that was cut, within a part of a cell.
  struct Tail {
    std::size_t part = 0;
    std::size_t cell = 0;
    double begin = 0.0;
    double end = 0.0;
    FitTerms powers{};
  };
  void follow_stretch(double u_s, ShapePlace& place) const;
  void tabulate_pieces();
  [[nodiscard]] bool fits_pieces(const Patch& patch, const FitTerms& powers, double tolerance) const;
  void choose_degree(const Fits& fits);
  void find_constant(const Fits& fits);
  void tabulate_band_limited();
  [[nodiscard]] Fits fit_band_limited(std::size_t parts, double tolerance) const;
  void fit_tail(double tolerance);
  template <class T>
  void store(const Fits& fits, std::vector<Block<T>>& blocks) const;
  [[nodiscard]] std::complex<double> patched(const Patch& patch, const ShapePlace& place) const;

  const EchoPulse* pulse_;
  SampleGrid grid_;
  bool single_precision_;
  bool complex_;
  double origin_s_;
  double last_;  // of the pulse, intervals after the origin
  std::size_t parts_ = 1;
  std::size_t cells_ = 0;
  std::size_t degree_ = 0;
  std::vector<Block<float>> single_;
  std::vector<Block<double>> double_;
  std::optional<PulsePieces> pieces_;
  std::vector<Patch> patches_;
  std::optional<Tail> tail_;
  Constant constant_;
};

}  // namespace sarsim::radar
