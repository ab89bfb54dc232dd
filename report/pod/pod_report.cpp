#include "report/pod/pod_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

std::vector<double> listed(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

/// As many modes as the table of shapes shows: those of 99.99 %, six at most.
std::size_t shown(const tasks::PodResult& report) { return std::min<std::size_t>(report.pod.modes_for(0.9999), 6); }

Json matrix(const Eigen::MatrixXd& m) {
  std::vector<std::vector<double>> out;
  for (Eigen::Index i = 0; i < m.rows(); ++i) out.emplace_back(m.row(i).begin(), m.row(i).end());
  return values(out);
}

}  // namespace

std::string pod_summary(const tasks::PodResult& report) {
  return fmt::format("{} samples of {} channels; {} modes hold 99 %, {} hold 99.99 % of Σσ².", report.pod.samples,
                     report.names.size(), report.pod.modes_for(0.99), report.pod.modes_for(0.9999));
}

Table pod_values_table(const oscillation::Pod& pod) {
  Table table({{"mode"}, {"σ"}, {"mean square λ"}, {"Σσ² %"}, {"Σσ %"}});
  const Eigen::VectorXd squares = pod.square_fractions(), sigmas = pod.sigma_fractions();
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(pod.sigma.size(), 12); ++k) {
    table.add({fmt::format("{}", k + 1), number(pod.sigma(k)), number(pod.values(k)), fmt::format("{:.4f}", 100.0 * squares(k)),
               fmt::format("{:.2f}", 100.0 * sigmas(k))});
  }
  return table;
}

Table pod_shapes_table(const tasks::PodResult& report) {
  std::vector<Column> columns = {{"channel", Align::left}, {"mean"}};
  for (std::size_t k = 0; k < shown(report); ++k) columns.push_back({fmt::format("mode {}", k + 1)});
  Table table(columns);
  for (std::size_t i = 0; i < report.names.size(); ++i) {
    std::vector<std::string> row = {report.names[i], number(report.pod.mean(at(i)))};
    for (std::size_t k = 0; k < shown(report); ++k) row.push_back(fmt::format("{:.5f}", report.pod.modes(at(i), at(k))));
    table.add(row);
  }
  return table;
}

Table pod_comparison_table(const tasks::PodResult& report) {
  const bool hertz = !report.frequencies_hz.empty();
  Table table({{"mode"}, {"most alike"}, {hertz ? "Hz" : ""}, {report.weighted ? "M-cosine" : "cosine"}, {"MAC"}});
  auto pairs = oscillation::matched_modes(report.cosines);
  std::ranges::sort(pairs, {}, &oscillation::ModePair::phi);
  for (const oscillation::ModePair& pair : pairs) {
    table.add({fmt::format("{}", pair.phi + 1), fmt::format("{}", pair.psi + 1),
               hertz ? number(report.frequencies_hz[pair.psi]) : "", fmt::format("{:.6f}", pair.cosine),
               fmt::format("{:.6f}", report.assurance(at(pair.phi), at(pair.psi)))});
  }
  return table;
}

Table pod_contributions_table(const tasks::PodResult& report) {
  constexpr Eigen::Index most = 8;
  const Eigen::MatrixXd& shares = report.contributions.shares;
  std::vector<Column> columns = {{"mode"}};
  for (Eigen::Index k = 0; k < std::min(shares.cols(), most); ++k) columns.push_back({fmt::format("of {}", k + 1)});
  if (shares.cols() > most) columns.push_back({"of others"});
  columns.push_back({"outside %"});
  Table table(columns);
  for (Eigen::Index i = 0; i < at(shown(report)); ++i) {
    std::vector<std::string> row = {fmt::format("{}", i + 1)};
    for (Eigen::Index k = 0; k < std::min(shares.cols(), most); ++k) row.push_back(fmt::format("{:.4f}", shares(i, k)));
    if (shares.cols() > most) row.push_back(fmt::format("{:.4f}", shares.row(i).tail(shares.cols() - most).sum()));
    row.push_back(fmt::format("{:.3g}", 100.0 * report.contributions.outside(i)));
    table.add(row);
  }
  return table;
}

