#pragma once

#include "picture/live/live_request.hpp"
#include "workflow/focus/focus_request.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"
#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/profiles.hpp"

/// What a live image asks of the workflows; the scene is held in memory, and where the result goes is not said.
namespace sarsim::picture {

/// A focused image of echoes that are at hand.
/// @param threads  at least 1
[[nodiscard]] workflow::FocusRequest focus_request_of(const LiveOptions& options, unsigned threads);
/// The scene of a request and its recording.
[[nodiscard]] workflow::RecordingArguments arguments_of(const LiveRequest& request);
[[nodiscard]] workflow::ProfilesRequest profiles_request_of(const LiveRequest& request);
[[nodiscard]] workflow::IsarRequest isar_request_of(const LiveRequest& request);
/// One map: of at most 256 pulses in the middle of the recording. Without detection.
[[nodiscard]] workflow::DopplerRequest doppler_request_of(const LiveRequest& request);
/// Without detection.
[[nodiscard]] workflow::SearchRequest search_request_of(const LiveRequest& request);

/// The words after "sarsim" of the command that makes the same: "focus scene.toml --algorithm omega-k".
/// @param script  name of the scene's file
[[nodiscard]] std::string live_command(const LiveRequest& request, const std::string& script);

}  // namespace sarsim::picture
