#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QSettings>

#include "gui/main_window.hpp"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("jointid"));
  QApplication::setApplicationName(QStringLiteral("jointid-workbench"));
  QApplication::setApplicationVersion(QStringLiteral(JOINTID_VERSION));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/jointid-workbench.svg")));
  QApplication::setDesktopFileName(QStringLiteral("jointid-workbench"));
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Finds joints from measured FRFs"));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("FILES"), QStringLiteral("scenes, or FRF files to make a new scene of"),
                               QStringLiteral("[FILES…]"));
  parser.process(application);
  using jointid::gui::Theme;
  jointid::gui::apply(QSettings().value(QStringLiteral("dark")).toBool() ? Theme::dark : Theme::light, application);
  jointid::gui::MainWindow window;
  window.show();
  if (const QStringList files = parser.positionalArguments(); !files.isEmpty()) window.open(files);
  return QApplication::exec();
}
