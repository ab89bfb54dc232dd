#include "gui/forms/field.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/forms/field_hints.hpp"
#include "gui/forms/field_text.hpp"
#include "gui/forms/list_completer.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/look/status_label.hpp"

namespace jointid::gui {
namespace {

QStringList as_list(const std::vector<std::string>& words) {
  QStringList list;
  for (const std::string& word : words) list << q(word);
  return list;
}

bool names_files(const std::string& table, const std::string& key) {
  return table == "data" && (key == "substructures" || key == "assembly");
}

QString accessible_name(const std::string& table, const std::string& key) {
  return table.empty() ? q(key) : QStringLiteral("[%1] %2").arg(q(table), q(key));
}

}  // namespace

Field::Field(std::string table, std::string key, std::optional<ValueKind> as_written, QWidget* parent)
    : QWidget(parent),
      table_(std::move(table)),
      key_(std::move(key)),
      kind_(as_written ? *as_written : kind_of(table_, key_)),
      hint_(as_written ? QString() : hint_of(table_, key_)) {
  setObjectName(q(table_ + "." + key_));
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  const bool is_choice = kind_ == ValueKind::word || kind_ == ValueKind::flag;
  row->addWidget(is_choice ? make_choice() : make_line(), 1);
  if (!as_written && names_files(table_, key_)) row->addWidget(make_files_button());
  error_ = named(new StatusLabel, "field_error", tr("Error in %1").arg(accessible_name(table_, key_)));
  error_->set_bad(true);
  error_->setWordWrap(true);
  error_->setTextFormat(Qt::PlainText);
  error_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(row);
  column->addWidget(error_);
  input()->installEventFilter(this);
  input()->setAccessibleDescription(hint_);
}

QWidget* Field::make_line() {
  line_ = named(new QLineEdit, "field_line", accessible_name(table_, key_), hint_);
  line_->setPlaceholderText(hint_);
  if (kind_ == ValueKind::dofs || kind_ == ValueKind::words || kind_ == ValueKind::files) {
    completer_ = new ListCompleter(*line_, tr("Names to choose from"));
    completer_->set_words(as_list(words_of(table_, key_)));
    line_->setCompleter(completer_);
  }
  connect(line_, &QLineEdit::textEdited, this, [this] { pending_ = true; });
  connect(line_, &QLineEdit::editingFinished, this, &Field::commit);
  return line_;
}

QWidget* Field::make_choice() {
  choice_ = named(new QComboBox, "field_choice", accessible_name(table_, key_), hint_);
  choice_->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the form
  choice_->addItem(tr("default"), QString());
  const QStringList words =
      kind_ == ValueKind::flag ? QStringList{QStringLiteral("true"), QStringLiteral("false")} : as_list(words_of(table_, key_));
  for (const QString& word : words) choice_->addItem(word, word);
  connect(choice_, &QComboBox::activated, this, [this] {
    pending_ = true;
    commit();
  });
  return choice_;
}

QWidget* Field::make_files_button() {
  auto* button = named(new QToolButton, "choose_files", tr("Choose files of %1").arg(accessible_name(table_, key_)),
                       tr("Choose files to add"));
  button->setText(QStringLiteral("…"));
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::clicked, this, &Field::choose_files);
  return button;
}

void Field::choose_files() {
  QStringList files;
  if (const QString before = line_->text(); !before.isEmpty()) files << before;
  const QStringList chosen = choose_files_to_open(this);
  for (const QString& file : chosen) files << QDir(folder_).relativeFilePath(file);
  if (chosen.isEmpty() || line_->isReadOnly()) return;
  line_->setText(files.join(QStringLiteral(", ")));
  pending_ = true;
  commit();
}

QWidget* Field::input() const { return line_ != nullptr ? static_cast<QWidget*>(line_) : choice_; }

QString Field::error() const { return error_->text(); }

void Field::offer(ValueKind kind, const QStringList& names) {
  if (kind_ == kind && completer_ != nullptr) completer_->set_words(names);
}

void Field::set_shown(const QString& text, bool locked) {
  if (line_ != nullptr) {
    if (line_->text() != text) {
      line_->setText(text);
      line_->setCursorPosition(0);  // the beginning of what is too long is shown
    }
    line_->setReadOnly(locked);
    return;
  }
  int place = choice_->findData(text);
  if (place < 0) {
    choice_->addItem(text, text);
    place = choice_->count() - 1;
  }
  choice_->setCurrentIndex(place);
  choice_->setEnabled(!locked);
}

void Field::show_value(const std::string& value) {
  if (pending_) return;
  const ShownValue shown = shown_value(kind_, value);
  set_shown(q(shown.text), shown.is_locked);
  input()->setToolTip(shown.is_locked ? tr("This value contains comments. Edit it in the text.") : hint_);
  if (line_ != nullptr) line_->setPlaceholderText(hint_);
}

void Field::lock(const QString& why) {
  set_shown(QString(), true);
  if (line_ != nullptr) line_->setPlaceholderText(why);
  input()->setToolTip(why);
}

void Field::set_error(const QString& error) {
  error_->setText(error);
  error_->setVisible(!error.isEmpty());
}

void Field::commit() {
  if (!pending_) return;
  pending_ = false;
  const QString text = line_ != nullptr ? line_->text() : choice_->currentData().toString();
  Q_EMIT changed(written_value(kind_, text.toStdString()));
}

/// Cells of a spreadsheet become a list or a matrix.
bool Field::paste() {
  const QString cells = QApplication::clipboard()->text();
  if (line_ == nullptr || line_->isReadOnly() || (!cells.contains('\t') && !cells.trimmed().contains('\n'))) return false;
  line_->insert(q(pasted_cells(kind_, cells.toStdString())));
  pending_ = true;
  return true;
}

/// Undo and redo are those of the text, not of the line.
bool Field::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    auto* const key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
    if (event->type() == QEvent::KeyPress && key->matches(QKeySequence::Paste) && paste()) return true;
  }
  if (event->type() == QEvent::Wheel && choice_ != nullptr && !choice_->hasFocus()) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace jointid::gui
