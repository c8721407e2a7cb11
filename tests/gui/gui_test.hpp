#pragma once

#include <QTest>

/// The test program of the workbench: each source of this folder adds one test class under the name of its file.
namespace sarsim::test {

/// Runs a test class in the application that stands. Returns how many of its functions failed.
using RunTest = int (*)(int argc, char** argv);

template <typename Test>
int run_test(int argc, char** argv) {
  Test test;
  return QTest::qExec(&test, argc, argv);
}

/// As a global object: adds a test to those that `gui_test NAME` can run, settings of its own included.
struct AddTest {
  AddTest(const char* name, RunTest run);
};

}  // namespace sarsim::test
