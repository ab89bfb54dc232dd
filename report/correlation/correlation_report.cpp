#include "report/correlation/correlation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text.hpp"
#include "correlation/common_places.hpp"
#include "report/json_value.hpp"
#include "report/text/frf_criteria.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using correlation::CorrelatedFrfs;
using correlation::CorrelatedModes;
using correlation::ExpandedFrfs;
using correlation::FrfAgreement;
using correlation::LineAgreement;

constexpr std::size_t most_rows = 12;

constexpr const char* what_criteria_miss =
    "FRAC and shape do not see a factor, LAC does not see phase, none knows of noise: χ²/f does (1: the difference is noise).\n";

/// Those with a number first, the least FRAC at the top.
std::vector<FrfAgreement> by_frac(const CorrelatedFrfs& found) {
  std::vector<FrfAgreement> out = found.frfs;
  std::ranges::stable_sort(out, {}, [](const FrfAgreement& each) { return std::isnan(each.frac) ? 2.0 : each.frac; });
  return out;
}

std::string ratio_text(double ratio) { return std::isfinite(ratio) ? fmt::format("{:.3g}", ratio) : "–"; }

std::string frf_table(const CorrelatedFrfs& found) {
  Table table({{"FRF", Align::left}, {"lines"}, {"FRAC"}, {"LAC, mean"}, {"coherence, mean"}, {"error, dB"}, {"χ²/f"}});
  const std::vector<FrfAgreement> all = by_frac(found);
  for (std::size_t i = 0; i < std::min(most_rows, all.size()); ++i) {
    const FrfAgreement& each = all[i];
    table.add({each.response.name() + "/" + each.reference.name(), std::to_string(each.lines), criterion_text(each.frac),
               criterion_text(each.lac), criterion_text(each.coherence), number(each.error_db), ratio_text(each.ratio())});
  }
  std::string text = table.text();
  if (all.size() > most_rows) text += fmt::format("  the {} of least FRAC of {}; --csv has all\n", most_rows, all.size());
  return text;
}

/// The lines of least value.
std::string worst_lines(const CorrelatedFrfs& found, double LineAgreement::*criterion_of) {
  constexpr std::size_t most = 3;
  std::vector<LineAgreement> lines = found.lines;
  std::erase_if(lines, [&](const LineAgreement& each) { return std::isnan(each.*criterion_of); });
  if (lines.empty()) return "–";
  std::ranges::stable_sort(lines, {}, criterion_of);
  lines.resize(std::min(most, lines.size()));
  return comma_list(lines, [&](const LineAgreement& each) {
    return fmt::format("{:.4f} at {:.6g} Hz", each.*criterion_of, each.frequency_hz);
  });
}

Json names_of(const ComparedFiles& files) { return Json::array({files.one, files.other}); }

Json dof_names(const std::vector<frf::Dof>& dofs) {
  Json out = Json::array();
  for (const std::string& name : frf::names(dofs)) out.push_back(name);
  return out;
}

Json rows_of(const Eigen::MatrixXd& matrix) {
  Json out = Json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    const Eigen::VectorXd row = matrix.row(r);
    out.push_back(values(std::span(row.data(), static_cast<std::size_t>(row.size()))));
  }
  return out;
}

Json list_of(const Eigen::VectorXd& vector) { return values(std::span(vector.data(), static_cast<std::size_t>(vector.size()))); }

/// The mode that a mode of the first file is paired with.
struct Partner {
  double frequency_hz, mac;
};

std::optional<Partner> partner_of(const CorrelatedModes& found, std::size_t mode) {
  if (!found.partner[mode]) return std::nullopt;
  return Partner{found.other_hz[*found.partner[mode]],
                 found.mac(static_cast<Eigen::Index>(mode), static_cast<Eigen::Index>(*found.partner[mode]))};
}

}  // namespace

std::string correlation_text(const ComparedFiles& files, const CorrelatedFrfs& found) {
  std::string text =
      fmt::format("{} against {}: {} FRFs, {} lines, {:.6g} to {:.6g} Hz\n", files.other, files.one, found.frfs.size(),
                  found.lines.size(), found.lines.front().frequency_hz, found.lines.back().frequency_hz);
  text += frf_table(found);
  text += "least shape criterion of a line       " + worst_lines(found, &LineAgreement::shape) + "\n";
  text += "least amplitude criterion of a line   " + worst_lines(found, &LineAgreement::amplitude) + "\n";
  if (found.freedom > 0.0) {
    text += fmt::format("χ² / degrees of freedom = {:.5g} / {:.0f} = {:.4g}\n", found.chi_square, found.freedom, found.ratio());
  } else {
    text += "χ²: neither file states its noise\n";
  }
  return text + what_criteria_miss + notes_text(files.notes);
}

std::string correlation_json(const ComparedFiles& files, const CorrelatedFrfs& found,
                             const correlation::ShapesOverLines* shapes) {
  Json out = {{"files", names_of(files)},
              {"notes", files.notes},
              {"chi_square", value(found.freedom > 0.0 ? std::optional(found.chi_square) : std::nullopt)},
              {"degrees_of_freedom", value(found.freedom)},
              {"frfs", Json::array()},
              {"lines", Json::array()}};
  for (const FrfAgreement& each : found.frfs) {
    out["frfs"].push_back({{"response", each.response.name()},
                           {"reference", each.reference.name()},
                           {"lines", each.lines},
                           {"frac", value(each.frac)},
                           {"lac", value(each.lac)},
                           {"coherence", value(each.coherence)},
                           {"error_db", value(each.error_db)},
                           {"chi_square", value(each.chi_square)},
                           {"degrees_of_freedom", value(each.freedom)}});
  }
  for (const LineAgreement& each : found.lines)
    out["lines"].push_back(
        {{"frequency_hz", each.frequency_hz}, {"shape", value(each.shape)}, {"amplitude", value(each.amplitude)}});
  if (shapes != nullptr) out["fdac"] = {{"frequency_hz", values(shapes->frequency_hz)}, {"rows", rows_of(shapes->fdac)}};
  return json_text(out);
}

