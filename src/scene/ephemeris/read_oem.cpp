#include <array>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/ephemeris/formats.hpp"
#include "scene/ephemeris/known_words.hpp"
#include "scene/ephemeris/kvn_lines.hpp"
#include "scene/ephemeris/state_collector.hpp"
#include "scene/ephemeris/xml_scan.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr std::array<std::string_view, 12> oem_keys{
    "OBJECT_NAME", "OBJECT_ID",          "CENTER_NAME",       "REF_FRAME", "REF_FRAME_EPOCH", "TIME_SYSTEM",
    "START_TIME",  "USEABLE_START_TIME", "USEABLE_STOP_TIME", "STOP_TIME", "INTERPOLATION",   "INTERPOLATION_DEGREE"};
constexpr std::array<std::string_view, 4> oem_header_keys{"CREATION_DATE", "ORIGINATOR", "MESSAGE_ID",
                                                          "CLASSIFICATION"};

// Makes segments of the metadata and states of a message, whatever its form.
class OemContent {
 public:
  explicit OemContent(const ReaderInput& input) : input_(input), problems_(input.problems) {}

  void begin_metadata(std::string_view at) { metadata_.begin(at); }
  void add_metadata(const KvnLine& line, bool strict) { metadata_.add(line, strict, problems_); }

  void end_metadata() {
    const std::string_view name = metadata_.required("OBJECT_NAME", problems_);
    taken_ = input_.choice.takes(name, metadata_.value("OBJECT_ID"));
    if (!taken_) return;
    EphemerisSegment& segment = collector_.begin_segment(metadata_.at());
    check_centre(metadata_.required("CENTER_NAME", problems_), problems_);
    read_axes();
    collector_.typed_times(read_typed_times(metadata_, file_.scale, problems_));
    segment.usable = read_usable(metadata_, file_.scale, problems_);
    segment.interpolation = read_interpolation_hint(metadata_, "INTERPOLATION", problems_);
    if (file_.object_name.empty()) file_.object_name = name;
  }

  // Whether the states that follow are of the satellite that was chosen.
  [[nodiscard]] bool taken() const { return taken_; }
  [[nodiscard]] bool full() const { return collector_.full(); }

  // A time, three positions in km and three velocities in km/s.
  void add_state(std::span<const std::string_view> cells) {
    EphemerisState state;
    core::Vec3 velocity_mps;
    bool good = read_time(cells[0], "the time of a state", file_.scale, problems_, state.time);
    const std::array<double*, 3> position{&state.position_m.x, &state.position_m.y, &state.position_m.z};
    const std::array<double*, 3> velocity{&velocity_mps.x, &velocity_mps.y, &velocity_mps.z};
    for (std::size_t i = 0; i < 3; ++i)
      good &= read_number(cells[1 + i], "a position", "km", 3, problems_, *position[i]);
    for (std::size_t i = 0; i < 3; ++i)
      good &= read_number(cells[4 + i], "a velocity", "km/s", 3, problems_, *velocity[i]);
    if (!good) return;
    state.velocity_mps = velocity_mps;
    collector_.add(state, cells[0], cells[1]);
  }

  EphemerisFile finish(std::string_view at) {
    if (input_.choice.report(problems_)) collector_.finish(at);
    return std::move(file_);
  }

 private:
  void read_axes() {
    const std::string_view frame_at = metadata_.required("REF_FRAME", problems_);
    const std::string_view scale_at = metadata_.required("TIME_SYSTEM", problems_);
    if (frame_at.empty() || scale_at.empty()) return;
    const std::optional<Frame> frame = read_frame(frame_at, problems_);
    const std::optional<radar::TimeScale> scale = read_scale(scale_at, problems_);
    if (const std::string_view epoch = metadata_.value("REF_FRAME_EPOCH"); !epoch.empty() && frame == Frame::teme)
      problems_.error(epoch, {"TEME of a fixed epoch is not read", core::clipped(epoch),
                              "TEME of date, without "
                              "REF_FRAME_EPOCH",
                              "convert the file to EME2000 with the tool that made it"});
    if (!frame || !scale) return;
    if (axes_known_ && (*frame != file_.frame || *scale != file_.scale))
      problems_.error(frame_at, {"the segments have different frames or time systems",
                                 fmt::format("{} and {}", name_of(*frame), name_of(*scale)),
                                 fmt::format("{} and {}, as before", name_of(file_.frame), name_of(file_.scale)),
                                 "put the segments into separate files"});
    else
      file_.frame = *frame, file_.scale = *scale;
    axes_known_ = true;
  }

  const ReaderInput& input_;
  FileProblems& problems_;
  EphemerisFile file_;
  StateCollector collector_{file_, problems_, "km"};
  KvnBlock metadata_{oem_keys};
  bool taken_ = false;
  bool axes_known_ = false;
};

// Reads a CCSDS 502.0 orbit ephemeris message line by line.
class OemReader {
 public:
  explicit OemReader(const ReaderInput& input) : text_(input.text), problems_(input.problems), content_(input) {}

  EphemerisFile read() {
    KvnLines lines(text_);
    KvnLine line;
    while (!content_.full() && lines.next(line)) {
      take(line);
      last_ = line.line;
    }
    if ((part_ == Part::metadata || part_ == Part::covariance) && !content_.full())
      problems_.error(last_, {"the file ends within a block", core::clipped(last_),
                              part_ == Part::metadata ? "META_STOP" : "COVARIANCE_STOP", "the file may be cut off"});
    return content_.finish(last_);
  }

