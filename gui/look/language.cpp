#include "gui/look/language.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <string_view>

namespace jointid::gui {
namespace {

const QString language_key = QStringLiteral("language");

/// lupdate 6.4 does not see the namespace of `namespace jointid::gui {`: its files say "Project" where Qt asks for
/// "jointid::gui::Project".
class Translator : public QTranslator {
 public:
  QString translate(const char* context, const char* text, const char* comment, int n) const override {
    constexpr std::string_view space = "jointid::gui::";
    const bool own = std::string_view(context).starts_with(space);
    return QTranslator::translate(own ? context + space.size() : context, text, comment, n);
  }
};

QString file_of(const QString& language) { return QStringLiteral(":/i18n/jointid_%1.qm").arg(language); }

}  // namespace

bool has_language(const QString& language) { return language == QLatin1String("en") || QFile::exists(file_of(language)); }

QString language() {
  const QString chosen = QSettings().value(language_key).toString();
  const QString wanted = chosen.isEmpty() ? QLocale::system().name().section('_', 0, 0) : chosen;
  return has_language(wanted) ? wanted : QStringLiteral("en");
}

void choose_language(const QString& language) { QSettings().setValue(language_key, language); }

void use_language() {
  static Translator own;
  static QTranslator of_qt;
  QCoreApplication::removeTranslator(&own);
  QCoreApplication::removeTranslator(&of_qt);
  const QString now = language();
  if (own.load(file_of(now))) QCoreApplication::installTranslator(&own);
  if (now != QLatin1String("en") &&
      of_qt.load(QStringLiteral("qtbase_") + now, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&of_qt);
}

}  // namespace jointid::gui
