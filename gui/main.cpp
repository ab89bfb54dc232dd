#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QSettings>
#include <functional>
#include <memory>
#include <utility>

#include "gui/look/language.hpp"
#include "gui/look/said.hpp"
#include "gui/main_window.hpp"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("jointid"));
  QApplication::setApplicationName(QStringLiteral("jointid-workbench"));
  QApplication::setApplicationVersion(QStringLiteral(JOINTID_VERSION));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/jointid-workbench.svg")));
  QApplication::setDesktopFileName(QStringLiteral("jointid-workbench"));
  using jointid::gui::Said;
  jointid::gui::use_language();
  QCommandLineParser parser;
  parser.setApplicationDescription(Said::tr("Identifies joints from measured FRFs"));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("FILES"), Said::tr("scenes, or FRF files for a new scene"),
                               QStringLiteral("[FILES…]"));
  parser.process(application);
  using jointid::gui::MainWindow;
  using jointid::gui::Theme;
  jointid::gui::apply(QSettings().value(QStringLiteral("dark")).toBool() ? Theme::dark : Theme::light, application);
  std::unique_ptr<MainWindow> window;
  const std::function<void(const QStringList&)> begin = [&](const QStringList& files) {
    jointid::gui::use_language();
    const std::unique_ptr<MainWindow> before = std::exchange(window, std::make_unique<MainWindow>());
    QObject::connect(window.get(), &MainWindow::begin_anew, &application, begin, Qt::QueuedConnection);
    window->show();
    if (!files.isEmpty()) window->open(files);
  };
  begin(parser.positionalArguments());
  return QApplication::exec();
}
