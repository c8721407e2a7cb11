#pragma once

#include <gtest/gtest.h>

#include "scene/script/writer.hpp"
#include "support/test_folder.hpp"
#include "workflow/focus/focus_request.hpp"

namespace sarsim::workflow {

/// Tests of images of a scene: its script in a folder of their own, and the request to focus it.
class FocusOfScript : public testing::Test {
 protected:
  explicit FocusOfScript(const scene::Scene& scene) {
    write(scene);
    request_.input.path = (folder_ / "sar.scr").string();
    request_.threads = 2;
  }

  void write(const scene::Scene& scene) { test::put(folder_ / "sar.scr", scene::write_script(scene)); }

  test::TestFolder folder_;
  FocusRequest request_;
};

}  // namespace sarsim::workflow
