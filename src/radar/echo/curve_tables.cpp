#include "radar/echo/curve_tables.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/hash/checksum.hpp"
#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double half_turn_deg = 180.0;
constexpr std::size_t max_terms = 6;
constexpr double rounding = 1e-13;      // of a curve's value, relative to its ordinates
constexpr double shortest_deg = 1e-10;  // pieces below this are not looked at closely
constexpr double margin_deg = 2e-13;    // a few roundings of an angle
constexpr int max_halvings = 10;        // of the distance between two breaks

// What is tabulated over [0, span_deg]: a function of the magnitude of an angle, or one of an angle with its sign,
// which counts from -180 degrees.
struct Source {
  const core::Interpolator* function = nullptr;
  const core::AngleFunction* angles = nullptr;  // of a function that tells -x from x

  [[nodiscard]] double first_deg() const { return angles == nullptr ? 0.0 : -half_turn_deg; }
  [[nodiscard]] double span_deg() const { return angles == nullptr ? half_turn_deg : 2.0 * half_turn_deg; }
  [[nodiscard]] double value(double x) const {
    return angles == nullptr ? function->value(x) : angles->value(x + first_deg());
  }
  [[nodiscard]] const std::vector<core::Knot>& knots() const { return function->knots(); }
};

// A polynomial in (x - centre) on [left, right).
struct Piece {
  double left = 0.0;
  double right = 0.0;
  std::size_t degree = 0;
  std::array<double, max_terms> coefficient{};

  [[nodiscard]] double centre() const { return 0.5 * (left + right); }
  [[nodiscard]] double value(double x) const {
    double sum = 0.0;
    for (std::size_t k = degree + 1; k-- > 0;) sum = sum * (x - centre()) + coefficient[k];
    return sum;
  }
};

// Adds `weight` times the Chebyshev polynomial of order k to the coefficients of powers.
void add_chebyshev(std::size_t k, double weight, std::array<double, max_terms>& powers) {
  std::array<double, max_terms> before{}, now{};
  before[0] = 1.0;
  now[1] = 1.0;
  if (k == 0) now = before;
  for (std::size_t order = 1; order < k; ++order) {
    std::array<double, max_terms> next{};
    for (std::size_t i = 0; i < max_terms; ++i) next[i] = (i > 0 ? 2.0 * now[i - 1] : 0.0) - before[i];
    before = std::exchange(now, next);
  }
  for (std::size_t i = 0; i < max_terms; ++i) powers[i] += weight * now[i];
}

// The polynomial that meets the curve at the nodes of a Chebyshev polynomial, all inside the interval.
Piece interpolant(const Source& curve, double left, double right, std::size_t degree) {
  Piece piece{left, right, degree, {}};
  const double half = 0.5 * (right - left);
  const auto nodes = static_cast<double>(degree + 1);
  std::array<double, max_terms> value{};
  const auto angle = [&](std::size_t j) { return core::pi * (static_cast<double>(j) + 0.5) / nodes; };
  for (std::size_t j = 0; j <= degree; ++j) value[j] = curve.value(piece.centre() + half * std::cos(angle(j)));
  for (std::size_t k = 0; k <= degree; ++k) {
    double sum = 0.0;
    for (std::size_t j = 0; j <= degree; ++j) sum += value[j] * std::cos(static_cast<double>(k) * angle(j));
    add_chebyshev(k, sum * (k == 0 ? 1.0 : 2.0) / nodes, piece.coefficient);
  }
  for (std::size_t k = 0; k <= degree; ++k) piece.coefficient[k] /= std::pow(half, static_cast<double>(k));
  return piece;
}

