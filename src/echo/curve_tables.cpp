#include "echo/curve_tables.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "base/constants.hpp"

namespace sarsim {

namespace {

constexpr double last_deg = 180.0;
constexpr std::size_t most_terms = 8;
constexpr double rounding = 1e-13;      // of a curve's value, relative to its ordinates
constexpr double shortest_deg = 1e-10;  // pieces below this are not looked at closely
constexpr int most_halvings = 10;       // of the distance between two breaks

// A polynomial in (x - centre) on [left, right).
struct Piece {
  double left = 0.0;
  double right = 0.0;
  std::size_t degree = 0;
  std::array<double, most_terms> coefficient{};

  [[nodiscard]] double centre() const { return 0.5 * (left + right); }
  [[nodiscard]] double value(double x) const {
    double sum = 0.0;
    for (std::size_t k = degree + 1; k-- > 0;) sum = sum * (x - centre()) + coefficient[k];
    return sum;
  }
};

// Adds `weight` times the Chebyshev polynomial of order k to the coefficients of powers.
void add_chebyshev(std::size_t k, double weight, std::array<double, most_terms>& powers) {
  std::array<double, most_terms> before{}, now{};
  before[0] = 1.0;
  now[1] = 1.0;
  if (k == 0) now = before;
  for (std::size_t order = 1; order < k; ++order) {
    std::array<double, most_terms> next{};
    for (std::size_t i = 0; i < most_terms; ++i) next[i] = (i > 0 ? 2.0 * now[i - 1] : 0.0) - before[i];
    before = std::exchange(now, next);
  }
  for (std::size_t i = 0; i < most_terms; ++i) powers[i] += weight * now[i];
}

// The polynomial that meets the curve at the nodes of a Chebyshev polynomial, all inside the interval.
Piece interpolant(const Interpolator& curve, double left, double right, std::size_t degree) {
  Piece piece{left, right, degree, {}};
  const double half = 0.5 * (right - left);
  const auto nodes = static_cast<double>(degree + 1);
  std::array<double, most_terms> value{};
  const auto angle = [&](std::size_t j) { return pi * (static_cast<double>(j) + 0.5) / nodes; };
  for (std::size_t j = 0; j <= degree; ++j) value[j] = curve.value(piece.centre() + half * std::cos(angle(j)));
  for (std::size_t k = 0; k <= degree; ++k) {
    double sum = 0.0;
    for (std::size_t j = 0; j <= degree; ++j) sum += value[j] * std::cos(static_cast<double>(k) * angle(j));
    add_chebyshev(k, sum * (k == 0 ? 1.0 : 2.0) / nodes, piece.coefficient);
  }
  for (std::size_t k = 0; k <= degree; ++k) piece.coefficient[k] /= std::pow(half, static_cast<double>(k));
  return piece;
}

// Whether a piece is as close to the curve as `tolerance_db`, looked at where it is likely to be farthest.
bool close_to(const Interpolator& curve, const Piece& piece, double tolerance_db) {
  if (piece.right - piece.left < shortest_deg) return true;
  const double half = 0.5 * (piece.right - piece.left);
  const auto parts = static_cast<double>(piece.degree + 1);
  for (std::size_t j = 0; j <= piece.degree + 1; ++j) {
    // Not at the ends themselves, which may belong to the neighbours.
    const double x = piece.centre() + 0.999 * half * std::cos(pi * static_cast<double>(j) / parts);
    const double value = curve.value(x);
    if (!(std::abs(piece.value(x) - value) <= std::max(tolerance_db, rounding * std::abs(value)))) return false;
  }
  return true;
}

std::vector<double> sorted_breaks(std::vector<double> breaks) {
  std::erase_if(breaks, [](double x) { return !(x > 0.0 && x < last_deg); });
  breaks.push_back(0.0);
  breaks.push_back(last_deg);
  std::ranges::sort(breaks);
  const auto rest = std::ranges::unique(breaks);
  breaks.erase(rest.begin(), rest.end());
  return breaks;
}

std::vector<double> knot_places(const Interpolator& curve) {
  std::vector<double> places;
  for (const Knot& knot : curve.knots()) places.push_back(knot.x);
  return places;
}

// The first number behind a jump that is known to be within rounding of x; x itself where there is none.
double behind_jump(const Interpolator& curve, double x) {
  constexpr int reach = 8;
  double left = x;
  for (int i = 0; i < reach; ++i) left = std::nextafter(left, -last_deg);
  double behind = x;
  double largest = 0.0;
  for (int i = 0; i < 2 * reach; ++i) {
    const double right = std::nextafter(left, 2.0 * last_deg);
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
std::vector<double> low_pass_breaks(const Interpolator& curve) {
  constexpr double beyond = 12.0;  // steps in which a bare sinc decays to nothing, and one for safety
  std::vector<double> breaks = knot_places(curve);
  const double first = breaks.front();
  const double step = (breaks.back() - first) / static_cast<double>(breaks.size() - 1);
  for (std::size_t i = 0; i < curve.knots().size(); ++i) breaks.push_back(first + static_cast<double>(i) * step);
  const double first_jump = std::floor(first / step) - beyond + 0.5;
  const auto jumps = curve.knots().size() + 2 * static_cast<std::size_t>(beyond);
  for (std::size_t i = 0; i <= jumps; ++i) {
    const double x = (first_jump + static_cast<double>(i)) * step;
    if (x > 0.0 && x < last_deg) breaks.push_back(behind_jump(curve, x));
  }
  return sorted_breaks(std::move(breaks));
}

void add_pieces(const Interpolator& curve, double left, double right, double tolerance_db, int halvings,
                std::vector<Piece>& pieces) {
  const Piece piece = interpolant(curve, left, right, most_terms - 1);
  if (halvings == 0 || close_to(curve, piece, tolerance_db)) {
    pieces.push_back(piece);
    return;
  }
  add_pieces(curve, left, piece.centre(), tolerance_db, halvings - 1, pieces);
  add_pieces(curve, piece.centre(), right, tolerance_db, halvings - 1, pieces);
}

// A curve that is a straight line or a cubic polynomial between its knots; nothing where it is neither.
std::vector<Piece> exact_pieces(const Interpolator& curve, double tolerance_db) {
  std::vector<Piece> pieces;
  const std::vector<double> breaks = sorted_breaks(knot_places(curve));
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    Piece piece = interpolant(curve, breaks[i], breaks[i + 1], 1);
    if (!close_to(curve, piece, tolerance_db)) piece = interpolant(curve, breaks[i], breaks[i + 1], 3);
    if (!close_to(curve, piece, tolerance_db)) return {};
    pieces.push_back(piece);
  }
  return pieces;
}

std::vector<Piece> pieces_of(const Interpolator& curve, double tolerance_db) {
  std::vector<Piece> pieces = exact_pieces(curve, tolerance_db);
  if (!pieces.empty() || curve.knots().size() < 2) return pieces;
  // The rounding of a sum of sincs goes with the largest of its ordinates.
  double largest = 0.0;
  for (const Knot& knot : curve.knots()) largest = std::max(largest, std::abs(knot.y));
  const double error_db = std::max(tolerance_db, rounding * largest);
  const std::vector<double> breaks = low_pass_breaks(curve);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    add_pieces(curve, breaks[i], breaks[i + 1], error_db, most_halvings, pieces);
  return pieces;
}

bool finite(const std::vector<Piece>& pieces) {
  return !pieces.empty() && std::ranges::all_of(pieces, [](const Piece& piece) {
    return std::ranges::all_of(piece.coefficient, [](double c) { return std::isfinite(c); });
  });
}

// Left end of a cell, with a margin for the rounding of an angle's cell.
double cell_left(std::size_t cell, std::size_t cells) {
  return last_deg * static_cast<double>(cell) / static_cast<double>(cells) * (1.0 - 1e-12);
}

// The piece that holds x.
std::size_t piece_at(const std::vector<Piece>& pieces, double x) {
  const auto after = std::ranges::upper_bound(pieces, x, {}, &Piece::left);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - pieces.begin() - 1));
}

// The largest number of pieces that begin inside a cell.
std::size_t crowd(const std::vector<std::vector<Piece>>& tables, std::size_t cells) {
  std::size_t most = 0;
  for (const std::vector<Piece>& pieces : tables)
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const double right =
          cell + 1 < cells ? last_deg * static_cast<double>(cell + 1) / static_cast<double>(cells) : 2.0 * last_deg;
      most = std::max(most, piece_at(pieces, right * (1.0 + 1e-12)) - piece_at(pieces, cell_left(cell, cells)));
    }
  return most;
}

