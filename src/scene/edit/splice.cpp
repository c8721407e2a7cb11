#include "scene/edit/splice.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "scene/edit/edit_runs.hpp"
#include "scene/edit/script_values.hpp"
#include "scene/edit/splice_command.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace {

// What becomes of one object of the script, in a list of its kind. New ones have no stretch.
struct Entry {
  std::optional<TextStretch> stands;
  const SharedObject* before = nullptr;  // where replaced
  const SharedObject* after = nullptr;   // where replaced or new
  std::size_t change = 0;                // where new: which change holds it, and where in that
  TextStretch in_change;
};

// Places at which new commands can come.
struct Gap {
  std::size_t at = 0;
  bool behind = true;  // behind a command, rather than before one
  bool spaced = true;  // blank lines stand between commands here
};

class Splicer {
 public:
  Splicer(std::string_view text, const CommandPlaces& places, const DataFileLoader& loader)
      : text_(text), line_end_(line_end_of(text)), loader_(loader), options_(places.of[CommandPlaces::options]) {
    for (const ObjectKind kind : all_object_kinds)
      for (const TextStretch at : places[kind]) list(kind).emplace_back().stands = at;
  }

  Splice make(const Edit& edit) {
    const std::vector<ListChange> changes = list_changes(edit, true);
    for (std::span<const ListChange> rest = changes; !rest.empty();) {
      const std::size_t count = run_length(rest);
      follow(rest.first(count));
      rest = rest.subspan(count);
    }
    for (const TextStretch at : removed_) remove(at);
    for (const ObjectKind kind : written_object_kinds) write_list(kind);
    if (edit.options_before && edit.options_after && *edit.options_before != *edit.options_after)
      write_options(*edit.options_before, *edit.options_after);
    return finish();
  }

 private:
  std::vector<Entry>& list(ObjectKind kind) { return lists_[static_cast<std::size_t>(kind)]; }

  void follow(std::span<const ListChange> run) {
    change_list(
        list(run.front().id.kind), run, [](const Entry&, const ListChange&) { return true; },
        [](Entry& entry, const ListChange& change) {
          if (entry.before == nullptr) entry.before = change.out;
          entry.after = change.in;
        },
        [&](Entry&& entry, const ListChange&) {
          if (entry.stands) removed_.push_back(*entry.stands);
        },
        [](const ListChange& change) {
          Entry entry;
          entry.after = change.in;
          return entry;
        });
  }

  void add(std::size_t at, std::size_t size, std::string after) {
    changes_.push_back({at, std::string(text_.substr(at, size)), std::move(after)});
  }

  // Takes a command away, with the comment about it and the blank line that would be one too many.
  void remove(TextStretch at) {
    const std::size_t begin = lead_begin(text_, at.begin);
    std::size_t end = at.end;
    if (begin != line_begin(text_, begin)) {
      // Something stands before it on its line, whose end stays.
      while (end > begin && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
    } else if (end > 0 && is_first_on_line(text_, end) && blank_line_before(text_, begin)) {
      for (std::size_t next = behind_line(text_, end); next > end; next = behind_line(text_, end)) {
        if (text_.substr(end, next - end).find_first_not_of(" \t\r\n") != std::string_view::npos) break;
        end = next;
      }
    }
    add(begin, end - begin, "");
  }

  void write_list(ObjectKind kind) {
    std::vector<Entry>& entries = list(kind);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Entry& entry = entries[i];
      if (entry.stands) {
        if (entry.after != nullptr && *entry.before != *entry.after)
          replace(*entry.stands, **entry.before, **entry.after);
        continue;
      }
      std::size_t behind = i + 1;
      while (behind < entries.size() && !entries[behind].stands) ++behind;
      insert(kind, i, behind);
      i = behind - 1;
    }
  }

  // Which token of a typed command is which value only its reader knows: it may be of an older dialect, without values
  // that have one today, or with some too many behind the last. Whether a splice is right is therefore asked of the
  // reader; what the object is to be is known already.
  void replace(TextStretch at, const AnyObject& before, const AnyObject& after) {
    const auto is_right = [&](std::string_view command) {
      return only_object(read_command_text(command, loader_).scene) == after;
    };
    append(change_command(text_, at, command_text(before), command_text(after), is_right));
  }

  void append(TextChanges changes) { std::ranges::move(changes, std::back_inserter(changes_)); }

