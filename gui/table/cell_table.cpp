#include "gui/table/cell_table.hpp"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPainter>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <algorithm>

#include "base/error.hpp"
#include "gui/look/dialogs.hpp"
#include "gui/look/named.hpp"
#include "gui/look/output.hpp"
#include "gui/table/table_heads.hpp"

namespace jointid::gui {
namespace {

constexpr int widest_column = 620;
constexpr int least_side_px = 200;  // rows are chosen in it  // pixels
constexpr int row_padding = 6;

/// Draws an interval as a bar about zero in the middle of the cell.
class BarDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QVariantList bar = index.data(CellModel::bar_role).toList();
    if (bar.size() != 3) return QStyledItemDelegate::paint(painter, option, index);
    const Theme theme = theme_of(option.palette);
    const QRectF room = QRectF(option.rect).adjusted(6, 3, -6, -3);
    const auto x = [&](int i) { return room.center().x() + std::clamp(bar[i].toDouble(), -1.0, 1.0) * room.width() / 2.0; };
    painter->save();
    painter->fillRect(option.rect, colours(theme).background);
    painter->setPen(colours(theme).grid);
    painter->drawLine(QPointF(room.center().x(), room.top()), QPointF(room.center().x(), room.bottom()));
    const double left = std::min(room.center().x(), x(1));
    QColor body = curve_colour(theme, 0);
    painter->fillRect(QRectF(left, room.top() + 2, std::abs(x(1) - room.center().x()), room.height() - 4), body);
    painter->setPen(QPen(colours(theme).text, 1.5));
    painter->drawLine(QPointF(x(0), room.center().y()), QPointF(x(2), room.center().y()));
    for (const int end : {0, 2}) painter->drawLine(QPointF(x(end), room.top()), QPointF(x(end), room.bottom()));
    painter->restore();
  }
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QSize size = QStyledItemDelegate::sizeHint(option, index);
    return index.data(CellModel::bar_role).isValid() ? QSize(std::max(260, size.width()), size.height()) : size;
  }
};

/// A cell of a text file, in quotes where it holds what parts cells.
QString escaped(QString text, QChar separator) {
  text.replace('\n', ' ');
  if (!text.contains(separator) && !text.contains('"')) return text;
  return '"' + text.replace("\"", "\"\"") + '"';
}

/// A number, one with its error, or an interval: numbers of a column end below each other.
bool is_number(const QString& text) {
  static const QRegularExpression number(QStringLiteral("^[-+−]?[0-9.]+(e[-+]?[0-9]+)?( ?[%°]| (±|…|\\.\\.\\.) .*)?$"));
  return number.match(text).hasMatch();
}

}  // namespace

CellRows rows_of(const report::Table& table) {
  CellRows out;
  for (const report::Column& column : table.columns()) out.columns << head_text(column.title);
  for (const auto& row : table.rows()) {
    out.cells.emplace_back();
    for (const std::string& cell : row) out.cells.back().push_back(Cell{QString::fromStdString(cell)});
  }
  return out;
}

void CellModel::set(CellRows rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

void CellModel::set_theme(Theme theme) {
  beginResetModel();
  theme_ = theme;
  endResetModel();
}

int CellModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(rows_.cells.size()); }

int CellModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.columns.size());
}

QVariant CellModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Cell& cell = rows_.cells[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())];
  if (role == Qt::DisplayRole) return cell.text;
  if (role == copy_role) return cell.copied.isEmpty() ? cell.text : cell.copied;
  if (role == Qt::ToolTipRole && !cell.hint.isEmpty()) return cell.hint;
  if (role == bar_role && cell.bar) return QVariantList{(*cell.bar)[0], (*cell.bar)[1], (*cell.bar)[2]};
  if (role == Qt::BackgroundRole && cell.shade) return shade(theme_, *cell.shade);
  if (role == Qt::ForegroundRole && cell.shade) return text_on(shade(theme_, *cell.shade));
  if (role == Qt::TextAlignmentRole && cell.shade) return Qt::AlignCenter;
  if (role == Qt::TextAlignmentRole && is_number(cell.text)) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant CellModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Horizontal) return rows_.columns.value(section);
  return rows_.rows.isEmpty() ? QVariant(section + 1) : QVariant(rows_.rows.value(section));
}

