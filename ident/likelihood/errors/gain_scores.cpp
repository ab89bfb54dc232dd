#include "ident/likelihood/errors/gain_scores.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "ident/likelihood/errors/sensor_screen.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_suspects = 3;
constexpr double dependent = 1e-6;  ///< of the information on a gain: what the others leave of it
constexpr double nearly = 0.95;     ///< of the largest score

/// Takes trial k as known: the others given it.
void take(Eigen::Index k, Scores& scores) {
  const Eigen::VectorXd column = scores.information.col(k) / scores.information(k, k);
  const Eigen::RowVectorXd row = scores.information.row(k);
  scores.gradient -= column * scores.gradient[k];
  scores.information -= column * row;
}

std::string other_file(const std::vector<SensorTrial>& sensors, const std::vector<double>& scores, std::size_t best) {
  for (std::size_t k = 0; k < sensors.size(); ++k) {
    if (k == best || !sensors[k].dof.same_coordinate(sensors[best].dof)) continue;
    if (std::abs(scores[k]) >= nearly * std::abs(scores[best]) && scores[k] * scores[best] < 0.0) return sensors[k].file;
  }
  return "";
}

}  // namespace

std::vector<GainSuspect> suspect_gains(const TriedErrors& tried, std::size_t known) {
  const std::vector<SensorTrial>& sensors = tried.trials.sensors;
  const Scores& whole = tried.scores;
  const double inflation = tried.inflation;
  if (sensors.empty()) return {};
  const Eigen::Index all = at(known + sensors.size());
  Scores scores = left_of({whole.information.topLeftCorner(all, all), whole.gradient.head(all)}, known);
  const Eigen::VectorXd at_first = scores.information.diagonal();
  std::vector<GainSuspect> out;
  while (out.size() < most_suspects) {
    std::vector<double> z(sensors.size(), 0.0);
    for (std::size_t k = 0; k < z.size(); ++k) {
      const double information = scores.information(at(k), at(k));
      if (information > dependent * at_first[at(k)]) z[k] = scores.gradient[at(k)] / std::sqrt(information) / inflation;
    }
    const auto best =
        static_cast<std::size_t>(std::ranges::max_element(z, {}, [](double value) { return std::abs(value); }) - z.begin());
    if (!(std::abs(z[best]) >= SensorScreen::significant)) break;
    const Eigen::Index k = at(best);
    const double information = scores.information(k, k);
    out.push_back({.sensor = sensors[best].dof.name() + " in " + sensors[best].file,
                   .dof = sensors[best].dof,
                   .file = sensors[best].file,
                   .gain = std::exp(scores.gradient[k] / information),
                   .error = inflation / std::sqrt(information),
                   .score = z[best],
                   .instead = other_file(sensors, z, best)});
    take(k, scores);
  }
  return out;
}

void tell_gains(const std::vector<GainSuspect>& suspects, Solution& out) {
  if (!out.identifiability) return;
  for (const GainSuspect& each : suspects) {
    std::string text = "The FRFs fit better with a gain of " + digits(each.gain, "%.4f") + " ± " + digits(each.error, "%.1g") +
                       " of the sensor " + each.sensor + " (" + digits(std::abs(each.score), "%.2g") +
                       " standard deviations from 1)";
    if (!each.instead.empty()) text += ", or with its inverse in " + each.instead;
    out.identifiability->findings.push_back(
        {FindingKind::gain, text + ". Is its calibration off? [[data.gains]] estimates it with the joint."});
  }
}

}  // namespace jointid::ident