// Whether a piece is within half of `tolerance_db` where it is likely to be farthest from the curve.
bool close_to(const Source& curve, const Piece& piece, double tolerance_db) {
  if (piece.right - piece.left < shortest_deg) return true;
  const double half = 0.5 * (piece.right - piece.left);
  const auto parts = static_cast<double>(piece.degree + 1);
  for (std::size_t j = 0; j <= piece.degree + 1; ++j) {
    // Not at the ends themselves, which may belong to the neighbours.
    const double x = piece.centre() + 0.999 * half * std::cos(core::pi * static_cast<double>(j) / parts);
    const double value = curve.value(x);
    if (!(std::abs(piece.value(x) - value) <= std::max(0.5 * tolerance_db, rounding * std::abs(value)))) return false;
  }
  return true;
}

// Places of the function itself, as breaks of what is tabulated.
std::vector<double> sorted_breaks(const Source& curve, const std::vector<double>& places) {
  std::vector<double> breaks{0.0, curve.span_deg()};
  const auto add = [&](double x) {
    if (x > 0.0 && x < curve.span_deg()) breaks.push_back(x);
  };
  const bool once = curve.angles == nullptr || curve.angles->goes_round();
  for (const double place : places)
    for (const double turn_deg : {0.0, -2.0 * half_turn_deg, 2.0 * half_turn_deg})
      if (!once || turn_deg == 0.0) add(place + turn_deg - curve.first_deg());
  // Where the gap of a table has its middle, the nearer end changes.
  if (!once)
    for (const double middle_deg : {-half_turn_deg, half_turn_deg})
      add(curve.angles->middle_deg() + middle_deg - curve.first_deg());
  std::ranges::sort(breaks);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

std::vector<double> knot_places(const Source& curve) {
  std::vector<double> places;
  for (const core::Knot& knot : curve.knots()) places.push_back(knot.x);
  return places;
}

// The first number behind a jump that is known to be within rounding of x; x itself where there is none.
double behind_jump(const Source& curve, double x) {
  constexpr int reach = 8;
  double left = x;
  for (int i = 0; i < reach; ++i) left = std::nextafter(left, -half_turn_deg);
  double behind = x;
  double largest = 0.0;
  for (int i = 0; i < 2 * reach; ++i) {
    const double right = std::nextafter(left, 2.0 * half_turn_deg);
    const double jump = std::abs(curve.value(right) - curve.value(left));
    if (jump > largest) {
      largest = jump;
      behind = right;
    }
    left = right;
  }
  return behind;
}

// Where a low-pass curve is not smooth: at its ends, at the points of its grid (LowPassRule::first_knot) and halfway
// between them, where it jumps to the next set of terms (LowPassRule::origin).
std::vector<double> low_pass_breaks(const Source& curve) {
  constexpr double beyond = 12.0;  // steps in which a bare sinc decays to nothing, and one for safety
  std::vector<double> breaks = knot_places(curve);
  const double first = breaks.front();
  const double step = (breaks.back() - first) / static_cast<double>(breaks.size() - 1);
  for (std::size_t i = 0; i < curve.knots().size(); ++i) breaks.push_back(first + static_cast<double>(i) * step);
  if (curve.angles != nullptr) return sorted_breaks(curve, breaks);  // Those have no jumps.
  const double first_jump = std::floor(first / step) - beyond + 0.5;
  const auto jumps = curve.knots().size() + 2 * static_cast<std::size_t>(beyond);
  for (std::size_t i = 0; i <= jumps; ++i) {
    const double x = (first_jump + static_cast<double>(i)) * step;
    if (x > 0.0 && x < half_turn_deg) breaks.push_back(behind_jump(curve, x));
  }
  return sorted_breaks(curve, breaks);
}

void add_pieces(const Source& curve, double left, double right, double tolerance_db, int halvings,
                std::vector<Piece>& pieces) {
  const Piece piece = interpolant(curve, left, right, max_terms - 1);
  if (halvings == 0 || close_to(curve, piece, tolerance_db)) {
    pieces.push_back(piece);
    return;
  }
  add_pieces(curve, left, piece.centre(), tolerance_db, halvings - 1, pieces);
  add_pieces(curve, piece.centre(), right, tolerance_db, halvings - 1, pieces);
}

// A curve that is a straight line or a cubic polynomial between its knots; nothing where it is neither.
std::vector<Piece> exact_pieces(const Source& curve, double tolerance_db) {
  std::vector<Piece> pieces;
  const std::vector<double> breaks = sorted_breaks(curve, knot_places(curve));
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    Piece piece = interpolant(curve, breaks[i], breaks[i + 1], 1);
    if (!close_to(curve, piece, tolerance_db)) piece = interpolant(curve, breaks[i], breaks[i + 1], 3);
    if (!close_to(curve, piece, tolerance_db)) return {};
    pieces.push_back(piece);
  }
  return pieces;
}

