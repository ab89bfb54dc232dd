#include "widgets.hpp"

#include <QAccessible>
#include <QAccessibleInterface>
#include <QDir>
#include <QFile>

#include "gui/look/paths.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/problem.hpp"
#include "problems/vibration/law_problem_cases.hpp"

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

namespace {

std::filesystem::path write_problem(const std::string& name, const QTemporaryDir& folder, const char* format) {
  const problems::WriteOptions options{.format = format};
  const std::filesystem::path path = as_path(folder.path());
  if (problems::is_coupling(name)) return problems::write(problems::make_coupling(name), path, options);
  if (problems::is_law_problem(name)) return problems::write(problems::make_law_problem(name), path, options);
  return problems::write(problems::make(name), path, options);
}

}  // namespace

Measured::Measured(const char* problem, const char* format) : scene_(as_name(write_problem(problem, folder_, format))) {}

QStringList Measured::files() const {
  QStringList all;
  const QDir folder(folder_.path());
  for (const QString& name : folder.entryList({"*.h5", "*.uff"}, QDir::Files, QDir::Name)) all << folder.filePath(name);
  return all;
}

}  // namespace jointid::gui
