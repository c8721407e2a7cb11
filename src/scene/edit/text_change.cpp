#include "scene/edit/text_change.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <stdexcept>

namespace sarsim::scene {

namespace {

void append_change(std::string& result, std::string_view text, std::size_t& position, std::size_t at,
                   std::string_view out, std::string_view in) {
  if (at < position || at > text.size() || text.substr(at, out.size()) != out)
    throw std::logic_error("text change: the text is not the one that the change was made for");
  result += text.substr(position, at - position);
  result += in;
  position = at + out.size();
}

// A stretch of the text between two sets of changes, made by the first or taken away by the second.
struct Piece {
  std::size_t begin;
  std::size_t end;
  const TextChange* change;
  bool of_first;
};

std::vector<Piece> pieces_of(const TextChanges& first, const TextChanges& second) {
  std::vector<Piece> firsts;
  std::vector<Piece> seconds;
  std::size_t grown = 0;  // modulo 2^n, as a difference may be negative
  for (const TextChange& change : first) {
    const std::size_t begin = change.at + grown;
    firsts.push_back({begin, begin + change.after.size(), &change, true});
    grown += change.after.size() - change.before.size();
  }
  for (const TextChange& change : second)
    seconds.push_back({change.at, change.at + change.before.size(), &change, false});
  std::vector<Piece> pieces;
  std::ranges::merge(firsts, seconds, std::back_inserter(pieces), {}, &Piece::begin, &Piece::begin);
  return pieces;
}

// The text between the two sets of changes that some touching pieces cover.
std::string text_between(std::span<const Piece> pieces, std::size_t begin, std::size_t end) {
  std::string text(end - begin, ' ');
  for (const Piece& piece : pieces)
    text.replace(piece.begin - begin, piece.end - piece.begin,
                 piece.of_first ? piece.change->after : piece.change->before);
  return text;
}

// That text with one set's stretches in the form that they have on its far side.
std::string text_beyond(std::span<const Piece> pieces, std::string_view between, std::size_t begin, bool of_first) {
  std::string text;
  std::size_t position = 0;
  for (const Piece& piece : pieces) {
    if (piece.of_first != of_first) continue;
    text += between.substr(position, piece.begin - begin - position);
    text += of_first ? piece.change->before : piece.change->after;
    position = piece.end - begin;
  }
  text += between.substr(position);
  return text;
}

}  // namespace

std::string apply_changes(std::string_view text, const TextChanges& changes) {
  std::string result;
  std::size_t position = 0;
  for (const TextChange& change : changes)
    append_change(result, text, position, change.at, change.before, change.after);
  result += text.substr(position);
  return result;
}

std::string revert_changes(std::string_view text, const TextChanges& changes) {
  std::string result;
  std::size_t position = 0;
  std::size_t grown = 0;  // modulo 2^n
  for (const TextChange& change : changes) {
    append_change(result, text, position, change.at + grown, change.after, change.before);
    grown += change.after.size() - change.before.size();
  }
  result += text.substr(position);
  return result;
}

TextChanges composed(const TextChanges& first, const TextChanges& second) {
  const std::vector<Piece> pieces = pieces_of(first, second);
  TextChanges result;
  std::size_t grown = 0;  // by the first set so far, modulo 2^n
  for (std::size_t i = 0; i < pieces.size();) {
    const std::size_t begin = pieces[i].begin;
    std::size_t end = pieces[i].end;
    std::size_t behind = i + 1;
    for (; behind < pieces.size() && pieces[behind].begin <= end; ++behind) end = std::max(end, pieces[behind].end);
    const auto together = std::span(pieces).subspan(i, behind - i);
    const std::string between = text_between(together, begin, end);
    TextChange change{begin - grown, text_beyond(together, between, begin, true),
                      text_beyond(together, between, begin, false)};
    grown += between.size() - change.before.size();
    if (change.before != change.after) result.push_back(std::move(change));
    i = behind;
  }
  return result;
}

TextChanges text_difference(std::string_view from, std::string_view to) {
  if (from == to) return {};
  const auto [from_stop, to_stop] = std::ranges::mismatch(from, to);
  const auto head = static_cast<std::size_t>(from_stop - from.begin());
  const std::string_view from_rest = from.substr(head);
  const std::string_view to_rest = to.substr(head);
  const auto [from_back, to_back] =
      std::mismatch(from_rest.rbegin(), from_rest.rend(), to_rest.rbegin(), to_rest.rend());
  const auto tail = static_cast<std::size_t>(from_back - from_rest.rbegin());
  return {{head, std::string(from_rest.substr(0, from_rest.size() - tail)),
           std::string(to_rest.substr(0, to_rest.size() - tail))}};
}

}  // namespace sarsim::scene
