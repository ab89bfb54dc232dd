#include "widgets.hpp"

#include <QAccessible>
#include <QAccessibleInterface>
#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>

#include "gui/look/language.hpp"
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

void move_mouse(QWidget* widget, const QPoint& to) {
  QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}

bool drop(QWidget& on, const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& file : files) urls << QUrl::fromLocalFile(file);
  data.setUrls(urls);
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&on, &enter);
  QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&on, &event);
  return enter.isAccepted();
}

void Spoken::speak(const char* language) {
  choose_language(QString::fromLatin1(language));
  use_language();
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

/// Those datasets of a universal file whose number is, or is not, that of nodes.
std::string datasets(const std::string& text, bool of_nodes) {
  const std::string bar = "    -1\n";
  std::string out;
  for (std::size_t begin = text.find(bar); begin != std::string::npos;) {
    const std::size_t end = text.find(bar, begin + bar.size());
    if (end == std::string::npos) break;
    const std::string dataset = text.substr(begin, end + bar.size() - begin);
    const int number = std::stoi(dataset.substr(bar.size(), 6));
    if ((number == 15 || number == 2411) == of_nodes) out += dataset;
    begin = text.find(bar, end + bar.size());
  }
  return out;
}

}  // namespace

QStringList without_positions(const QStringList& files, const QTemporaryDir& folder) {
  QStringList out;
  for (const QString& file : files) {
    out << folder.filePath(QFileInfo(file).fileName());
    write_file(out.back(), datasets(read_file(file), false));
  }
  return out;
}

std::string only_positions(const QString& file) { return datasets(read_file(file), true); }

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
