#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

namespace jointid::gui {

/// A text of the workbench outside of a class of Qt, to be translated.
inline QString said(const char* text) { return QCoreApplication::translate("jointid", text); }

/// A text of the library, as it is.
inline QString q(const std::string& text) { return QString::fromStdString(text); }

}  // namespace jointid::gui
