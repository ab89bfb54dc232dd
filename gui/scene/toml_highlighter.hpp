#pragma once

#include <QSyntaxHighlighter>

#include "gui/look/theme.hpp"

namespace jointid::gui {

/// Colours tables, keys, strings, numbers and comments of TOML, line by line.
class TomlHighlighter : public QSyntaxHighlighter {
  Q_OBJECT

 public:
  explicit TomlHighlighter(QTextDocument* document);

  void set_theme(Theme theme);

 protected:
  void highlightBlock(const QString& text) override;

 private:
  Theme theme_ = Theme::light;
};

}  // namespace jointid::gui
