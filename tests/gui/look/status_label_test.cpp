#include "gui/look/status_label.hpp"

#include <gtest/gtest.h>

#include <QApplication>

#include "gui/look/theme.hpp"

namespace jointid::gui {
namespace {

QColor colour_of(const StatusLabel& label) { return label.palette().color(QPalette::WindowText); }

TEST(StatusLabel, HasTheColourOfErrorsInBothThemes) {
  StatusLabel label(QStringLiteral("not readable"));
  label.show();
  label.set_bad(true);
  EXPECT_EQ(colour_of(label), colours(Theme::light).error);
  apply(Theme::dark, *qApp);
  QCoreApplication::processEvents();
  const QColor dark = colour_of(label);
  label.set_bad(false);
  const QColor good = colour_of(label), base = label.palette().color(QPalette::Base);
  apply(Theme::light, *qApp);
  QCoreApplication::processEvents();
  EXPECT_EQ(dark, colours(Theme::dark).error);
  EXPECT_EQ(good, colours(Theme::dark).text);
  EXPECT_EQ(base, colours(Theme::dark).background);
  EXPECT_EQ(colour_of(label), colours(Theme::light).text);
}

}  // namespace
}  // namespace jointid::gui
