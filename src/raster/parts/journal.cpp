#include "raster/parts/journal.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "core/os/journal_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr std::string_view script_name = "script";
constexpr std::array<std::string_view, 3> store_words{"placed", "encoded", "volts"};

// A text of any bytes on one line.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\n' || c == '\r' ? ' ' : c;
  return line;
}

// Words and numbers of a line, one after the other.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  [[nodiscard]] std::string_view next() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }
  bool take(std::uint64_t& value, int base = 10) {
    const auto number = core::parse_whole(next(), base);
    value = number.value_or(0);
    return number.has_value();
  }
  bool take(double& value) {
    const auto number = core::parse_number(next());
    value = number.value_or(0.0);
    return number.has_value();
  }
  bool skip(std::string_view expected) { return next() == expected; }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

std::optional<Claim> claim_of(Words words) {
  Claim c;
  const bool good = words.take(c.rows.first) && words.take(c.rows.count) && words.skip("at") && words.take(c.offset) &&
                    words.skip("bytes") && words.take(c.bytes) && words.skip("sum") && words.take(c.checksum, 16) &&
                    words.skip("seconds") && words.take(c.seconds) && words.skip("peak") &&
                    words.take(c.tally.maximum_v) && words.skip("saturated") && words.take(c.tally.saturated) &&
                    words.skip("zero") && words.take(c.tally.zero) && words.rest().empty();
  constexpr std::size_t most = std::size_t{1} << 62U;
  if (!good || c.rows.count == 0 || c.rows.first > most || c.rows.count > most) return std::nullopt;
  return c;
}

std::optional<RowStore> store_of(std::string_view word) {
  const auto found = std::ranges::find(store_words, word);
  if (found == store_words.end()) return std::nullopt;
  return static_cast<RowStore>(found - store_words.begin());
}

// Takes a journal's lines one by one.
class JournalReader {
 public:
  explicit JournalReader(Journal& journal) : journal_(journal) {}

  bool take(std::string_view line) {
    if (std::exchange(first_, false)) return line == journal_signature;
    Words words(line);
    const std::string_view word = words.next();
    return begun_ ? word == "rows" && take_claim(words) : take_head(word, words);
  }
  [[nodiscard]] bool begun() const { return begun_; }

 private:
  bool take_head(std::string_view word, Words words) {
    JournalHead& head = journal_.head;
    if (word == "part") {
      head.part = words.rest();
    } else if (word == "range") {
      return words.take(head.range.first) && words.take(head.range.count);
    } else if (word == "maker") {
      head.maker = words.rest();
    } else if (word == "store") {
      const auto store = store_of(words.rest());
      head.store = store.value_or(RowStore::placed);
      return store.has_value();
    } else if (word == "is") {
      const std::string_view name = words.next();
      head.identity.emplace_back(name, words.rest());
    } else {
      begun_ = word == "begin";
      return begun_;
    }
    return true;
  }

  bool take_claim(Words words) {
    const auto claim = claim_of(words);
    if (!claim) return false;
    // Keyed by their begin; neither neighbour may reach into the new one.
    const auto next = ends_.lower_bound({claim->rows.first, 0});
    if (next != ends_.end() && next->first < claim->rows.end()) return false;
    if (next != ends_.begin() && std::prev(next)->second > claim->rows.first) return false;
    ends_.insert(next, {claim->rows.first, claim->rows.end()});
    journal_.claims.push_back(*claim);
    return true;
  }

  Journal& journal_;
  bool first_ = true;
  bool begun_ = false;
  std::set<std::pair<std::size_t, std::size_t>> ends_;
};

core::Problem damage(const std::filesystem::path& path, std::size_t line) {
  core::Problem problem = file_problem(path.string(), "the journal is damaged");
  problem.place.line = line;
  problem.hint = "delete this journal: the rows that it lists are then computed again";
  return problem;
}

}  // namespace

std::vector<std::string> differences(const Identity& a, const std::string& here, const Identity& b,
                                     const std::string& there) {
  std::vector<std::string> sentences;
  bool script = false;
  const auto value_in = [](const Identity& identity, const std::string& name) {
    const auto found = std::ranges::find(identity, name, &Identity::value_type::first);
    return found == identity.end() ? std::string("not said") : found->second;
  };
  const auto compare = [&](const std::string& name) {
    const std::string left = value_in(a, name);
    const std::string right = value_in(b, name);
    if (left == right) return;
    if (name == script_name)
      script = true;
    else
      sentences.push_back(fmt::format("{} is {} {}, {} {}", name, left, here, right, there));
  };
  for (const auto& [name, value] : a) compare(name);
  for (const auto& [name, value] : b)
    if (std::ranges::find(a, name, &Identity::value_type::first) == a.end()) compare(name);
  if (script && sentences.empty()) sentences.push_back("the script, or a data file of it, has changed");
  return sentences;
}

bool same_bytes(const Claim& a, const Claim& b) {
  return a.rows == b.rows && a.offset == b.offset && a.bytes == b.bytes && a.checksum == b.checksum;
}

std::size_t Journal::claimed_rows() const {
  std::size_t rows = 0;
  for (const Claim& claim : claims) rows += claim.rows.count;
  return rows;
}

std::string text_of(const JournalHead& head) {
  std::string text = core::sealed_line(std::string(journal_signature));
  text += core::sealed_line("part " + on_one_line(head.part));
  text += core::sealed_line(fmt::format("range {} {}", head.range.first, head.range.count));
  text += core::sealed_line(fmt::format("store {}", store_words[static_cast<std::size_t>(head.store)]));
  text += core::sealed_line("maker " + on_one_line(head.maker));
  for (const auto& [name, value] : head.identity) text += core::sealed_line("is " + name + " " + on_one_line(value));
  return text + core::sealed_line("begin");
}

std::string text_of(const Claim& claim) {
  return core::sealed_line(fmt::format("rows {} {} at {} bytes {} sum {:016x} seconds {} peak {} saturated {} zero {}",
                                       claim.rows.first, claim.rows.count, claim.offset, claim.bytes, claim.checksum,
                                       core::format_number(claim.seconds), core::format_number(claim.tally.maximum_v),
                                       claim.tally.saturated, claim.tally.zero));
}

std::variant<Journal, core::Problem> parse_journal(const std::filesystem::path& path, const std::string& text) {
  Journal journal;
  journal.path = path;
  JournalReader reader(journal);
  const core::JournalLines lines = core::lines_of_journal(text);
  for (std::size_t i = 0; i < lines.whole.size(); ++i) {
    const auto line = core::unsealed_line(lines.whole[i]);
    if (!line || !reader.take(*line)) return damage(path, i + 1);
  }
  if (!reader.begun()) return damage(path, lines.whole.size() + 1);
  journal.bytes = text.size() - lines.cut_off.size();
  return journal;
}

std::variant<Journal, core::Problem> read_journal(const std::filesystem::path& path) try {
  return parse_journal(path, core::read_journal_file(path));
} catch (const core::InvalidRequest& refused) {
  return refused.problems.front();
}

std::filesystem::path rows_file_of(const std::filesystem::path& journal) {
  return std::filesystem::path(journal).replace_extension(".rows");
}

}  // namespace sarsim::raster