 private:
  enum class Part { version, header, metadata, states, covariance };

  void take(const KvnLine& line) {
    switch (part_) {
      case Part::version: return take_version(line);
      case Part::header: return take_header(line);
      case Part::metadata: return take_metadata(line);
      case Part::states: return take_state(line);
      case Part::covariance:
        if (line.line == "COVARIANCE_STOP") part_ = Part::states;
    }
  }

  void take_version(const KvnLine& line) {
    static_cast<void>(read_version(line, 3, problems_));
    part_ = Part::header;
    header_.begin(line.line);
  }

  void take_header(const KvnLine& line) {
    if (line.line == "META_START") return begin_metadata(line);
    header_.add(line, line.key.empty(), problems_);
  }

  void begin_metadata(const KvnLine& line) {
    part_ = Part::metadata;
    content_.begin_metadata(line.line);
  }

  void take_metadata(const KvnLine& line) {
    if (line.line == "META_STOP") return end_metadata();
    if (misses_stop(line, problems_)) {
      end_metadata();
      return take_state(line);
    }
    content_.add_metadata(line, line.key.empty());
  }

  void end_metadata() {
    part_ = Part::states;
    content_.end_metadata();
  }

  void take_state(const KvnLine& line) {
    if (line.line == "META_START") return begin_metadata(line);
    if (line.line == "COVARIANCE_START") {
      part_ = Part::covariance;
      return;
    }
    if (!content_.taken()) return;
    std::array<std::string_view, 10> cells;
    const std::size_t count = split_words(line.line, cells);
    if (!line.key.empty() || (count != 7 && count != 10)) {
      if (!problems_.again(odd_line_))
        odd_line_ = problems_.error(
            line.line,
            {"the line is not a state", core::clipped(line.line),
             "a time, 3 positions in km, 3 velocities in km/s and, where there are any, 3 accelerations", ""});
      return;
    }
    content_.add_state(cells);
  }

  std::string_view text_;
  FileProblems& problems_;
  OemContent content_;
  KvnBlock header_{oem_header_keys};
  Part part_ = Part::version;
  std::string_view last_;
  FileProblems::Mark odd_line_ = 0;
};

// The same message in XML (CCSDS 505.0).
class OemXmlReader {
 public:
  explicit OemXmlReader(const ReaderInput& input)
      : problems_(input.problems), content_(input), scan_(input.text, input.problems) {}

  EphemerisFile read() {
    while (!content_.full()) {
      const XmlEvent event = scan_.next();
      if (event == XmlEvent::end) break;
      take(event);
    }
    return content_.finish({});
  }

 private:
  static constexpr std::array<std::string_view, 7> state_names{"EPOCH", "X", "Y", "Z", "X_DOT", "Y_DOT", "Z_DOT"};

  void take(XmlEvent event) {
    const std::string_view name = scan_.name();
    if (event == XmlEvent::open) return open(name);
    if (event == XmlEvent::close && name == "metadata") {
      in_metadata_ = false;
      content_.end_metadata();
    } else if (event == XmlEvent::close && name == "stateVector") {
      end_state();
    } else if (event == XmlEvent::text && in_metadata_ && name != "COMMENT") {
      content_.add_metadata({scan_.text(), name, scan_.text(), {}}, false);
    } else if (event == XmlEvent::text && in_state_) {
      for (std::size_t i = 0; i < state_names.size(); ++i) {
        if (name != state_names[i]) continue;
        if (!cells_[i].empty())
          problems_.error(scan_.text(), {fmt::format("{} appears twice in one stateVector", name),
                                         core::clipped(scan_.text()), "each once", ""});
        cells_[i] = scan_.text();
      }
    }
  }

  void open(std::string_view name) {
    if (name == "oem") {
      const std::string_view version = scan_.attribute("version");
      if (!version.empty()) static_cast<void>(read_version({version, {}, version, {}}, 3, problems_));
    } else if (name == "metadata") {
      in_metadata_ = true;
      content_.begin_metadata(name);
    } else if (name == "stateVector") {
      in_state_ = true;
      at_ = name;
      cells_.fill({});
    } else if (in_state_) {
      check_unit(name);
    }
  }

  void check_unit(std::string_view name) {
    const std::string_view unit = scan_.attribute("units");
    for (std::size_t i = 1; i < state_names.size(); ++i)
      if (name == state_names[i] && !unit.empty() && unit != (i < 4 ? "km" : "km/s"))
        problems_.error(unit, {fmt::format("{} has another unit than it should", name), core::clipped(unit),
                               i < 4 ? "km" : "km/s", "convert the numbers"});
  }

  void end_state() {
    in_state_ = false;
    std::string missing;
    for (std::size_t i = 0; i < state_names.size(); ++i)
      if (cells_[i].empty()) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", state_names[i]);
    if (!missing.empty())
      problems_.error(at_, {missing + " is missing in a stateVector", "", "EPOCH, X, Y, Z, X_DOT, Y_DOT, Z_DOT", ""});
    else if (content_.taken())
      content_.add_state(cells_);
  }

  FileProblems& problems_;
  OemContent content_;
  XmlScan scan_;
  std::array<std::string_view, 7> cells_;
  std::string_view at_;
  bool in_metadata_ = false;
  bool in_state_ = false;
};

}  // namespace

EphemerisFile read_oem(const ReaderInput& input) { return OemReader(input).read(); }

EphemerisFile read_oem_xml(const ReaderInput& input) { return OemXmlReader(input).read(); }

}  // namespace sarsim::scene::ephemeris
