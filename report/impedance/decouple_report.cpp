#include "report/impedance/decouple_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/statistics.hpp"
#include "base/text.hpp"
#include "report/json_value.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using impedance::Decoupled;
using impedance::DecoupledLine;
using impedance::DecoupledWay;

Json complex_rows(const Eigen::MatrixXcd& matrix) {
  Json out = Json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) row.push_back({value(matrix(r, c).real()), value(matrix(r, c).imag())});
    out.push_back(row);
  }
  return out;
}

Json variance_rows(const DecoupledLine& line) {
  Json out = Json::array();
  for (Eigen::Index r = 0; r < line.h.rows(); ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < line.h.cols(); ++c) row.push_back(value(line.variance_re(r, c) + line.variance_im(r, c)));
    out.push_back(row);
  }
  return out;
}

Json dof_names(const std::vector<frf::Dof>& dofs) {
  Json out = Json::array();
  for (const frf::Dof& dof : dofs) out.push_back(dof.name());
  return out;
}

Json way_of(const DecoupledWay& way) {
  Json out = {{"way", impedance::name(way.way)}, {"dofs", dof_names(way.dofs)}, {"lines", Json::array()}};
  for (const auto& line : way.lines) {
    if (!line) {
      out["lines"].push_back(nullptr);
      continue;
    }
    Json one = {{"frf", complex_rows(line->h)}, {"variance", variance_rows(*line)}};
    one["singular_values"] =
        values(std::span(line->singular_values.data(), static_cast<std::size_t>(line->singular_values.size())));
    out["lines"].push_back(one);
  }
  return out;
}

Json stiffness_of(const impedance::IdentifiedLines& lines) {
  Json out = {{"elements", Json::array()}, {"lines", Json::array()}};
  for (const auto& element : lines.likelihood.elements) out["elements"].push_back(element.name);
  for (const auto& line : lines.likelihood.lines) {
    if (!line) {
      out["lines"].push_back(nullptr);
      continue;
    }
    Json one = {{"z", Json::array()},
                {"variance", Json::array()},
                {"std_error", Json::array()},
                {"chi_square", value(line->chi_square)},
                {"degrees_of_freedom", value(line->freedom)}};
    for (Eigen::Index t = 0; t < line->z.size(); ++t) {
      one["z"].push_back({value(line->z(t).real()), value(line->z(t).imag())});
      one["variance"].push_back(value(line->variance(t)));
      one["std_error"].push_back({value(line->re_error(t)), value(line->im_error(t))});
    }
    out["lines"].push_back(one);
  }
  return out;
}

/// Errors over FRFs, their median over lines, of every FRF of one triangle at the interface.
Table error_table(const Decoupled& found) {
  Table table({{"FRF of B", Align::left}, {"way", Align::left}, {"lines"}, {"std error / |H|, median"}});
  for (const DecoupledWay& way : found.ways) {
    const auto size = std::min<Eigen::Index>(4, static_cast<Eigen::Index>(way.dofs.size()));
    for (Eigen::Index r = 0; r < size; ++r) {
      for (Eigen::Index c = r; c < size; ++c) {
        std::vector<double> all;
        for (const auto& line : way.lines) {
          if (line) all.push_back(std::sqrt(line->variance_re(r, c) + line->variance_im(r, c)) / std::abs(line->h(r, c)));
        }
        table.add({way.dofs[static_cast<std::size_t>(r)].name() + "/" + way.dofs[static_cast<std::size_t>(c)].name(),
                   impedance::name(way.way), std::to_string(all.size()), fmt::format("{:.2g}", median(all))});
      }
    }
  }
  return table;
}

}  // namespace

std::string decouple_text(const impedance::DecoupleScene& scene, const Decoupled& found, const std::string& file) {
  std::string text = scene.lines.scene.title.empty() ? "" : scene.lines.scene.title + "\n";
  text += fmt::format("B from AB and A at {}, {} lines, {:.6g} to {:.6g} Hz\n",
                      comma_list(scene.interface, [](const frf::Dof& dof) { return dof.name(); }), found.frequency_hz.size(),
                      found.frequency_hz.front(), found.frequency_hz.back());
  if (found.likelihood.freedom > 0.0) {
    text += fmt::format("χ² = {:.5g} of {:.0f} degrees of freedom, χ²/f = {:.3g} (chance leaves up to {:.3g})\n",
                        found.likelihood.chi_square, found.likelihood.freedom,
                        found.likelihood.chi_square / found.likelihood.freedom, found.likelihood.likely);
  }
  text += error_table(found).text();
  text += notes_text(found.notes);
  text += "FRFs of B by way \"" + impedance::name(found.ways.front().way) + "\": " + file + "\n";
  return text + "status: " + name(found.status) + (found.message.empty() ? "" : ": " + found.message) + "\n";
}

std::string decouple_json(const impedance::DecoupleScene& scene, const Decoupled& found, const std::string& file) {
  Json out = {{"kind", "decouple"},
              {"title", scene.lines.scene.title},
              {"status", name(found.status)},
              {"message", found.message},
              {"file", file},
              {"interface", dof_names(scene.interface)},
              {"frequency_hz", values(found.frequency_hz)},
              {"chi_square", value(found.likelihood.chi_square)},
              {"degrees_of_freedom", value(found.likelihood.freedom)},
              {"notes", found.notes},
              {"stiffness_of_b", stiffness_of(found.likelihood)},
              {"ways", Json::array()}};
  for (const DecoupledWay& way : found.ways) out["ways"].push_back(way_of(way));
  return json_text(out);
}

std::string decouple_csv(const Decoupled& found) {
  std::string text = csv_line({"way", "response", "reference", "frequency_hz", "re", "im", "std_error_re", "std_error_im"});
  for (const DecoupledWay& way : found.ways) {
    for (std::size_t r = 0; r < way.dofs.size(); ++r) {
      for (std::size_t c = 0; c < way.dofs.size(); ++c) {
        for (std::size_t i = 0; i < way.lines.size(); ++i) {
          if (!way.lines[i]) continue;
          const auto row = static_cast<Eigen::Index>(r), column = static_cast<Eigen::Index>(c);
          const Complex h = way.lines[i]->h(row, column);
          text +=
              csv_line({impedance::name(way.way), way.dofs[r].name(), way.dofs[c].name(), csv_number(found.frequency_hz[i]),
                        csv_number(h.real()), csv_number(h.imag()), csv_number(std::sqrt(way.lines[i]->variance_re(row, column))),
                        csv_number(std::sqrt(way.lines[i]->variance_im(row, column)))});
        }
      }
    }
  }
  return text;
}

}  // namespace jointid::report