  // Writes the new objects of a list from `first` to before `behind`.
  void insert(ObjectKind kind, std::size_t first, std::size_t behind) {
    std::vector<Entry>& entries = list(kind);
    const Gap gap = gap_for(kind, first, behind);
    std::string block = opening(gap);
    for (std::size_t i = first; i < behind; ++i) {
      if (i > first && gap.spaced) block += line_end_;
      entries[i].change = changes_.size();
      entries[i].in_change.begin = block.size();
      block += detail::with_line_ends(command_text(**entries[i].after), line_end_);
      entries[i].in_change.end = block.size();
    }
    block += closing(gap);
    add(gap.at, 0, std::move(block));
  }

  // Blank lines between a gap's surroundings and what comes into it.
  [[nodiscard]] std::string opening(const Gap& gap) const {
    std::string lines;
    if (gap.at > 0 && !is_first_on_line(text_, gap.at)) lines += line_end_;
    const bool blank = is_first_on_line(text_, gap.at) && blank_line_before(text_, gap.at);
    if (gap.behind && gap.spaced && !blank) lines += line_end_;
    return lines;
  }
  [[nodiscard]] std::string closing(const Gap& gap) const {
    if (!gap.behind) return std::string(line_end_);
    const std::size_t next = text_.find_first_not_of(" \t", gap.at);
    const bool before_text =
        next != std::string_view::npos && text_[next] != '\n' && text_[next] != '\r' && text_[next] != end_of_file_mark;
    return gap.spaced && before_text ? std::string(line_end_) : "";
  }

  [[nodiscard]] Gap gap_for(ObjectKind kind, std::size_t first, std::size_t behind) {
    const std::vector<Entry>& entries = list(kind);
    if (first > 0) return behind_entry(entries, first - 1);
    if (behind < entries.size()) return {lead_begin(text_, entries[behind].stands->begin), false, true};
    return gap_by_kind(kind);
  }

  // Behind a command, spaced as it is from the one before it.
  [[nodiscard]] Gap behind_entry(const std::vector<Entry>& entries, std::size_t i) const {
    Gap gap{entries[i].stands->end, true, true};
    if (i > 0 && entries[i - 1].stands)
      gap.spaced = blank_line_before(text_, lead_begin(text_, entries[i].stands->begin));
    return gap;
  }

  // Where the writer would begin a list: behind the last kind before it that has commands, else before the first one
  // after it, else at the end.
  [[nodiscard]] Gap gap_by_kind(ObjectKind kind) {
    const auto place = std::ranges::find(written_object_kinds, kind);
    for (auto lower = place; lower != written_object_kinds.begin();)
      if (const auto last = last_standing(*--lower)) return {last->end, true, true};
    for (auto higher = place; higher != written_object_kinds.end(); ++higher)
      for (const Entry& entry : list(*higher))
        if (entry.stands) return {lead_begin(text_, entry.stands->begin), false, true};
    return at_end();
  }

