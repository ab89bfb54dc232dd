#include "gui/scene/scene_editor.hpp"

#include <QAbstractItemView>
#include <QCompleter>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStringListModel>
#include <QTextBlock>
#include <algorithm>

#include "gui/look/named.hpp"
#include "gui/look/theme.hpp"
#include "gui/scene/annotated_layout.hpp"
#include "gui/scene/scene_words.hpp"
#include "gui/scene/toml_highlighter.hpp"

namespace jointid::gui {
namespace {

constexpr int settle_ms = 250;
constexpr int letters_before_offering = 1;
constexpr int note_indent = 12;  // pixels

QStringList as_list(const std::vector<std::string>& words) {
  QStringList list;
  for (const std::string& word : words) list << QString::fromStdString(word);
  return list;
}

/// Whether the line is to be the header of one of several tables, [[joints]].
bool begins_with_brackets(const QTextCursor& cursor) { return cursor.block().text().trimmed().startsWith(QLatin1String("[[")); }

std::vector<std::string> headers(bool of_several) {
  std::vector<std::string> tables = all_tables();
  if (of_several) tables.emplace_back("joints");
  std::erase_if(tables, [&](const std::string& table) { return is_of_several(table) != of_several || table.ends_with('*'); });
  return tables;
}

}  // namespace

SceneEditor::SceneEditor(QWidget* parent) : QPlainTextEdit(parent) {
  auto* document = new QTextDocument(this);
  layout_ = new AnnotatedLayout(document);
  document->setDocumentLayout(layout_);
  setDocument(document);
  named(this, "scene_editor", tr("Scene"), tr("The scene as text (TOML). Ctrl+Space lists the valid words."));
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  document->setDefaultFont(font());
  setLineWrapMode(NoWrap);
  setTabChangesFocus(true);
  setAcceptDrops(false);  // files are dropped on the window, wherever
  highlighter_ = new TomlHighlighter(document);
  highlighter_->set_theme(theme_of(palette()));
  completer_ = new QCompleter(new QStringListModel(this), this);
  completer_->setWidget(this);
  completer_->setCaseSensitivity(Qt::CaseInsensitive);
  named(completer_->popup(), "completions", tr("Completions"));
  margin_ = named(new QWidget(this), "line_numbers", tr("Line numbers"));
  margin_->installEventFilter(this);
  settle_.setSingleShot(true);
  settle_.setInterval(settle_ms);
  connect(&settle_, &QTimer::timeout, this, &SceneEditor::settled);
  connect(this, &QPlainTextEdit::textChanged, &settle_, qOverload<>(&QTimer::start));
  connect(this, &QPlainTextEdit::blockCountChanged, this, [this] { setViewportMargins(margin_width(), 0, 0, 0); });
  connect(this, &QPlainTextEdit::updateRequest, margin_, qOverload<>(&QWidget::update));
  connect(completer_, qOverload<const QString&>(&QCompleter::activated), this, &SceneEditor::insert_completion);
  setViewportMargins(margin_width(), 0, 0, 0);
}

std::string SceneEditor::text() const { return toPlainText().toStdString(); }

void SceneEditor::replace_text(const std::string& text) {
  const QString now = toPlainText(), next = QString::fromStdString(text);
  if (now == next) return;
  const auto shorter = std::min(now.size(), next.size());
  qsizetype same = 0, same_end = 0;
  while (same < shorter && now[same] == next[same]) ++same;
  while (same_end < shorter - same && now[now.size() - 1 - same_end] == next[next.size() - 1 - same_end]) ++same_end;
  QTextCursor cursor(document());
  cursor.beginEditBlock();
  cursor.setPosition(static_cast<int>(same));
  cursor.setPosition(static_cast<int>(now.size() - same_end), QTextCursor::KeepAnchor);
  cursor.insertText(next.mid(same, next.size() - same - same_end));
  cursor.endEditBlock();
  settle_.stop();
  Q_EMIT settled();
}

void SceneEditor::set_error(std::optional<SceneError> error) {
  error_ = std::move(error);
  annotate();
}

CompletionPlace SceneEditor::place() const { return completion_place(toPlainText().left(textCursor().position()).toStdString()); }

QStringList SceneEditor::completions() const {
  const CompletionPlace at = place();
  switch (at.kind) {
    case CompletionPlace::Kind::none:
      return {};
    case CompletionPlace::Kind::header:
      return as_list(headers(begins_with_brackets(textCursor())));
    case CompletionPlace::Kind::key:
      return as_list(keys_of(at.table));
    case CompletionPlace::Kind::value:
      break;
  }
  const QStringList words = as_list(words_of(at.table, at.key));
  return words.isEmpty() ? dofs_ : words;
}

void SceneEditor::complete(bool asked_for) {
  const CompletionPlace at = place();
  const QString prefix = QString::fromStdString(at.prefix);
  QAbstractItemView* const popup = completer_->popup();
  if (!asked_for && (prefix.size() < letters_before_offering || at.kind == CompletionPlace::Kind::none)) return popup->hide();
  const QStringList words = completions();
  static_cast<QStringListModel*>(completer_->model())->setStringList(words);
  completer_->setCompletionPrefix(prefix);
  if (completer_->completionCount() == 0 || words.contains(prefix)) return popup->hide();
  popup->setCurrentIndex(completer_->completionModel()->index(0, 0));
  QRect rectangle = cursorRect().translated(viewport()->pos());
  rectangle.setWidth(popup->sizeHintForColumn(0) + popup->verticalScrollBar()->sizeHint().width());
  completer_->complete(rectangle);
}

void SceneEditor::insert_completion(const QString& word) {
  const CompletionPlace at = place();
  QTextCursor cursor = textCursor();
  cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor, static_cast<int>(QString::fromStdString(at.prefix).size()));
  const QString rest = cursor.block().text().mid(textCursor().positionInBlock());
  QString tail;
  if (at.kind == CompletionPlace::Kind::key && !rest.contains('=')) tail = QStringLiteral(" = ");
  const QString end = begins_with_brackets(cursor) ? QStringLiteral("]]") : QStringLiteral("]");
  if (at.kind == CompletionPlace::Kind::header && !rest.startsWith(']')) tail = end;
  cursor.insertText(word + tail);
  setTextCursor(cursor);
}

