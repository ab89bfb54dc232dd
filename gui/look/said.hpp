#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

namespace jointid::gui {

/// Texts of the workbench outside of a class of Qt: Said::tr("…").
class Said {
  Q_DECLARE_TR_FUNCTIONS(Said)
};

/// A text that stands elsewhere, marked there with QT_TRANSLATE_NOOP("Said", "…").
inline QString said(const char* text) { return Said::tr(text); }

/// A text of the library, as it is.
inline QString q(const std::string& text) { return QString::fromStdString(text); }

}  // namespace jointid::gui