std::vector<Piece> pieces_of(const Source& curve, double tolerance_db) {
  std::vector<Piece> pieces = exact_pieces(curve, tolerance_db);
  if (!pieces.empty() || curve.knots().size() < 2) return pieces;
  // The rounding of a sum of sincs goes with the largest of its ordinates.
  double largest = 0.0;
  for (const core::Knot& knot : curve.knots()) largest = std::max(largest, std::abs(knot.y));
  const double error_db = std::max(tolerance_db, rounding * largest);
  const std::vector<double> breaks = low_pass_breaks(curve);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    add_pieces(curve, breaks[i], breaks[i + 1], error_db, max_halvings, pieces);
  return pieces;
}

// Pieces over 0 to 180 degrees of a function that does not tell -x from x, over -180 to 180 degrees.
std::vector<Piece> mirrored(const std::vector<Piece>& pieces) {
  std::vector<Piece> both;
  for (std::size_t i = pieces.size(); i-- > 0;) {
    Piece left = pieces[i];
    left.left = half_turn_deg - pieces[i].right;
    left.right = half_turn_deg - pieces[i].left;
    for (std::size_t k = 1; k < max_terms; k += 2) left.coefficient[k] = -left.coefficient[k];
    both.push_back(left);
  }
  for (Piece right : pieces) {
    right.left += half_turn_deg;
    right.right += half_turn_deg;
    both.push_back(right);
  }
  return both;
}

bool finite(const std::vector<Piece>& pieces) {
  return !pieces.empty() && std::ranges::all_of(pieces, [](const Piece& piece) {
    return std::ranges::all_of(piece.coefficient, [](double c) { return std::isfinite(c); });
  });
}

using Pieces = std::vector<Piece>;

// The piece that holds x.
std::size_t piece_at(const Pieces& pieces, double x) {
  const auto after = std::ranges::upper_bound(pieces, x, {}, &Piece::left);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - pieces.begin() - 1));
}

double span_of(const Pieces& pieces) { return pieces.back().right; }

// The pieces in a cell. What begins within rounding of a cell's ends is taken to begin there.
struct Cell {
  double centre = 0.0;
  std::size_t first = 0;
  std::size_t last = 0;
};

Cell cell_of(const Pieces& pieces, std::size_t cell, std::size_t cells) {
  const double width = span_of(pieces) / static_cast<double>(cells);
  const double left = static_cast<double>(cell) * width;
  return {left + 0.5 * width, piece_at(pieces, left + margin_deg), piece_at(pieces, left + width - margin_deg)};
}

// The largest number of pieces that begin inside a cell.
std::size_t crowd(const std::vector<Pieces>& tables, std::size_t cells) {
  std::size_t most = 0;
  for (const Pieces& pieces : tables)
    for (std::size_t i = 0; i < cells; ++i) {
      const Cell cell = cell_of(pieces, i, cells);
      most = std::max(most, cell.last - cell.first);
    }
  return most;
}

// Whether all pieces begin where cells do.
bool aligned(const std::vector<Pieces>& tables, std::size_t cells) {
  const double width = span_of(tables.front()) / static_cast<double>(cells);
  return std::ranges::all_of(tables, [&](const Pieces& pieces) {
    return std::ranges::all_of(
        pieces, [&](const Piece& piece) { return std::abs(std::remainder(piece.left, width)) < margin_deg; });
  });
}

