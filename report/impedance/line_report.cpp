#include "report/impedance/line_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/statistics.hpp"
#include "report/json_value.hpp"
#include "report/text/notes.hpp"

namespace jointid::report {
namespace {

using impedance::IdentifiedLines;
using impedance::LineValue;
using impedance::WayResult;

constexpr std::size_t most_rows = 20, most_elements = 6;

std::string of_lines(const IdentifiedLines& found) {
  return fmt::format("{} lines, {:.6g} to {:.6g} Hz", found.frequency_hz.size(), found.frequency_hz.front(),
                     found.frequency_hz.back());
}

std::string chi_square_text(const IdentifiedLines& found) {
  if (!(found.freedom > 0.0)) return "χ²: no degrees of freedom\n";
  return fmt::format("χ² = {:.5g} of {:.0f} degrees of freedom, χ²/f = {:.3g} (chance leaves up to {:.3g})\n", found.chi_square,
                     found.freedom, found.chi_square / found.freedom, found.likely);
}

/// Lines at which a table has rows.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> out;
  const std::size_t rows = std::min(count, most);
  for (std::size_t k = 0; k < rows; ++k) out.push_back(rows == 1 ? 0 : k * (count - 1) / (rows - 1));
  return out;
}

Json pair(Complex z) { return {value(z.real()), value(z.imag())}; }

Json rows_of(const Eigen::MatrixXd& matrix) {
  Json out = Json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) row.push_back(value(matrix(r, c)));
    out.push_back(row);
  }
  return out;
}

/// The part of Z that an element multiplies: row, column, factor of each number that is not zero.
Json basis_json(const Eigen::MatrixXd& matrix) {
  Json out = Json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) {
      if (matrix(r, c) != 0.0) out.push_back({r, c, matrix(r, c)});
    }
  }
  return out;
}

Json elements_of(const LineValue& line) {
  Json out = {{"z", Json::array()}, {"variance", Json::array()}, {"std_error", Json::array()}};
  for (Eigen::Index t = 0; t < line.z.size(); ++t) {
    out["z"].push_back(pair(line.z(t)));
    out["variance"].push_back(value(line.variance(t)));
    out["std_error"].push_back({value(line.re_error(t)), value(line.im_error(t))});
  }
  return out;
}

Json line_json(const std::optional<LineValue>& line) {
  if (!line) return nullptr;
  Json out = elements_of(*line);
  out["covariance"] = rows_of(line->covariance);
  out["chi_square"] = value(line->chi_square);
  out["degrees_of_freedom"] = value(line->freedom);
  return out;
}

Json way_json(const WayResult& way) {
  Json out = {{"way", impedance::name(way.way)},
              {"structure", impedance::name(way.structure)},
              {"elements", Json::array()},
              {"lines", Json::array()}};
  for (std::size_t t = 0; t < way.elements.size(); ++t) {
    out["elements"].push_back(
        {{"name", way.elements[t].name}, {"unit", way.elements[t].unit}, {"basis", basis_json(way.basis[t])}});
  }
  for (const auto& line : way.lines) out["lines"].push_back(line_json(line));
  return out;
}

Json law_json(const impedance::LawFit& law) {
  Json out = {{"law", impedance::name(law.law)},          {"converged", law.converged}, {"chi_square", value(law.chi_square)},
              {"degrees_of_freedom", value(law.freedom)}, {"aic", value(law.aic)},      {"parameters", Json::array()},
              {"covariance", rows_of(law.covariance)},    {"lines", Json::array()}};
  for (const impedance::FittedParameter& one : law.parameters) {
    out["parameters"].push_back(
        {{"name", one.name},
         {"value", value(one.value)},
         {"unit", one.unit},
         {"std_error", value(one.std_error)},
         {"ci95", {value(one.value - normal_95 * one.std_error), value(one.value + normal_95 * one.std_error)}}});
  }
  for (std::size_t i = 0; i < law.lines.size(); ++i) {
    if (!law.lines[i]) {
      out["lines"].push_back(nullptr);
      continue;
    }
    Json line = elements_of(*law.lines[i]);
    line["chi_square"] = value(law.by_line[i]);
    out["lines"].push_back(line);
  }
  return out;
}

Json smooth_json(const IdentifiedLines& found, const impedance::SmoothElement& one) {
  Json out = {{"element", found.ways.front().elements[one.element].name},
              {"lambda", value(one.fit.lambda)},
              {"criterion", value(one.fit.criterion)},
              {"effective_degrees", value(one.fit.degrees)},
              {"lines", one.lines},
              {"z", Json::array()},
              {"variance", values(std::span(one.fit.variance.data(), one.lines.size()))},
              {"variance_sampling", values(std::span(one.fit.variance_sampling.data(), one.lines.size()))}};
  for (const Complex z : one.fit.z) out["z"].push_back(pair(z));
  return out;
}