  [[nodiscard]] std::optional<TextStretch> last_standing(ObjectKind kind) {
    const std::vector<Entry>& entries = list(kind);
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry)
      if (entry->stands) return entry->stands;
    return std::nullopt;
  }

  [[nodiscard]] Gap at_end() const {
    const std::size_t end = text_.find_last_not_of(end_of_file_mark) + 1;
    return {end, true, true};
  }

  void write_options(const RunOptions& before, const RunOptions& after) {
    const std::string text = command_text(after);
    const auto is_right = [&](std::string_view command) {
      return read_command_text(command, {}).scene.options == after;
    };
    const bool written = !text.empty() && !options_.empty();
    for (std::size_t i = written ? 1 : 0; i < options_.size(); ++i) remove(options_[i]);
    if (written) {
      // With several, what the first says is not what all of them say.
      append(change_command(text_, options_[0], options_.size() == 1 ? command_text(before) : "", text, is_right));
      options_.resize(1);
      return;
    }
    options_.clear();
    if (text.empty()) return;
    Gap gap = at_end();
    for (const ObjectKind kind : written_object_kinds)
      if (const auto last = last_standing(kind)) gap = {last->end, true, true};
    std::string block = opening(gap);
    new_options_ = Entry{};
    new_options_->change = changes_.size();
    new_options_->in_change.begin = block.size();
    block += detail::with_line_ends(text, line_end_);
    new_options_->in_change.end = block.size();
    block += closing(gap);
    add(gap.at, 0, std::move(block));
  }

  // Sorts the changes and finds the places of the commands after them.
  Splice finish() {
    std::vector<std::size_t> order(changes_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {},
                             [&](std::size_t i) { return std::pair(changes_[i].at, !changes_[i].before.empty()); });
    Splice splice;
    std::vector<std::size_t> new_at(changes_.size());
    std::size_t grown = 0;  // modulo 2^n
    for (const std::size_t i : order) {
      new_at[i] = changes_[i].at + grown;
      grown += changes_[i].after.size() - changes_[i].before.size();
      grown_.push_back(grown);
      splice.changes.push_back(std::move(changes_[i]));
    }
    splice.text = apply_changes(text_, splice.changes);
    const auto place_of = [&](const Entry& entry) {
      if (entry.stands) return moved_place(splice, *entry.stands);
      return TextStretch{new_at[entry.change] + entry.in_change.begin, new_at[entry.change] + entry.in_change.end};
    };
    for (const ObjectKind kind : all_object_kinds)
      for (const Entry& entry : list(kind)) splice.places[kind].push_back(place_of(entry));
    std::vector<TextStretch>& options = splice.places.of[CommandPlaces::options];
    for (const TextStretch at : options_) options.push_back(moved_place(splice, at));
    if (new_options_) options.push_back(place_of(*new_options_));
    return splice;
  }

  [[nodiscard]] TextStretch moved_place(const Splice& splice, TextStretch at) const {
    TextStretch moved{moved_begin(splice.changes, at.begin), moved_end(splice.changes, at.end)};
    const char last = splice.text[moved.end - 1];
    if (last == '\n' || last == '\r') return moved;
    // What it shared its line with may have gone, or its line may have got an end.
    const std::size_t next = splice.text.find_first_not_of(" \t", moved.end);
    if (next != std::string::npos && (splice.text[next] == '\n' || splice.text[next] == '\r'))
      moved.end = behind_line(splice.text, next);
    return moved;
  }

  // What comes in at the beginning of a command comes before it, at its end behind it.
  [[nodiscard]] std::size_t moved_begin(const TextChanges& changes, std::size_t at) const {
    const auto behind = std::ranges::partition_point(changes, [&](const TextChange& change) {
      return change.at < at || (change.at == at && change.before.empty());
    });
    return at + grown_before(behind - changes.begin());
  }
  [[nodiscard]] std::size_t moved_end(const TextChanges& changes, std::size_t at) const {
    const auto behind = std::ranges::partition_point(changes, [&](const TextChange& change) { return change.at < at; });
    return at + grown_before(behind - changes.begin());
  }
  [[nodiscard]] std::size_t grown_before(std::ptrdiff_t count) const {
    return count == 0 ? 0 : grown_[static_cast<std::size_t>(count) - 1];
  }

  static constexpr char end_of_file_mark = 0x1A;

  std::string_view text_;
  std::string_view line_end_;
  const DataFileLoader& loader_;
  std::array<std::vector<Entry>, kind_count> lists_;
  std::vector<TextStretch> options_;
  std::optional<Entry> new_options_;
  std::vector<TextStretch> removed_;
  TextChanges changes_;  // in the order in which they were found
  std::vector<std::size_t> grown_;
};

// Puts a new value in the place of an object that an edit leaves behind, also where a later change of it takes that.
void settle(Edit& edit, std::size_t at, const SharedObject& object) {
  std::optional<ObjectId> id = edit.changes[at].id;
  edit.changes[at].after = object;
  for (std::size_t i = at + 1; i < edit.changes.size(); ++i) {
    const ObjectChange& change = edit.changes[i];
    if (change.before && change.id == *id) {
      edit.changes[i].before = object;
      return;
    }
    if (change.id.kind != id->kind || (change.before && change.after)) continue;
    if (!change.before && change.id.index <= id->index) ++id->index;
    if (!change.after && change.id.index < id->index) --id->index;
  }
}

}  // namespace

Splice splice(std::string_view text, const CommandPlaces& places, const Edit& edit, const DataFileLoader& loader) {
  return Splicer(text, places, loader).make(edit);
}

void settle_values(Edit& edit, const DataFileLoader& loader, Language language) {
  for (std::size_t i = 0; i < edit.changes.size(); ++i) {
    if (!edit.changes[i].after) continue;
    const AnyObject object = *edit.changes[i].after;
    AnyObject said = as_script_says(object, loader, language);
    if (!(said == object)) settle(edit, i, std::move(said));
  }
  if (edit.options_after) edit.options_after = as_script_says(*edit.options_after);
}

}  // namespace sarsim::scene