// The fewest cells that pieces begin at only, or else as many as it takes to have one piece begin in a cell, within
// reason.
std::size_t cell_count(const std::vector<Pieces>& tables) {
  constexpr std::size_t fewest = 16;
  constexpr std::size_t most = 1024;
  constexpr std::size_t max_in_all = 1U << 18;
  const std::size_t affordable = std::clamp(max_in_all / tables.size(), fewest, most);
  for (std::size_t cells = 1; cells <= affordable; ++cells)
    if (aligned(tables, cells)) return cells;
  std::size_t cells = fewest;
  while (2 * cells <= affordable && crowd(tables, cells) > 1) cells *= 2;
  return cells;
}

double narrowest(const std::vector<Pieces>& tables) {
  double width = span_of(tables.front());
  for (const Pieces& pieces : tables)
    for (const Piece& piece : pieces) width = std::min(width, piece.right - piece.left);
  return width;
}

// Coefficients of the same polynomial in powers of (x - centre).
std::array<double, max_terms> about(const Piece& piece, double centre) {
  std::array<double, max_terms> c = piece.coefficient;
  const double shift = centre - piece.centre();
  for (std::size_t k = 0; k < piece.degree; ++k)
    for (std::size_t i = piece.degree; i-- > k;) c[i] += shift * c[i + 1];
  return c;
}

void add_record(CurveTables& tables, double left, double centre, const std::array<double, max_terms>& coefficients) {
  tables.records.push_back(left);
  tables.records.push_back(centre);
  for (std::size_t k = 0; k <= tables.degree; ++k) tables.records.push_back(coefficients[k]);
}

void add_never(CurveTables& tables) { add_record(tables, std::numeric_limits<double>::infinity(), 0.0, {}); }

// One or two pieces for each cell.
void lay_out_cells(const Pieces& pieces, CurveTables& tables) {
  for (std::size_t i = 0; i < tables.cells; ++i) {
    const Cell cell = cell_of(pieces, i, tables.cells);
    for (std::size_t k = cell.first; k <= cell.last; ++k)
      add_record(tables, pieces[k].left, cell.centre, about(pieces[k], cell.centre));
    if (cell.last - cell.first < tables.first_stride) add_never(tables);
  }
}

// All pieces once, and where those of each cell begin.
void lay_out_crowd(const Pieces& pieces, CurveTables& tables) {
  const std::size_t first = tables.records.size();
  for (std::size_t i = 0; i < tables.cells; ++i)
    tables.cell_record.push_back(
        static_cast<std::int64_t>(first + tables.record_size() * cell_of(pieces, i, tables.cells).first));
  for (const Piece& piece : pieces) add_record(tables, piece.left, piece.centre(), piece.coefficient);
  for (std::size_t i = 0; i < 2 * tables.first_stride; ++i) add_never(tables);
}

void lay_out(const std::vector<Pieces>& all, CurveTables& tables) {
  tables.count = all.size();
  tables.cells = cell_count(all);
  const auto straight = [](const Piece& piece) { return piece.degree == 1; };
  const bool lines = std::ranges::all_of(all, [&](const Pieces& p) { return std::ranges::all_of(p, straight); });
  tables.degree = lines ? 1 : max_terms - 1;
  const std::size_t most = crowd(all, tables.cells);
  tables.first_stride = most > 0 ? std::bit_floor(most) : 0;
  // Powers about the middle of a cell lose digits where a piece is much narrower than the cell.
  tables.crowded = most > 1 || narrowest(all) * static_cast<double>(2 * tables.cells) < tables.span_deg;
  for (const Pieces& pieces : all)
    if (tables.crowded)
      lay_out_crowd(pieces, tables);
    else
      lay_out_cells(pieces, tables);
}

