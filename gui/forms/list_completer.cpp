#include "gui/forms/list_completer.hpp"

#include <QAbstractItemView>
#include <QLineEdit>
#include <QStringListModel>

#include "gui/look/named.hpp"

namespace jointid::gui {
namespace {

/// Behind the last comma and the blanks after it.
qsizetype begin_of_last(const QString& text) {
  qsizetype at = text.lastIndexOf(',') + 1;
  while (at < text.size() && text[at] == ' ') ++at;
  return at;
}

}  // namespace

ListCompleter::ListCompleter(QLineEdit& line, const QString& accessible_name) : QCompleter(&line), line_(line) {
  words_ = new QStringListModel(this);
  setModel(words_);
  setCaseSensitivity(Qt::CaseInsensitive);
  named(popup(), "list_completions", accessible_name);
}

void ListCompleter::set_words(const QStringList& words) { words_->setStringList(words); }

QStringList ListCompleter::splitPath(const QString& path) const { return {path.mid(begin_of_last(path))}; }

QString ListCompleter::pathFromIndex(const QModelIndex& index) const {
  const QString text = line_.text();
  return text.left(begin_of_last(text)) + index.data().toString();
}

}  // namespace jointid::gui
