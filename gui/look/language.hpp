#pragma once

#include <QString>

namespace jointid::gui {

/// "en" or "de": what the user chose, else what the desktop speaks; English where it speaks neither, and where the workbench was
/// built without translations.
QString language();

/// Kept in the settings; counts from the next use_language() on.
void choose_language(const QString& language);

/// Whether the workbench was built with texts in that language.
bool has_language(const QString& language);

/// All windows made from now on speak language(), Qt's own texts as far as Qt has them.
void use_language();

}  // namespace jointid::gui