// As many cells as it takes to have one piece begin in a cell, within reason.
std::size_t cell_count(const std::vector<std::vector<Piece>>& tables) {
  constexpr std::size_t fewest = 16;
  constexpr std::size_t most = 1024;
  constexpr std::size_t most_in_all = 1U << 18;
  std::size_t cells = fewest;
  while (cells < most && 2 * cells * tables.size() <= most_in_all && crowd(tables, cells) > 1) cells *= 2;
  return cells;
}

void add_record(CurveTables& tables, const Piece& piece) {
  tables.records.push_back(piece.left);
  tables.records.push_back(piece.centre());
  for (std::size_t k = 0; k <= tables.degree; ++k) tables.records.push_back(piece.coefficient[k]);
}

// Lays the pieces out as records.
void lay_out(const std::vector<std::vector<Piece>>& all, CurveTables& tables) {
  tables.count = all.size();
  tables.cells = cell_count(all);
  for (const std::vector<Piece>& pieces : all)
    for (const Piece& piece : pieces) tables.degree = std::max(tables.degree, piece.degree);
  const std::size_t most = crowd(all, tables.cells);
  tables.first_stride = most > 0 ? std::bit_floor(most) : 0;
  Piece never;
  never.left = never.right = std::numeric_limits<double>::infinity();
  for (const std::vector<Piece>& pieces : all) {
    const std::size_t first = tables.records.size();
    for (std::size_t cell = 0; cell < tables.cells; ++cell)
      tables.cell_record.push_back(
          static_cast<std::int64_t>(first + tables.record_size() * piece_at(pieces, cell_left(cell, tables.cells))));
    for (const Piece& piece : pieces) add_record(tables, piece);
    for (std::size_t i = 0; i < 2 * tables.first_stride; ++i) add_record(tables, never);
  }
}

