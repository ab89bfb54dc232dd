#include "gui/look/theme.hpp"

#include <QApplication>
#include <QStyleFactory>
#include <algorithm>
#include <array>
#include <cmath>

namespace jointid::gui {
namespace {

QColor mixed(const QColor& from, const QColor& to, double share) {
  const auto part = [share](int a, int b) { return static_cast<int>(a + share * (b - a)); };
  return {part(from.red(), to.red()), part(from.green(), to.green()), part(from.blue(), to.blue())};
}

QPalette light_palette() {
  QPalette palette(QColor(0xf0f0f0), QColor(0xf4f4f4));
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor(0xf5f7fa));
  palette.setColor(QPalette::Highlight, QColor(0x2563b0));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(0x2563b0));
  palette.setColor(QPalette::PlaceholderText, QColor(0x6b6b6b));
  return palette;
}

QPalette dark_palette() {
  QPalette palette(QColor(0x33363b), QColor(0x2b2d31));
  const QColor text(0xe6e6e6);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    palette.setColor(role, text);
  palette.setColor(QPalette::Base, QColor(0x1f2124));
  palette.setColor(QPalette::AlternateBase, QColor(0x26292d));
  palette.setColor(QPalette::ToolTipBase, QColor(0x33363b));
  palette.setColor(QPalette::Highlight, QColor(0x3d7fd1));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(0x7fb2f0));
  palette.setColor(QPalette::PlaceholderText, QColor(0x9a9a9a));
  return palette;
}

/// setColor() of a role sets it for all groups; afterwards what cannot be used has to look so again.
QPalette with_disabled(QPalette palette, const QColor& weak) {
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, weak);
  return palette;
}

}  // namespace

void apply(Theme theme, QApplication& application) {
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  application.setPalette(theme == Theme::dark ? with_disabled(dark_palette(), QColor(0x808080))
                                              : with_disabled(light_palette(), QColor(0x909090)));
}

Theme theme_of(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128 ? Theme::dark : Theme::light; }

Colours colours(Theme theme) {
  if (theme == Theme::dark) {
    return {QColor(0x1f2124), QColor(0xe6e6e6), QColor(0xa8a8a8), QColor(0x44484e),
            QColor(0xff8a80), QColor(0xf2b84b), QColor(0x7bd88f), QColor(255, 160, 90, 60)};
  }
  return {Qt::white,        QColor(0x1a1a1a), QColor(0x5f5f5f), QColor(0xd9d9d9),
          QColor(0xb3261e), QColor(0x8a5a00), QColor(0x1c7a3a), QColor(230, 110, 20, 50)};
}

QColor curve_colour(Theme theme, int n) {
  static constexpr std::array<QRgb, 8> on_white = {0x1f5fa8, 0xc4451c, 0x2b7a3d, 0x7b3fa0,
                                                   0x8a6100, 0x007c89, 0xa3195b, 0x4a4a4a};
  static constexpr std::array<QRgb, 8> on_black = {0x6cb0ff, 0xff8f5e, 0x77d58a, 0xc79bf0,
                                                   0xe5bd4f, 0x4fd3de, 0xff86b8, 0xc8c8c8};
  const auto place = static_cast<std::size_t>(n) % on_white.size();
  return QColor(theme == Theme::dark ? on_black[place] : on_white[place]);
}

QColor shade(Theme theme, double share) {
  const bool dark = theme == Theme::dark;
  const QColor full = share < 0.0 ? QColor(dark ? 0xff9c66 : 0x96400f) : QColor(dark ? 0x6cb0ff : 0x16457e);
  return mixed(colours(theme).background, full, std::min(1.0, std::abs(share)));
}

QColor text_on(const QColor& background) {
  const double luminance = 0.299 * background.red() + 0.587 * background.green() + 0.114 * background.blue();
  return luminance > 140.0 ? QColor(0x101010) : QColor(0xf5f5f5);
}

}  // namespace jointid::gui