CellTable::CellTable(const char* name, const QString& accessible_name, QWidget* parent)
    : QTableView(parent), model_(new CellModel(this)) {
  named(this, name, accessible_name);
  setModel(model_);
  setItemDelegate(new BarDelegate(this));
  setMinimumSize(least_side_px, least_side_px);
  setTabKeyNavigation(false);
  setWordWrap(true);
  setAlternatingRowColors(false);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  auto* copy = new QAction(tr("&Copy"), this);
  connect(copy, &QAction::triggered, this, [this] { QApplication::clipboard()->setText(chosen_text()); });
  auto* save = new QAction(tr("&Save as CSV…"), this);
  save->setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
  save->setShortcutContext(Qt::WidgetShortcut);
  connect(save, &QAction::triggered, this, &CellTable::save_csv);
  addActions({copy, save});
  model_->set_theme(theme_of(palette()));
}

void CellTable::show_rows(CellRows rows) {
  const bool named_rows = !rows.rows.isEmpty();
  model_->set(std::move(rows));
  verticalHeader()->setVisible(named_rows);
  resizeColumnsToContents();
  for (int column = 0; column < model_->columnCount(); ++column)
    setColumnWidth(column, std::min(widest_column, columnWidth(column)));
  resizeRowsToContents();
  for (int row = 0; row < model_->rowCount(); ++row) setRowHeight(row, rowHeight(row) + row_padding);
}

QString CellTable::text(QChar separator) const {
  QString out;
  const bool named_rows = !verticalHeader()->isHidden();
  const auto header = [&](int i, Qt::Orientation orientation) {
    return escaped(model_->headerData(i, orientation, Qt::DisplayRole).toString(), separator);
  };
  for (int row = -1; row < model_->rowCount(); ++row) {
    QStringList cells;
    if (named_rows) cells << (row < 0 ? QString() : header(row, Qt::Vertical));
    for (int column = 0; column < model_->columnCount(); ++column) {
      cells << (row < 0 ? header(column, Qt::Horizontal)
                        : escaped(model_->index(row, column).data(CellModel::copy_role).toString(), separator));
    }
    out += cells.join(separator) + '\n';
  }
  return out;
}

QString CellTable::chosen_text() const {
  QModelIndexList chosen = selectionModel()->selectedIndexes();
  if (chosen.size() < 2) return text('\t');
  std::sort(chosen.begin(), chosen.end());
  QString out;
  for (qsizetype i = 0; i < chosen.size(); ++i) {
    if (i > 0) out += chosen[i].row() == chosen[i - 1].row() ? '\t' : '\n';
    out += escaped(chosen[i].data(CellModel::copy_role).toString(), '\t');
  }
  return out + '\n';
}

void CellTable::write_csv(const QString& file) const { write_output(file, text(',').toStdString(), inputs_); }

void CellTable::save_csv() {
  const QString file = choose_file_to_save(this, tr("Save the table"), objectName() + QStringLiteral(".csv"),
                                           tr("Tables (*.csv)"), QStringLiteral("csv"));
  if (file.isEmpty()) return;
  try {
    write_csv(file);
  } catch (const InputError& error) {
    QMessageBox::warning(this, tr("Not saved"), QString::fromUtf8(error.what()));
  }
}

void CellTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return QApplication::clipboard()->setText(chosen_text());
  QTableView::keyPressEvent(event);
}

void CellTable::changeEvent(QEvent* event) {
  QTableView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && model_ != nullptr) model_->set_theme(theme_of(palette()));
}

}  // namespace jointid::gui
