#include "gui/solve/worth_row.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"
#include "gui/look/theme.hpp"

namespace jointid::gui {
namespace {

using tasks::Light;

constexpr std::size_t questions = 4;

QChar sign(Light light) {
  switch (light) {
    case Light::good: return QChar(0x2713);      // check mark
    case Light::doubtful: return QLatin1Char('!');
    case Light::bad: return QChar(0x2717);       // ballot X
    case Light::unknown: break;
  }
  return QLatin1Char('?');
}

QColor colour_of(Light light, const Colours& use) {
  switch (light) {
    case Light::good: return use.good;
    case Light::doubtful: return use.warning;
    case Light::bad: return use.error;
    case Light::unknown: break;
  }
  return use.weak_text;
}

}  // namespace

WorthRow::WorthRow(QWidget* parent) : QWidget(parent) {
  named(this, "worth", tr("What the result is worth"));
  const std::vector<std::pair<const char*, QString>> names = {{"worth_determined", tr("determined")},
                                                              {"worth_passive", tr("passive")},
                                                              {"worth_noise", tr("within the noise")},
                                                              {"worth_better", tr("better than no joint")}};
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < questions; ++i) {
    lights_.push_back(push_button(names[i].first, names[i].second, names[i].second));
    lights_[i]->setFlat(true);
    lights_[i]->setProperty("question", names[i].second);
    row->addWidget(lights_[i]);
    connect(lights_[i], &QPushButton::clicked, this, [this, i] {
      if (i < answers_.size()) Q_EMIT chosen(answers_[i]);
    });
  }
  row->addStretch(1);
  hide();
}

void WorthRow::show_answers(std::vector<tasks::WorthAnswer> answers) {
  answers_ = std::move(answers);
  for (std::size_t i = 0; i < std::min(answers_.size(), lights_.size()); ++i) {
    const QString question = lights_[i]->property("question").toString(), answer = QString::fromStdString(answers_[i].text);
    lights_[i]->setText(sign(answers_[i].light) + QLatin1Char(' ') + question);
    lights_[i]->setToolTip(answer);
    lights_[i]->setAccessibleName(question);
    lights_[i]->setAccessibleDescription(answer);
  }
  colour();
  setVisible(answers_.size() == lights_.size());
}

void WorthRow::colour() {
  const Colours use = colours(theme_of(palette()));
  for (std::size_t i = 0; i < std::min(answers_.size(), lights_.size()); ++i) {
    lights_[i]->setStyleSheet(QStringLiteral("color: %1; padding: 2px 4px").arg(colour_of(answers_[i].light, use).name()));
  }
}

void WorthRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colour();
}

}  // namespace jointid::gui
