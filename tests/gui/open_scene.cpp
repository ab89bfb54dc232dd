// open_scene SCENE [solve]: opens a scene in the workbench, off the screen, and tells how long it takes until its files are listed, until
// an FRF is drawn, until nothing is read any more and until it is solved, and the most memory that the process had.

#include <sys/resource.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>

#include "base/stopwatch.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/main_window.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/solve/solve_page.hpp"

namespace jointid::gui {
namespace {

constexpr int longest_ms = 600000;

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void tell(const char* what, double seconds) { std::printf("%-24s %6.2f s, %4.0f MB\n", what, seconds, peak_megabytes()); }

int open_scene(const QString& scene, bool solve) {
  MainWindow window;
  window.show();
  tell("window, without a scene", 0.0);
  const auto begin = Clock::now();
  window.open({scene});
  if (window.current() == nullptr) return 1;
  DataPage& data = *window.current()->data_page();
  const auto wait = [&](const char* what, const std::function<bool()>& condition) {
    const bool came = QTest::qWaitFor(condition, longest_ms);
    tell(what, seconds_since(begin));
    return came;
  };
  const bool all = wait("files listed", [&] { return !data.files().empty(); }) &&
                   wait("an FRF drawn", [&] { return !data.plot()->curves().empty(); }) && wait("at rest", [&] {
                     return !data.is_busy() && !window.current()->geometry_page()->is_busy() &&
                            !window.current()->solve_page()->is_busy();
                   });
  if (!all || !solve) return all ? 0 : 1;
  SolvePage& page = *window.current()->solve_page();
  page.solve();
  return wait("solved and shown", [&] { return !page.runs().empty() && !page.is_busy(); }) ? 0 : 1;
}

}  // namespace
}  // namespace jointid::gui

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QApplication application(argc, argv);
  QApplication::setOrganizationName("jointid");
  QApplication::setApplicationName("open_scene");
  return argc < 2 ? 2 : jointid::gui::open_scene(QString::fromLocal8Bit(argv[1]), argc > 2);
}