void SceneEditor::go_to_line(int line) {
  const QTextBlock block = document()->findBlockByNumber(line - 1);
  if (!block.isValid()) return;
  setTextCursor(QTextCursor(block));
  centerCursor();
  setFocus();
}

void SceneEditor::keyPressEvent(QKeyEvent* event) {
  const bool open = completer_->popup()->isVisible();
  const int key = event->key();
  if (open && (key == Qt::Key_Enter || key == Qt::Key_Return || key == Qt::Key_Escape || key == Qt::Key_Tab))
    return event->ignore();
  if (event->modifiers() == Qt::ControlModifier && key == Qt::Key_Space) return complete(true);
  if (key == Qt::Key_Backtab) return static_cast<void>(focusPreviousChild());
  QPlainTextEdit::keyPressEvent(event);
  const bool typed = !event->text().isEmpty() && event->text().front().isPrint();
  if (typed || (open && key == Qt::Key_Backspace))
    complete(false);
  else if (open)
    completer_->popup()->hide();
}

QString SceneEditor::annotation() const {
  if (!error_) return {};
  const QString remedy = QString::fromStdString(error_->remedy);
  return QString::fromStdString(error_->problem) + (remedy.isEmpty() ? "" : ": " + remedy);
}

void SceneEditor::annotate() {
  QList<QTextEdit::ExtraSelection> marks;
  const QTextBlock block = error_ && error_->line > 0 ? document()->findBlockByNumber(error_->line - 1) : QTextBlock();
  if (block.isValid()) {
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(block);
    mark.cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(colours(theme_of(palette())).error);
    marks << mark;
    const QRect room(0, 0, std::max(80, viewport()->width() - 2 * note_indent), 10000);
    const int height = fontMetrics().boundingRect(room, Qt::TextWordWrap, annotation()).height();
    layout_->leave_room(block.blockNumber(), height + 4);
  } else {
    layout_->leave_room(-1, 0.0);
  }
  setExtraSelections(marks);
  viewport()->update();
}

void SceneEditor::paintEvent(QPaintEvent* event) {
  QPlainTextEdit::paintEvent(event);
  const QTextBlock block = document()->findBlockByNumber(layout_->block());
  if (layout_->block() < 0 || !block.isValid() || !block.isVisible()) return;
  QRectF rectangle = blockBoundingGeometry(block).translated(contentOffset());
  rectangle.setTop(rectangle.bottom() - layout_->room());
  rectangle.setLeft(0);
  rectangle.setWidth(viewport()->width());
  QPainter painter(viewport());
  const QColor colour = colours(theme_of(palette())).error;
  QColor soft = colour;
  soft.setAlpha(28);
  painter.fillRect(rectangle, soft);
  painter.setPen(colour);
  painter.drawText(rectangle.adjusted(note_indent, 1, -note_indent, 0), Qt::TextWordWrap, annotation());
}

void SceneEditor::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  const QRect inside = contentsRect();
  margin_->setGeometry(inside.left(), inside.top(), margin_width(), inside.height());
  annotate();
}

void SceneEditor::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || highlighter_ == nullptr) return;
  highlighter_->set_theme(theme_of(palette()));
  annotate();
}

int SceneEditor::margin_width() const {
  const auto digits = std::max<qsizetype>(2, QString::number(blockCount()).size());
  return fontMetrics().horizontalAdvance('9') * static_cast<int>(digits) + 10;
}

bool SceneEditor::eventFilter(QObject* watched, QEvent* event) {
  if (watched != margin_ || event->type() != QEvent::Paint) return QPlainTextEdit::eventFilter(watched, event);
  paint_margin();
  return true;
}

void SceneEditor::paint_margin() {
  QPainter painter(margin_);
  const Colours use = colours(theme_of(palette()));
  painter.fillRect(margin_->rect(), palette().color(QPalette::AlternateBase));
  painter.setFont(font());
  for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
    const QRectF place = blockBoundingGeometry(block).translated(contentOffset());
    if (place.top() > margin_->height()) break;
    const bool wrong = error_ && error_->line == block.blockNumber() + 1;
    painter.setPen(wrong ? use.error : use.weak_text);
    const QRectF room(0, place.top(), margin_->width() - 5, fontMetrics().height());
    painter.drawText(room, Qt::AlignRight, QString::number(block.blockNumber() + 1));
  }
}

}  // namespace jointid::gui