Json receptances(const std::vector<Eigen::MatrixXcd>& all) {
  Json out = Json::array();
  for (const Eigen::MatrixXcd& y : all) {
    Json line = Json::array();
    for (Eigen::Index r = 0; r < y.rows(); ++r) {
      Json row = Json::array();
      for (Eigen::Index c = 0; c < y.cols(); ++c) row.push_back(pair(y(r, c)));
      line.push_back(row);
    }
    out.push_back(line);
  }
  return out;
}

std::vector<std::string> value_cells(const std::string& way, const impedance::ElementName& element, double hz, Complex z,
                                     double re_error, double im_error) {
  std::vector<std::string> out = {way, element.name, element.unit};
  const double re = normal_95 * re_error, im = normal_95 * im_error;
  for (const double number :
       {hz, z.real(), z.imag(), re_error, im_error, z.real() - re, z.real() + re, z.imag() - im, z.imag() + im})
    out.push_back(csv_number(number));
  return out;
}

std::string smooth_text(const IdentifiedLines& found) {
  if (found.smooth.empty()) return "";
  Table table({{"element", Align::left}, {"λ"}, {"effective degrees"}, {"error of a line over that of the spline, median"}});
  for (const impedance::SmoothElement& one : found.smooth) {
    std::vector<double> gain;
    for (std::size_t q = 0; q < one.lines.size(); ++q) {
      const double line = found.ways.front().lines[one.lines[q]]->variance(static_cast<Eigen::Index>(one.element));
      gain.push_back(std::sqrt(line / one.fit.variance(static_cast<Eigen::Index>(q))));
    }
    table.add({found.ways.front().elements[one.element].name, number(one.fit.lambda), fmt::format("{:.1f}", one.fit.degrees),
               fmt::format("{:.2g}", median(gain))});
  }
  return "\nspline over the lines\n" + table.text();
}

std::string laws_text(const IdentifiedLines& found) {
  if (found.laws.empty()) return "";
  std::string text = "\nlaws\n" + law_table(found).text();
  if (found.laws.front().converged)
    text += impedance::name(found.laws.front().law) + "\n" + parameter_table(found.laws.front()).text();
  return text;
}

}  // namespace

Table parameter_table(const impedance::LawFit& law) {
  Table table({{"parameter", Align::left}, {"value"}, {"unit", Align::left}, {"std error"}, {"95 % interval", Align::left}});
  for (const impedance::FittedParameter& one : law.parameters) {
    const double half = normal_95 * one.std_error;
    table.add({one.name, number(one.value, one.std_error), one.unit, fmt::format("{:.2g}", one.std_error),
               number(one.value - half, one.std_error) + " to " + number(one.value + half, one.std_error)});
  }
  return table;
}

Table law_table(const IdentifiedLines& found) {
  Table table({{"law", Align::left}, {"unknowns"}, {"χ²"}, {"freedom"}, {"χ²/f"}, {"AIC − least"}, {"", Align::left}});
  for (const impedance::LawFit& law : found.laws) {
    table.add({impedance::name(law.law), std::to_string(law.theta.size()), number(law.chi_square),
               fmt::format("{:.0f}", law.freedom), fmt::format("{:.3g}", law.chi_square / law.freedom),
               fmt::format("{:.1f}", law.aic - found.laws.front().aic), law.converged ? "" : "not converged"});
  }
  return table;
}

Table line_table(const IdentifiedLines& found, const WayResult& way, std::size_t element, std::size_t most) {
  Table table({{"Hz"}, {"Re"}, {"std error"}, {"Im"}, {"std error"}, {"loss factor"}, {"χ²/f"}});
  const auto t = static_cast<Eigen::Index>(element);
  for (const std::size_t i : spread(way.lines.size(), most)) {
    const auto& line = way.lines[i];
    if (!line) {
      table.add({fmt::format("{:.6g}", found.frequency_hz[i]), "–", "–", "–", "–", "–", "–"});
      continue;
    }
    const double re = line->re_error(t), im = line->im_error(t);
    const bool has_chi_square = line->freedom > 0.0 && std::isfinite(line->chi_square);
    table.add({fmt::format("{:.6g}", found.frequency_hz[i]), number(line->z(t).real(), re), fmt::format("{:.2g}", re),
               number(line->z(t).imag(), im), fmt::format("{:.2g}", im),
               fmt::format("{:.3g}", line->z(t).imag() / line->z(t).real()),
               has_chi_square ? fmt::format("{:.2f}", line->chi_square / line->freedom) : "–"});
  }
  return table;
}