// Whether two curves through the same knots are the same function: of the ways to interpolate, no two agree beside the
// sharpest bend, or, along a straight line, at the ends of the table.
bool same_function(const Interpolator& a, const Interpolator& b) {
  const std::vector<Knot>& knots = a.knots();
  if (knots != b.knots()) return false;
  if (knots.size() < 2) return true;
  const auto slope = [&](std::size_t i) { return (knots[i + 1].y - knots[i].y) / (knots[i + 1].x - knots[i].x); };
  std::size_t sharpest = 0;
  for (std::size_t i = 1; i + 1 < knots.size(); ++i)
    if (sharpest == 0 || std::abs(slope(i) - slope(i - 1)) > std::abs(slope(sharpest) - slope(sharpest - 1)))
      sharpest = i;
  const double left = knots[sharpest].x;
  const double width = knots[sharpest + 1].x - left;
  return std::ranges::all_of(std::array{left + width / 3.0, left + 0.6 * width, 0.0, last_deg},
                             [&](double x) { return a.value(x) == b.value(x); });
}

std::size_t hash_of(const std::vector<Knot>& knots) {
  std::size_t hash = knots.size();
  for (const Knot& knot : knots)
    for (const double x : {knot.x, knot.y}) hash = (hash ^ std::hash<double>()(x)) * 0x100000001b3U;
  return hash;
}

}  // namespace

CurveTables tabulate(std::span<const Interpolator* const> curves, double tolerance_db) {
  CurveTables tables;
  std::vector<std::vector<Piece>> all;
  std::vector<const Interpolator*> distinct;
  std::unordered_multimap<std::size_t, std::uint32_t> by_hash;
  for (const Interpolator* curve : curves) {
    const std::size_t hash = hash_of(curve->knots());
    const auto [first, last] = by_hash.equal_range(hash);
    const auto found =
        std::find_if(first, last, [&](const auto& entry) { return same_function(*distinct[entry.second], *curve); });
    if (found != last) {
      tables.number.push_back(found->second);
      continue;
    }
    tables.number.push_back(static_cast<std::uint32_t>(all.size()));
    by_hash.emplace(hash, tables.number.back());
    distinct.push_back(curve);
    all.push_back(pieces_of(*curve, tolerance_db));
    tables.sound = tables.sound && finite(all.back());
  }
  if (tables.sound && !all.empty()) lay_out(all, tables);
  return tables;
}

}  // namespace sarsim