std::string correlation_csv(const CorrelatedFrfs& found) {
  std::string text =
      csv_line({"response", "reference", "lines", "frac", "lac", "coherence", "error_db", "chi_square", "degrees_of_freedom"});
  for (const FrfAgreement& each : found.frfs) {
    text += csv_line({each.response.name(), each.reference.name(), std::to_string(each.lines), csv_number(each.frac),
                      csv_number(each.lac), csv_number(each.coherence), csv_number(each.error_db), csv_number(each.chi_square),
                      csv_number(each.freedom)});
  }
  return text;
}

std::string correlation_text(const ComparedFiles& files, const CorrelatedModes& found) {
  std::string text = fmt::format("{} against {}: {} and {} modes at {} coordinates, {} pairs\n", files.other, files.one,
                                 found.one_hz.size(), found.other_hz.size(), found.dofs.size(), found.pairs());
  Table modes({{"mode"}, {"frequency, Hz"}, {"partner, Hz"}, {"apart"}, {"MAC"}});
  for (std::size_t r = 0; r < found.one_hz.size(); ++r) {
    const auto partner = partner_of(found, r);
    modes.add({std::to_string(r + 1), number(found.one_hz[r]), partner ? number(partner->frequency_hz) : "–",
               partner ? fmt::format("{:+.2f} %", 100.0 * (partner->frequency_hz / found.one_hz[r] - 1.0)) : "–",
               partner ? fmt::format("{:.4f}", partner->mac) : "–"});
  }
  text += modes.text();
  if (found.pairs() == 0) return text + "no pair of modes has a MAC of 0.5: CoMAC is not known\n";
  Table places({{"coordinate", Align::left}, {"CoMAC"}, {"ECoMAC"}});
  std::vector<Eigen::Index> order(found.dofs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
  std::ranges::stable_sort(order, std::ranges::greater(), [&](Eigen::Index i) { return found.ecomac(i); });
  for (std::size_t i = 0; i < std::min(most_rows, order.size()); ++i) {
    places.add({found.dofs[static_cast<std::size_t>(order[i])].name(), criterion_text(found.comac(order[i])),
                criterion_text(found.ecomac(order[i]))});
  }
  text += "coordinates that agree least (1 is best for CoMAC, 0 for ECoMAC)\n" + places.text();
  return text + "Shapes have no scale here: a sensor of wrong gain shows by ECoMAC, one of wrong sign by both.\n";
}

std::string correlation_json(const ComparedFiles& files, const CorrelatedModes& found) {
  Json out = {{"files", names_of(files)},
              {"dofs", dof_names(found.dofs)},
              {"modes", Json::array()},
              {"mac", rows_of(found.mac)},
              {"comac", list_of(found.comac)},
              {"ecomac", list_of(found.ecomac)},
              {"other_frequency_hz", values(found.other_hz)}};
  for (std::size_t r = 0; r < found.one_hz.size(); ++r) {
    Json mode = {{"frequency_hz", found.one_hz[r]}, {"partner", nullptr}};
    if (found.partner[r]) mode["partner"] = *found.partner[r] + 1;
    out["modes"].push_back(mode);
  }
  return json_text(out);
}

std::string correlation_csv(const CorrelatedModes& found) {
  std::string text = csv_line({"mode", "frequency_hz", "partner", "partner_frequency_hz", "mac"});
  for (std::size_t r = 0; r < found.one_hz.size(); ++r) {
    const auto partner = partner_of(found, r);
    text += csv_line({std::to_string(r + 1), csv_number(found.one_hz[r]), partner ? std::to_string(*found.partner[r] + 1) : "",
                      partner ? csv_number(partner->frequency_hz) : "", partner ? csv_number(partner->mac) : ""});
  }
  return text;
}

std::string expansion_text(const ExpansionNames& names, const ExpandedFrfs& found) {
  const frf::FrfHeader& header = found.set.header;
  const bool by_modes = names.way == "serep";
  std::string text =
      fmt::format("{} expanded by {}, {}: {} measured coordinates, {} × {} FRFs, {} lines\n", names.measured, names.parent,
                  names.way, found.measured.size(), header.response.size(), header.reference.size(), header.lines());
  text += fmt::format("{} {:.3g} of the measured FRFs\n",
                      by_modes ? "the modes do not carry" : "the parent is off, where it was measured, by", found.parent_error);
  if (!found.left_out.empty()) text += "not used: " + correlation::some_names(found.left_out) + "\n";
  text +=
      by_modes
          ? "Modes that are not kept are not in the expanded FRFs.\n"
          : "Where nothing was measured the dynamic stiffness stays that of the parent (exactly so by way semm). A joint there\n"
            "is the parent's: do not identify it from these FRFs.\n";
  return text + notes_text(names.notes) + "FRFs without variances: " + names.out + "\n";
}

std::string expansion_json(const ExpansionNames& names, const ExpandedFrfs& found) {
  return json_text({{"files", Json::array({names.parent, names.measured})},
                    {"notes", names.notes},
                    {"way", names.way},
                    {"file", names.out},
                    {"measured", dof_names(found.measured)},
                    {"left_out", dof_names(found.left_out)},
                    {"dofs", dof_names(found.set.header.response)},
                    {"lines", found.set.header.lines()},
                    {"parent_error", value(found.parent_error)}});
}

}  // namespace jointid::report
