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

namespace sarsim::scene::ephemeris {

namespace {

constexpr std::array<std::string_view, 12> oem_keys{
    "OBJECT_NAME", "OBJECT_ID",          "CENTER_NAME",       "REF_FRAME", "REF_FRAME_EPOCH", "TIME_SYSTEM",
    "START_TIME",  "USEABLE_START_TIME", "USEABLE_STOP_TIME", "STOP_TIME", "INTERPOLATION",   "INTERPOLATION_DEGREE"};
constexpr std::array<std::string_view, 4> oem_header_keys{"CREATION_DATE", "ORIGINATOR", "MESSAGE_ID",
                                                          "CLASSIFICATION"};

// Reads a CCSDS 502.0 orbit ephemeris message line by line.
class OemReader {
 public:
  explicit OemReader(const ReaderInput& input) : input_(input), problems_(input.problems) {}

  EphemerisFile read() {
    KvnLines lines(input_.text);
    KvnLine line;
    while (!collector_.full() && lines.next(line)) {
      take(line);
      last_ = line.line;
    }
    if ((part_ == Part::metadata || part_ == Part::covariance) && !collector_.full())
      problems_.error(last_, {"the file ends within a block", core::clipped(last_),
                              part_ == Part::metadata ? "META_STOP" : "COVARIANCE_STOP", "the file may be cut off"});
    if (input_.choice.report(problems_)) collector_.finish(last_);
    return std::move(file_);
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
    metadata_.begin(line.line);
  }

  void take_metadata(const KvnLine& line) {
    if (line.line == "META_STOP") return end_metadata();
    if (misses_stop(line, problems_)) {
      end_metadata();
      return take_state(line);
    }
    metadata_.add(line, line.key.empty(), problems_);
  }

  void end_metadata() {
    part_ = Part::states;
    const std::string_view name = metadata_.required("OBJECT_NAME", problems_);
    taken_ = input_.choice.takes(name, metadata_.value("OBJECT_ID"));
    if (!taken_) return;
    EphemerisSegment& segment = collector_.begin_segment(metadata_.at());
    check_centre(metadata_.required("CENTER_NAME", problems_), problems_);
    read_axes();
    segment.usable = read_usable(metadata_, file_.scale, problems_);
    segment.interpolation = read_interpolation_hint(metadata_, "INTERPOLATION", problems_);
    if (file_.object_name.empty()) file_.object_name = name;
  }

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

  void take_state(const KvnLine& line) {
    if (line.line == "META_START") return begin_metadata(line);
    if (line.line == "COVARIANCE_START") {
      part_ = Part::covariance;
      return;
    }
    if (!taken_) return;
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
    read_state(cells);
  }

  void read_state(const std::array<std::string_view, 10>& cells) {
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

  const ReaderInput& input_;
  FileProblems& problems_;
  EphemerisFile file_;
  StateCollector collector_{file_, problems_, "km"};
  KvnBlock header_{oem_header_keys};
  KvnBlock metadata_{oem_keys};
  Part part_ = Part::version;
  std::string_view last_;
  bool taken_ = false;
  bool axes_known_ = false;
  FileProblems::Mark odd_line_ = 0;
};

}  // namespace

EphemerisFile read_oem(const ReaderInput& input) { return OemReader(input).read(); }

}  // namespace sarsim::scene::ephemeris
