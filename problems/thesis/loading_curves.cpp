#include "problems/thesis/loading_curves.hpp"

#include <algorithm>
#include <array>

#include "friction/law/laws.hpp"
#include "friction/path/ring.hpp"

namespace jointid::problems {
namespace {

constexpr double kg = 9.80665;  // N

/// A row as printed, in the units of its table.
struct PrintedRow {
  std::string_view joint;
  std::array<double, 3> numbers;  ///< as the table's columns; what a law has not is 0
  double limit = 0.0;
  double load = 0.0;  ///< kg or MN/m²
};

/// A table: its law and how a row's numbers become SI values.
struct Table {
  std::string_view number, law;
  bool rotary = false;
  std::vector<double> (*values)(const std::array<double, 3>&);
  double limit_unit = 1.0, load_unit = 1.0;
  std::vector<PrintedRow> rows;
};

const std::vector<Table>& tables() {
  static const std::vector<Table> all = {
      {"2.1", "ren", false, [](const auto& n) -> std::vector<double> { return {1e-8 * n[0], n[1], 1e7 * kg * n[2]}; }, kg, kg,
       {{"50 kg mild steel", {3.43, 2.79, 5.82}, 10.95, 50},
        {"100 kg mild steel", {2.18, 3.90, 8.51}, 23.00, 100},
        {"250 kg brass", {3.19, 3.59, 4.20}, 13.19, 250},
        {"300 kg brass", {1.33, 3.75, 9.12}, 13.55, 300},
        {"300 kg brass, limit preset", {0.53, 4.97, 10.5}, 15.82, 300}}},
      // b of rows 1 and 3 is k/a: the printed 4.50 and 2.87 contradict k and the other rows, where k = ab.
      {"2.2", "shoukry", false, [](const auto& n) -> std::vector<double> { return {kg * n[0], 1e6 * n[1]}; }, kg, kg,
       {{"50 kg mild steel", {11.67, 5.51, 0}, 11.67, 50},
        {"100 kg mild steel", {16.87, 5.28, 0}, 16.87, 100},
        {"250 kg brass", {12.54, 3.36, 0}, 12.54, 250},
        {"300 kg brass", {12.58, 7.14, 0}, 12.58, 300},
        {"300 kg brass, limit preset", {15.05, 5.39, 0}, 15.05, 300}}},
      {"2.3", "burdekin", false, [](const auto& n) -> std::vector<double> { return {1e7 * kg * n[0], 1e13 * kg * n[1]}; }, kg, kg,
       {{"50 kg mild steel", {5.60, -8.09, 0}, 9.742, 50},
        {"100 kg mild steel", {8.55, -15.86, 0}, 11.54, 100},
        {"250 kg brass", {3.75, -3.68, 0}, 9.79, 250},
        {"300 kg brass", {8.06, -16.41, 0}, 9.90, 300}}},
      {"2.4", "ren", true, [](const auto& n) -> std::vector<double> { return {1e-8 * n[0], n[1], 1e11 * n[2]}; }, 1e5, 1e6,
       {{"G/G 1.5 MN/m²", {1.04, 4.856, 9.49}, 2.59, 1.5},
        {"G/G 2 MN/m²", {1.61, 4.292, 11.34}, 3.08, 2},
        {"G/G 3 MN/m²", {1.75, 4.267, 15.41}, 4.44, 3},
        {"G/G 4 MN/m²", {1.81, 4.401, 19.16}, 6.39, 4},
        {"G/G 6 MN/m²", {2.06, 4.200, 28.00}, 8.87, 6},
        {"G/H 2 MN/m²", {0.77, 4.329, 22.20}, 2.95, 2},
        {"G/H 4 MN/m²", {0.32, 5.587, 44.50}, 6.57, 4},
        {"G/H 9 MN/m²", {1.90, 2.901, 63.67}, 7.19, 9},
        {"G/H 9 MN/m², limit preset", {0.368, 5.616, 77.00}, 13.82, 9}}},
      {"2.5", "shoukry", true, [](const auto& n) -> std::vector<double> { return {1e5 * n[0], 1e6 * n[1]}; }, 1e5, 1e6,
       {{"G/G 1.5 MN/m²", {2.65, 2.70, 0}, 2.65, 1.5},
        {"G/G 2 MN/m²", {3.15, 3.03, 0}, 3.15, 2},
        {"G/G 3 MN/m²", {4.52, 2.88, 0}, 4.51, 3},
        {"G/G 4 MN/m²", {6.52, 2.41, 0}, 6.51, 4},
        {"G/G 6 MN/m²", {8.50, 2.69, 0}, 8.50, 6},
        {"G/H 2 MN/m²", {2.90, 6.53, 0}, 2.90, 2},
        {"G/H 4 MN/m²", {5.94, 5.37, 0}, 5.94, 4},
        {"G/H 9 MN/m²", {7.27, 9.60, 0}, 7.27, 9},
        {"G/H 9 MN/m², limit preset", {13.82, 4.07, 0}, 13.82, 9}}},
      {"2.6", "burdekin", true, [](const auto& n) -> std::vector<double> { return {1e11 * n[0], -1e17 * n[1]}; }, 1e5, 1e6,
       {{"G/G 1.5 MN/m²", {5.83, 3.54, 0}, 2.34, 1.5},
        {"G/G 2 MN/m²", {7.74, 5.13, 0}, 2.92, 2},
        {"G/G 3 MN/m²", {10.98, 7.58, 0}, 3.97, 3},
        {"G/G 4 MN/m²", {12.67, 6.90, 0}, 5.82, 4},
        {"G/G 6 MN/m²", {21.24, 15.98, 0}, 7.06, 6},
        {"G/H 2 MN/m²", {16.00, 25.38, 0}, 2.52, 2},
        {"G/H 4 MN/m²", {27.88, 39.72, 0}, 4.89, 4},
        {"G/H 9 MN/m²", {65.55, 202.60, 0}, 5.30, 9}}},
      // a of the last row is printed as 8.90, ten times what its limit ka says.
      {"2.7", "bilinear", true, [](const auto& n) -> std::vector<double> { return {1e-7 * n[0], 1e11 * n[2]}; }, 1e5, 1e6,
       {{"G/G 1.5 MN/m²", {4.77, 0, 4.84}, 2.30, 1.5},
        {"G/G 2 MN/m²", {4.74, 0, 6.03}, 2.87, 2},
        {"G/G 3 MN/m²", {4.16, 0, 8.94}, 3.72, 3},
        {"G/G 4 MN/m²", {5.28, 0, 10.45}, 5.51, 4},
        {"G/G 6 MN/m²", {3.86, 0, 16.93}, 6.54, 6},
        {"G/H 2 MN/m²", {1.77, 0, 13.07}, 2.32, 2},
        {"G/H 4 MN/m²", {2.08, 0, 22.09}, 4.59, 4},
        {"G/H 9 MN/m²", {0.890, 0, 52.96}, 4.72, 9}}},
  };
  return all;
}

std::vector<LoadingCurve> made() {
  std::vector<LoadingCurve> out;
  for (const Table& table : tables()) {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const PrintedRow& row = table.rows[i];
      LoadingCurve curve;
      const std::string number(table.number);
      curve.name = "table" + number + "-" + std::to_string(i + 1);
      curve.description = "loading curve, Table " + number + ": " + std::string(row.joint) + ", " + std::string(table.law) +
                          (table.rotary ? ", rotary joint of rings" : "");
      curve.law = table.law;
      curve.values = table.values(row.numbers);
      if (table.rotary) curve.ring = Ring{};
      curve.normal_load = table.load_unit * row.load;
      curve.printed_limit = table.limit_unit * row.limit;
      out.push_back(std::move(curve));
    }
  }
  return out;
}

}  // namespace

std::unique_ptr<friction::Element> element_of(const LoadingCurve& problem) {
  auto law = friction::make_element(problem.law, problem.values);
  if (!problem.ring) return law;
  return std::make_unique<friction::Ring>(std::move(law), problem.ring->inner, problem.ring->outer);
}

const std::vector<LoadingCurve>& loading_curves() {
  static const std::vector<LoadingCurve> all = made();
  return all;
}

const LoadingCurve* find_loading_curve(const std::string& name) {
  const auto& all = loading_curves();
  const auto found = std::ranges::find(all, name, &LoadingCurve::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace jointid::problems
