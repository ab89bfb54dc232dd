#include "gui/compare/compare_choices.hpp"

#include <QVBoxLayout>

#include "gui/look/buttons.hpp"
#include "gui/look/choice_button.hpp"
#include "gui/look/named.hpp"
#include "ident/scene/method_traits.hpp"

namespace jointid::gui {
namespace {

QStringList names(const std::vector<std::string>& all) {
  QStringList out;
  for (const std::string& name : all) out << QString::fromStdString(name);
  return out;
}

/// Every solver of any method, once; auto stands for what is not chosen.
QStringList solver_words() {
  QStringList words = names(ident::solver_names());
  words.removeAll(QStringLiteral("auto"));
  return words;
}

QStringList regeneration_words() {
  QStringList words;
  for (const auto& one : {ident::Regeneration{}, {true, false}, {false, true}, {true, true}}) {
    words << QString::fromStdString(ident::name(one));
  }
  return words;
}

std::vector<ident::Equation> equations_of(const QString& words) {
  std::vector<ident::Equation> set;
  for (const QString& word : words.split(' ')) set.push_back(ident::parse_equation(word.toStdString()));
  return set;
}

QString option(const char* name, const QStringList& words) {
  return words.isEmpty() ? QString() : QStringLiteral(" --%1 %2").arg(QLatin1String(name), words.join(','));
}

}  // namespace

CompareChoices::CompareChoices(QWidget* parent) : QWidget(parent) {
  named(this, "compare_choices", tr("Choices to compare"));
  methods_ = new ChoiceButton("compare_methods", tr("method"), names(ident::method_names()));
  equations_ = new ChoiceButton("compare_equations", tr("equations"), {"nn", "nn nj", "nn jn", "nn nj jj jn"});
  weightings_ = new ChoiceButton("compare_weightings", tr("weighting"), {"none", "WA", "WB", "WBG", "WBS"});
  deltas_ = new ChoiceButton("compare_deltas", tr("Δ"), {"0", "0.01", "0.02", "0.05", "0.1", "0.2", "0.5"});
  solvers_ = new ChoiceButton("compare_solvers", tr("solver"), solver_words());
  regenerated_ = new ChoiceButton("compare_regenerated", tr("by modes"), regeneration_words());
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addLayout(row_of({methods_, equations_, deltas_}, {}));
  rows->addLayout(row_of({weightings_, solvers_, regenerated_}, {}));
}

study::Alternatives CompareChoices::alternatives() const {
  study::Alternatives out;
  for (const QString& word : methods_->chosen()) out.methods.push_back(ident::parse_method(word.toStdString()));
  for (const QString& words : equations_->chosen()) out.equations.push_back(equations_of(words));
  for (const QString& word : weightings_->chosen()) out.weightings.push_back(weighting::parse_weighting(word.toStdString()));
  for (const QString& word : deltas_->chosen()) out.deltas.push_back(word.toDouble());
  for (const QString& word : solvers_->chosen()) out.solvers.push_back(ident::parse_solver(word.toStdString()));
  for (const QString& word : regenerated_->chosen()) out.regenerations.push_back(ident::parse_regeneration(word.toStdString()));
  return out;
}

QString CompareChoices::options() const {
  const QStringList sets = equations_->chosen();
  return option("methods", methods_->chosen()) +
         (sets.isEmpty() ? QString() : QStringLiteral(" --equations '%1'").arg(sets.join(';'))) +
         option("weightings", weightings_->chosen()) + option("deltas", deltas_->chosen()) +
         option("solvers", solvers_->chosen()) + option("regenerate", regenerated_->chosen());
}

}  // namespace jointid::gui