std::string line_text(const impedance::LineScene& scene, const IdentifiedLines& found) {
  std::string text = scene.scene.title.empty() ? "" : scene.scene.title + "\n";
  text += "dynamic stiffness of the joint at every line: " + of_lines(found) + "; structure " + impedance::name(scene.structure) +
          "\n" + chi_square_text(found);
  for (const WayResult& way : found.ways) {
    text += "\nway " + impedance::name(way.way) + "\n";
    for (std::size_t e = 0; e < std::min(most_elements, way.elements.size()); ++e) {
      text += way.elements[e].name + ", " + way.elements[e].unit + "\n" + line_table(found, way, e, most_rows).text();
    }
    if (way.elements.size() > most_elements) {
      text += fmt::format("  and {} more elements: --csv, --json and --report have them\n", way.elements.size() - most_elements);
    }
  }
  text += laws_text(found) + smooth_text(found);
  text += notes_text(found.notes);
  return text + "status: " + name(found.status) + (found.message.empty() ? "" : ": " + found.message) + "\n";
}

std::string line_json(const impedance::LineScene& scene, const IdentifiedLines& found) {
  Json out = {{"kind", "lines"},
              {"title", scene.scene.title},
              {"status", name(found.status)},
              {"message", found.message},
              {"structure", impedance::name(scene.structure)},
              {"dofs", Json::array()},
              {"frequency_hz", values(found.frequency_hz)},
              {"chi_square", value(found.chi_square)},
              {"degrees_of_freedom", value(found.freedom)},
              {"likely_ratio", value(found.likely)},
              {"condition_substructures", values(found.condition_substructures)},
              {"condition_assembly", values(found.condition_assembly)},
              {"restarted", found.restarted},
              {"failed", found.failed},
              {"notes", found.notes},
              {"ways", Json::array()}};
  for (const frf::Dof& dof : found.dofs) out["dofs"].push_back(dof.name());
  for (const WayResult& way : found.ways) out["ways"].push_back(way_json(way));
  if (!found.laws.empty()) {
    out["laws"] = Json::array();
    for (const impedance::LawFit& law : found.laws) out["laws"].push_back(law_json(law));
  }
  if (!found.smooth.empty()) {
    out["smooth"] = Json::array();
    for (const impedance::SmoothElement& one : found.smooth) out["smooth"].push_back(smooth_json(found, one));
  }
  if (!found.joint_receptance.empty()) out["joint_receptance"] = receptances(found.joint_receptance);
  return json_text(out);
}

std::string line_csv(const IdentifiedLines& found) {
  std::string text = csv_line({"way", "element", "unit", "frequency_hz", "re", "im", "std_error_re", "std_error_im",
                               "ci95_re_low", "ci95_re_high", "ci95_im_low", "ci95_im_high", "chi_square", "degrees_of_freedom",
                               "condition_substructures", "condition_assembly"});
  for (const WayResult& way : found.ways) {
    for (std::size_t e = 0; e < way.elements.size(); ++e) {
      const auto t = static_cast<Eigen::Index>(e);
      for (std::size_t i = 0; i < way.lines.size(); ++i) {
        if (!way.lines[i]) continue;
        const LineValue& line = *way.lines[i];
        std::vector<std::string> cells = value_cells(impedance::name(way.way), way.elements[e], found.frequency_hz[i], line.z(t),
                                                     line.re_error(t), line.im_error(t));
        for (const double number : {line.chi_square, line.freedom, found.condition_substructures[i], found.condition_assembly[i]})
          cells.push_back(csv_number(number));
        text += csv_line(cells);
      }
    }
  }
  for (const impedance::SmoothElement& one : found.smooth) {
    for (std::size_t q = 0; q < one.lines.size(); ++q) {
      const double error = std::sqrt(0.5 * one.fit.variance(static_cast<Eigen::Index>(q)));
      std::vector<std::string> cells =
          value_cells("spline", found.ways.front().elements[one.element], found.frequency_hz[one.lines[q]],
                      one.fit.z(static_cast<Eigen::Index>(q)), error, error);
      cells.resize(cells.size() + 4);
      text += csv_line(cells);
    }
  }
  for (const impedance::LawFit& law : found.laws) {
    for (std::size_t i = 0; i < law.lines.size(); ++i) {
      for (std::size_t e = 0; law.lines[i] && e < found.ways.front().elements.size(); ++e) {
        const auto t = static_cast<Eigen::Index>(e);
        const LineValue& line = *law.lines[i];
        std::vector<std::string> cells = value_cells("law " + impedance::name(law.law), found.ways.front().elements[e],
                                                     found.frequency_hz[i], line.z(t), line.re_error(t), line.im_error(t));
        cells.resize(cells.size() + 4);
        cells[cells.size() - 4] = csv_number(law.by_line[i]);
        text += csv_line(cells);
      }
    }
  }
  return text;
}

}  // namespace jointid::report
