#include "widgets.hpp"

#include <QAccessible>
#include <QAccessibleInterface>
#include <QDir>
#include <QFile>

#include "gui/look/paths.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/problem.hpp"

namespace jointid::gui {

QStringList without_accessible_name(QWidget& window) {
  QStringList found;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus) continue;
    QAccessibleInterface* const face = QAccessible::queryAccessibleInterface(widget);
    if (face != nullptr && !face->text(QAccessible::Name).isEmpty()) continue;
    found << QString::fromLatin1(widget->metaObject()->className()) + " " + widget->objectName();
  }
  return found;
}

void write_file(const QString& file, const std::string& text) {
  QFile out(file);
  if (out.open(QIODevice::WriteOnly)) out.write(text.data(), static_cast<qint64>(text.size()));
}

std::string read_file(const QString& file) {
  QFile in(file);
  return in.open(QIODevice::ReadOnly) ? in.readAll().toStdString() : "";
}

Measured::Measured(const char* problem, const char* format)
    : scene_(as_name(problems::is_coupling(problem)
                         ? problems::write(problems::make_coupling(problem), as_path(folder_.path()), {.format = format})
                         : problems::write(problems::make(problem), as_path(folder_.path()), {.format = format}))) {}

QStringList Measured::files() const {
  QStringList all;
  const QDir folder(folder_.path());
  for (const QString& name : folder.entryList({"*.h5", "*.uff"}, QDir::Files, QDir::Name)) all << folder.filePath(name);
  return all;
}

}  // namespace jointid::gui