std::vector<std::string> pod_remarks(const tasks::PodResult& report) {
  std::vector<std::string> out;
  const oscillation::Pod& pod = report.pod;
  if (pod.missing > 0) out.push_back(fmt::format("{} samples with a missing channel are left out", pod.missing));
  if (report.cut > 0)
    out.push_back(fmt::format("channels differ in length: {} numbers at the ends of the longer ones are left out", report.cut));
  if (!report.weighted && std::ranges::adjacent_find(report.units, std::not_equal_to<>()) != report.units.end()) {
    out.push_back("channels have different units: the modes depend on them; weight the channels with --mass");
  }
  if (pod.samples <= static_cast<std::size_t>(pod.sigma.size())) {
    out.push_back(fmt::format("{} samples of {} channels: modes beyond the {}th mean nothing", pod.samples, pod.sigma.size(),
                              pod.samples - 1));
  }
  return out;
}

std::string pod_text(const tasks::PodResult& report) {
  const oscillation::Pod& pod = report.pod;
  std::string text =
      fmt::format("{} samples of {} channels, {}, inner product {}\n", pod.samples, report.names.size(),
                  report.mean_kept ? "mean kept" : "mean removed", report.weighted ? "of the mass matrix" : "plain");
  text += notes_text(pod_remarks(report));
  text += fmt::format("\nproper orthogonal values; energy by Σσ² (mean squares; the usual one) and by Σσ\n{}",
                      pod_values_table(pod).text());
  text += fmt::format("\nmodes for 99 % of Σσ²: {}; for 99.99 %: {}", pod.modes_for(0.99), pod.modes_for(0.9999));
  if (const auto rank = oscillation::rank_above_noise(pod))
    text += fmt::format("; above white noise (Gavish and Donoho): {}", *rank);
  text += fmt::format("\n\nproper orthogonal modes\n{}", pod_shapes_table(report).text());
  if (report.cosines.size() > 0) {
    text += fmt::format("\nbeside {}\n{}\ntheir contributions to each mode, |v|/Σ|v|\n{}", report.compared,
                        pod_comparison_table(report).text(), pod_contributions_table(report).text());
  }
  return text;
}

std::string pod_json(const tasks::PodResult& report) {
  const oscillation::Pod& pod = report.pod;
  Json out = {{"status", "ok"},
              {"samples", pod.samples},
              {"missing", pod.missing},
              {"cut", report.cut},
              {"inner_product", report.weighted ? "mass" : "plain"},
              {"mean_removed", !report.mean_kept},
              {"channels", report.names},
              {"units", report.units},
              {"mean", values(listed(pod.mean))},
              {"sigma", values(listed(pod.sigma))},
              {"values", values(listed(pod.values))},
              {"fractions_of_sigma_squared", values(listed(pod.square_fractions()))},
              {"fractions_of_sigma", values(listed(pod.sigma_fractions()))},
              {"modes_for_99_percent", pod.modes_for(0.99)},
              {"modes_for_99_99_percent", pod.modes_for(0.9999)},
              {"remarks", pod_remarks(report)}};
  const auto rank = oscillation::rank_above_noise(pod);
  out["rank_above_noise"] = rank ? Json(*rank) : Json();
  out["modes"] = matrix(pod.modes.transpose());
  if (report.cosines.size() > 0) {
    out["cosines"] = matrix(report.cosines);
    out["mac"] = matrix(report.assurance);
    out["contributions"] = matrix(report.contributions.shares);
    out["outside"] = values(listed(report.contributions.outside));
    if (!report.frequencies_hz.empty()) out["normal_frequencies_hz"] = values(report.frequencies_hz);
  }
  return json_text(out);
}

std::string pod_csv(const tasks::PodResult& report) {
  std::vector<std::string> titles = {"channel", "unit", "mean"};
  for (Eigen::Index k = 0; k < report.pod.modes.cols(); ++k) titles.push_back(fmt::format("mode {}", k + 1));
  std::string text = csv_line(titles);
  for (std::size_t i = 0; i < report.names.size(); ++i) {
    std::vector<std::string> row = {report.names[i], report.units[i], csv_number(report.pod.mean(at(i)))};
    for (Eigen::Index k = 0; k < report.pod.modes.cols(); ++k) row.push_back(csv_number(report.pod.modes(at(i), k)));
    text += csv_line(row);
  }
  return text;
}

}  // namespace jointid::report