// Whether two curves through the same knots are the same function: of the ways to interpolate, no two agree beside the
// sharpest bend, or, along a straight line, at the ends of the table.
bool same_function(const Source& a, const Source& b) {
  const std::vector<core::Knot>& knots = a.knots();
  if (a.span_deg() != b.span_deg() || knots != b.knots()) return false;
  if (knots.size() < 2) return true;
  if (a.angles != nullptr && (a.angles->goes_round() != b.angles->goes_round())) return false;
  const auto slope = [&](std::size_t i) { return (knots[i + 1].y - knots[i].y) / (knots[i + 1].x - knots[i].x); };
  std::size_t sharpest = 0;
  for (std::size_t i = 1; i + 1 < knots.size(); ++i)
    if (sharpest == 0 || std::abs(slope(i) - slope(i - 1)) > std::abs(slope(sharpest) - slope(sharpest - 1)))
      sharpest = i;
  const double left = knots[sharpest].x;
  const double width = knots[sharpest + 1].x - left;
  return std::ranges::all_of(std::array{left + width / 3.0, left + 0.6 * width, 0.0, half_turn_deg},
                             [&](double x) { return a.function->value(x) == b.function->value(x); });
}

std::size_t hash_of(const std::vector<core::Knot>& knots) {
  core::Checksum sum;
  for (const core::Knot& knot : knots) {
    const std::array point{knot.x + 0.0, knot.y + 0.0};  // 0 and -0 are equal
    sum.add(std::as_bytes(std::span(point)));
  }
  return sum.value();
}

// Tables of sources over [0, span_deg] that begin at first_deg.
CurveTables tables_of(std::span<const Source> curves, double first_deg, double span_deg, double tolerance_db) {
  CORE_EXPECT(tolerance_db > 0.0);
  CurveTables tables;
  tables.first_deg = first_deg;
  tables.span_deg = span_deg;
  std::vector<Pieces> all;
  std::vector<Source> distinct;
  std::unordered_multimap<std::size_t, std::uint32_t> by_hash;
  for (const Source& curve : curves) {
    const std::size_t hash = hash_of(curve.knots());
    const auto [first, last] = by_hash.equal_range(hash);
    const auto found =
        std::find_if(first, last, [&](const auto& entry) { return same_function(distinct[entry.second], curve); });
    if (found != last) {
      tables.number.push_back(found->second);
      continue;
    }
    tables.number.push_back(static_cast<std::uint32_t>(all.size()));
    by_hash.emplace(hash, tables.number.back());
    distinct.push_back(curve);
    Pieces pieces = pieces_of(curve, tolerance_db);
    all.push_back(curve.span_deg() < span_deg ? mirrored(pieces) : std::move(pieces));
    tables.sound = tables.sound && finite(all.back());
  }
  if (tables.sound && !all.empty()) lay_out(all, tables);
  return tables;
}

}  // namespace

CurveTables tabulate(std::span<const core::Interpolator* const> curves, double tolerance_db) {
  CORE_EXPECT(std::ranges::none_of(curves, [](const core::Interpolator* curve) { return curve == nullptr; }));
  std::vector<Source> sources;
  for (const core::Interpolator* curve : curves) sources.push_back({curve, nullptr});
  return tables_of(sources, 0.0, half_turn_deg, tolerance_db);
}

CurveTables tabulate(std::span<const core::AngleFunction* const> curves, double tolerance_db) {
  CORE_EXPECT(std::ranges::none_of(curves, [](const core::AngleFunction* curve) { return curve == nullptr; }));
  std::vector<Source> sources;
  for (const core::AngleFunction* curve : curves)
    sources.push_back({&curve->function(), curve->is_even() ? nullptr : curve});
  const bool is_signed = std::ranges::any_of(sources, [](const Source& source) { return source.angles != nullptr; });
  return is_signed ? tables_of(sources, -half_turn_deg, 2.0 * half_turn_deg, tolerance_db)
                   : tables_of(sources, 0.0, half_turn_deg, tolerance_db);
}

}  // namespace sarsim::radar
