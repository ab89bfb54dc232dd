#include "gui/plot/frf_plot.hpp"

#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QToolButton>

#include "gui/look/named.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/plot_canvas.hpp"
#include "report/frf_curves.hpp"
#include "report/peaks.hpp"

namespace jointid::gui {
namespace {

QString text_of(View view) {
  switch (view) {
    case View::magnitude_phase:
      return FrfPlot::tr("magnitude and phase");
    case View::real_imaginary:
      return FrfPlot::tr("real and imaginary part");
    case View::nyquist:
      return FrfPlot::tr("Nyquist");
    case View::coherence:
      return FrfPlot::tr("coherence");
    case View::difference:
      return FrfPlot::tr("computed over measured");
    case View::sum:
      return FrfPlot::tr("sum of magnitudes");
    case View::cmif:
      return FrfPlot::tr("CMIF");
  }
  return {};
}

QToolButton* button(const char* name, const QString& text, const QString& hint) {
  auto* made = named(new QToolButton, name, hint, hint);
  made->setText(text);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

}  // namespace

FrfPlot::FrfPlot(const QString& hint, QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("FRFs"));
  canvas_ = new PlotCanvas(hint);
  readout_ = named(new QLabel, "readout", tr("Values at the cursor"));
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  readout_->setTextFormat(Qt::RichText);
  readout_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  add_controls();
  column->addWidget(canvas_, 1);
  column->addWidget(readout_);
  connect(canvas_, &PlotCanvas::cursor_moved, this, [this](double frequency_hz) {
    show_readout();
    Q_EMIT cursor_moved(frequency_hz);
  });
  connect(canvas_, &PlotCanvas::band_chosen, this, &FrfPlot::band_chosen);
  connect(canvas_, &PlotCanvas::band_unwanted, this, &FrfPlot::band_unwanted);
  connect(canvas_, &PlotCanvas::next_wanted, this, &FrfPlot::next_wanted);
  connect(canvas_, &PlotCanvas::mark_changed, this, &FrfPlot::show_readout);
  connect(canvas_, &PlotCanvas::range_changed, this, &FrfPlot::show_readout);
  connect(canvas_, &PlotCanvas::curve_hovered, this, [this](int curve) {
    hovered_ = curve;
    show_readout();
  });
}

FrfPlot::~FrfPlot() = default;

void FrfPlot::add_controls() {
  views_ = named(new QComboBox, "plot_view", tr("What is drawn"));
  for (const View view : {View::magnitude_phase, View::real_imaginary, View::nyquist, View::coherence}) offer(view);
  quantities_ = named(new QComboBox, "plot_quantity", tr("Quantity"));
  for (const auto quantity : {frf::Quantity::receptance, frf::Quantity::mobility, frf::Quantity::accelerance}) {
    quantities_->addItem(QString::fromStdString(frf::name(quantity)), static_cast<int>(quantity));
  }
  exclude_ = button("plot_exclude", tr("Exclude"),
                    tr("While pressed, drag to leave a band out of the identification. Delete takes the band at the cursor in again"));
  exclude_->setCheckable(true);
  exclude_->hide();
  decibel_ = button("plot_decibel", tr("dB"), tr("Magnitudes in decibel"));
  decibel_->setCheckable(true);
  peaks_ = button("plot_peaks", tr("Peaks"), tr("Peaks of the first curve; a choice moves the cursor there"));
  peaks_->setPopupMode(QToolButton::InstantPopup);
  peaks_->setMenu(new QMenu(peaks_));
  auto* window = button("plot_window", tr("Window"), tr("Show the curves in a window of their own"));
  auto* all = button("plot_all", tr("All"), tr("Show all frequencies (Home, or a double click)"));
  auto* copy_button = button("plot_copy", tr("Copy"), tr("Copy the curves for a spreadsheet, and the picture"));
  auto* save_button = button("plot_save", tr("Save…"), tr("Save as PNG, SVG, PDF or CSV"));
  auto* row = new QHBoxLayout;
  row->addWidget(views_);
  row->addWidget(quantities_);
  row->addWidget(decibel_);
  row->addStretch(1);
  for (QToolButton* each : {exclude_, all, peaks_, window, copy_button, save_button}) row->addWidget(each);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  connect(views_, &QComboBox::currentIndexChanged, this, [this] {
    redraw();
    Q_EMIT view_changed();
  });
  connect(quantities_, &QComboBox::currentIndexChanged, this, &FrfPlot::redraw);
  connect(decibel_, &QToolButton::toggled, this, &FrfPlot::redraw);
  connect(peaks_->menu(), &QMenu::aboutToShow, this, &FrfPlot::offer_peaks);
  connect(window, &QToolButton::clicked, this, [this] { pop_out()->show(); });
  connect(exclude_, &QToolButton::toggled, this, [this](bool on) { canvas_->set_excluding(on); });
  connect(all, &QToolButton::clicked, canvas_, &PlotCanvas::show_all);
  connect(copy_button, &QToolButton::clicked, this, [this] { copy_plot(saveable()); });
  connect(save_button, &QToolButton::clicked, this, [this] { ask_and_save(this, saveable(), inputs_, proposed_name()); });
}

/// "assembly_1Y_5Y.png" of the first curve.
QString FrfPlot::proposed_name() const {
  if (curves().empty()) return QStringLiteral("frf.png");
  const Curve& curve = curves().front();
  QString name = QFileInfo(QString::fromStdString(curve.file)).completeBaseName();
  if (name.isEmpty()) name = QStringLiteral("frf");
  const QRegularExpression marks(QStringLiteral("[:+]"));
  for (const frf::Dof& dof : {curve.response, curve.reference}) name += QLatin1Char('_') + QString::fromStdString(dof.name()).remove(marks);
  return name + QStringLiteral(".png");
}

void FrfPlot::set_decibel(bool on) { decibel_->setChecked(on); }

void FrfPlot::offer_peaks() {
  QMenu& menu = *peaks_->menu();
  menu.clear();
  if (!curves().empty()) {
    const Curve& first = curves().front();
    for (const report::Peak& peak : report::find_peaks(first.frequency_hz, report::magnitudes(converted(first, quantity())))) {
      const QString unit = QString::fromStdString(unit_of({first}, quantity()));
      const QString text = tr("%1 Hz: %2 %3").arg(peak.x, 0, 'g', 6).arg(peak.height, 0, 'g', 4).arg(unit);
      menu.addAction(text, this, [this, at = peak.x] {
        set_cursor(at);
        Q_EMIT cursor_moved(at);
      });
    }
  }
  if (menu.isEmpty()) menu.addAction(tr("no peak"))->setEnabled(false);
}

FrfPlot* FrfPlot::pop_out() {
  auto* const twin = new FrfPlot({}, this);
  twin->setWindowFlags(Qt::Window);
  twin->setAttribute(Qt::WA_DeleteOnClose);
  twin->setWindowTitle(curves().empty() ? tr("FRFs") : QString::fromStdString(curves().front().name));
  twin->protect(inputs_);
  for (int i = twin->views_->count(); i < views_->count(); ++i) twin->offer(static_cast<View>(views_->itemData(i).toInt()));
  twin->set_view(view());
  twin->quantities_->setCurrentIndex(quantities_->currentIndex());
  twin->set_decibel(decibel_->isChecked());
  twin->set_curves(curves());
  twin->canvas_->show_range(canvas_->shown_hz());
  twin->resize(900, 600);
  connect(this, &FrfPlot::cursor_moved, twin, &FrfPlot::set_cursor);
  connect(twin, &FrfPlot::cursor_moved, this, &FrfPlot::set_cursor);
  return twin;
}

void FrfPlot::let_exclude() { exclude_->show(); }

void FrfPlot::offer(View view) { views_->addItem(text_of(view), static_cast<int>(view)); }

frf::Quantity FrfPlot::quantity() const { return static_cast<frf::Quantity>(quantities_->currentData().toInt()); }

View FrfPlot::view() const { return static_cast<View>(views_->currentData().toInt()); }

void FrfPlot::set_view(View view) { views_->setCurrentIndex(views_->findData(static_cast<int>(view))); }

const std::vector<Curve>& FrfPlot::curves() const { return canvas_->curves(); }

void FrfPlot::set_curves(std::vector<Curve> curves) {
  std::erase_if(curves, [](const Curve& curve) { return curve.values.empty(); });
  canvas_->draw(curves, view(), quantity(), decibel_->isChecked());
  hovered_ = -1;
  show_readout();
}

void FrfPlot::redraw() { set_curves(canvas_->curves()); }

void FrfPlot::set_bands(std::vector<ident::Range> excluded, std::optional<ident::Range> range) {
  canvas_->set_bands(std::move(excluded), range);
}

void FrfPlot::set_marked(std::vector<double> marked_hz) { canvas_->set_marked(std::move(marked_hz)); }

void FrfPlot::set_cursor(double frequency_hz) {
  canvas_->move_cursor(frequency_hz);
  show_readout();
}

/// The values come and go with the line of the cursor. With the colours of the curves, so that it is a legend; the curve under the
/// mouse is bold.
void FrfPlot::show_readout() {
  const ReadoutStyle style{decibel_->isChecked(), canvas_->mark_hz()};
  readout_text_.clear();
  if (const auto at = canvas_->cursor_hz()) readout_text_ = QString::fromStdString(gui::readout(curves(), *at, quantity(), style));
  const QStringList lines = readout_text_.split(QLatin1Char('\n'));
  const Theme theme = theme_of(palette());
  QString rich = lines.front().toHtmlEscaped();
  for (qsizetype i = 1; i < lines.size(); ++i) {
    const bool is_curve = static_cast<std::size_t>(i) <= curves().size() && i <= static_cast<qsizetype>(ReadoutStyle().most);
    const QString text = lines[i].toHtmlEscaped();
    rich += QStringLiteral("<br>");
    const QString colour = curve_colour(theme, static_cast<int>(i) - 1).name();
    if (is_curve) rich += QStringLiteral("<span style=\"color:%1\">&#9632;</span> ").arg(colour);
    rich += is_curve && i - 1 == hovered_ ? QStringLiteral("<b>%1</b>").arg(text) : text;
  }
  if (hovered_ >= static_cast<int>(ReadoutStyle().most) && hovered_ < static_cast<int>(curves().size()))
    rich += QStringLiteral("<br><b>%1</b>").arg(QString::fromStdString(curves()[static_cast<std::size_t>(hovered_)].name).toHtmlEscaped());
  readout_->setText(rich);
}

void FrfPlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && readout_ != nullptr) show_readout();
}

Saveable FrfPlot::saveable() const {
  return {[this](const QString& ending) { return canvas_->picture(ending); },
          [this](char separator) { return curves_table(curves(), quantity(), separator); }};
}

void FrfPlot::save(const QString& file) const { save_plot(file, saveable(), inputs_); }

}  // namespace jointid::gui
