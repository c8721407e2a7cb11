#include <QApplication>
#include <QSettings>
#include <QStandardPaths>

#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "gui/gui_test.hpp"

// gui_test NAME [OPTIONS of QtTest]: one test class, in an application whose settings are its own.

namespace sarsim::test {
namespace {

std::map<std::string, RunTest>& tests() {
  static std::map<std::string, RunTest> all;
  return all;
}

}  // namespace

AddTest::AddTest(const char* name, RunTest run) { tests().emplace(name, run); }

}  // namespace sarsim::test

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  const auto chosen = sarsim::test::tests().find(name);
  if (chosen == sarsim::test::tests().end()) {
    std::fprintf(stderr, "gui_test: '%s' is not a test; the tests are\n", name.c_str());
    for (const auto& [known, run] : sarsim::test::tests()) std::fprintf(stderr, "  %s\n", known.c_str());
    return 2;
  }
  QApplication application(argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  QCoreApplication::setOrganizationName("Sarsim test");
  QCoreApplication::setApplicationName(QString::fromStdString(name));
  QSettings().clear();
  argv[1] = argv[0];
  return chosen->second(argc - 1, argv + 1);
}
