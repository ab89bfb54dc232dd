#include "friction/joint/fe_cases.hpp"

#include <array>
#include <cmath>

#include "friction/law/bilinear.hpp"
#include "friction/law/ren.hpp"
#include "friction/path/scaled.hpp"

namespace jointid::friction {
namespace {

constexpr double steel = 2.06e11;  // N/m²
constexpr double width = 0.01;     // m
constexpr double begin = 5e-8, spread = 3.0, stiffness = 2e12;

/// A law per area over the width.
std::shared_ptr<const Element> per_length(std::shared_ptr<const Element> law) {
  return std::make_shared<Scaled>(std::move(law), width);
}

std::shared_ptr<const Element> law_of(CaseThreeLaw law) {
  const auto ren = std::make_shared<Ren>(std::array{begin, spread, stiffness});
  if (law == CaseThreeLaw::ren) return ren;
  const double slip = law == CaseThreeLaw::same_stiffness ? ren->limit() / stiffness : ren->kinks().back();
  return std::make_shared<Bilinear>(std::array{slip, ren->limit() / slip});
}

/// Height (m), length (m) and interface stiffness (1e12 N/m/m²) of a row of table 2.8; W = 0.01 m, a = 5e-8 m, b = 3 in all.
struct Row {
  double height, length, stiffness;
};

constexpr std::array table_2_8 = {
    Row{0.005, 0.01, 1}, Row{0.006, 0.01, 2}, Row{0.007, 0.01, 3},  Row{0.008, 0.01, 4},  Row{0.010, 0.01, 5},
    Row{0.011, 0.01, 6}, Row{0.012, 0.01, 7}, Row{0.013, 0.01, 8},  Row{0.014, 0.01, 9},  Row{0.015, 0.01, 10},
    Row{0.017, 0.01, 10}, Row{0.018, 0.01, 10}, Row{0.019, 0.01, 10}, Row{0.020, 0.01, 8},  Row{0.020, 0.01, 6},
    Row{0.020, 0.02, 4}, Row{0.018, 0.02, 3}, Row{0.014, 0.02, 2},  Row{0.010, 0.02, 2},  Row{0.008, 0.02, 1}};

std::shared_ptr<const Element> row_law(double units) {
  return per_length(std::make_shared<Ren>(std::array{5e-8, 3.0, units * 1e12}));
}

}  // namespace

MenqBar::Values case_one() {
  const double slip = law_of(CaseThreeLaw::same_stiffness)->kinks().front();
  return {.axial_stiffness = steel * width * width,
          .length = 1.0,
          .interface_stiffness = stiffness * width,
          .slip_force = stiffness * width * slip,
          .end_spring = 0.0};
}

JointMesh menq_mesh(const MenqBar::Values& bar, std::size_t members) {
  const double slip = bar.slip_force / bar.interface_stiffness;
  const auto law = std::make_shared<Bilinear>(std::array{slip, bar.interface_stiffness});
  JointMesh mesh = uniform_mesh(MemberKind::bar, members, {bar.length, bar.axial_stiffness}, law);
  mesh.end_spring = bar.end_spring;
  return mesh;
}

JointMesh case_two() {
  JointMesh mesh;
  for (const Row& row : table_2_8) {
    mesh.members.push_back({row.length, steel * width * row.height});
    mesh.interface.push_back(row_law(row.stiffness));
  }
  mesh.interface.push_back(row_law(1));
  return mesh;
}

JointMesh case_three(CaseThreeLaw law, double length, std::size_t members) {
  return uniform_mesh(MemberKind::bar, members, {length, steel * width * width}, per_length(law_of(law)));
}

}  // namespace jointid::friction
