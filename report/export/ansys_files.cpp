#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "report/export/export_parts.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t side = 12;  ///< of MATRIX27: six DOFs of two nodes

std::string remark_line(const std::string& text) { return "! " + text + "\n"; }

std::string apdl(double value) { return value == 0.0 ? "0" : fmt::format("{:.15E}", value); }

/// Real constants, six a line.
std::string constants(std::size_t number, const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); i += 6) {
    text += i == 0 ? fmt::format("R,{}", number) : std::string("RMORE");
    for (std::size_t j = i; j < std::min(values.size(), i + 6); ++j) text += "," + apdl(values[j]);
    text += "\n";
  }
  return text;
}

/// Numbers elements, types and sets of real constants with one counter, and makes the node of the ground when somebody needs it.
class AnsysCards {
 public:
  explicit AnsysCards(const ExportedMatrices& of) : of_(of), id_(of.options().first_id) {
    for (const frf::Dof& dof : of.dofs()) nodes_.insert(dof.node);
  }

  std::string text() const {
    std::string head;
    for (const std::string& line : of_.head()) head += remark_line(line);
    head += "/PREP7\n";
    if (uses_ground_)
      head += remark_line("the ground: a fixed node of the next number") +
              "*GET,JGROUND,NODE,,NUM,MAX\nJGROUND=JGROUND+1\nN,JGROUND\nD,JGROUND,ALL,0\n";
    return head + text_;
  }

  /// KEYOPT(3) of MATRIX27: 2 mass, 4 stiffness, 5 viscous damping, 6 structural damping.
  void add_matrix(Kind kind) {
    if (!of_.has(kind)) return;
    if (kind == Kind::hysteretic_damping)
      text_ += remark_line("KEYOPT(3) = 6: structural damping matrix, of full harmonic analyses; see MATRIX27 of your release");
    const int option = kind == Kind::mass ? 2 : kind == Kind::stiffness ? 4 : kind == Kind::viscous_damping ? 5 : 6;
    const std::size_t type = id_++;
    text_ += fmt::format("ET,{0},MATRIX27\nKEYOPT,{0},2,0\nKEYOPT,{0},3,{1}\n", type, option);
    std::set<std::int64_t> done;  // nodes whose own block stands in an element
    const std::vector<std::int64_t> all(nodes_.begin(), nodes_.end());
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = a + 1; b < all.size(); ++b) add_pair(kind, type, all[a], all[b], done);
    }
    if (all.size() == 1) add_pair(kind, type, all.front(), ground, done);
  }

  void add_spring(const Link& link) {
    const frf::Dof& first = of_.dofs()[link.first];
    if (link.second && of_.dofs()[*link.second].direction != first.direction)
      of_.refuse(of_.remark(link.by_kind.begin()->first, link) + ": COMBIN14 has one direction",
                 "write whole matrices: --as matrix");
    const CardValue k = link.of(Kind::stiffness), c = link.of(Kind::viscous_damping);
    if (k.value == 0.0 && c.value == 0.0) return;
    const std::size_t number = id_++;
    for (const Kind kind : {Kind::stiffness, Kind::viscous_damping}) {
      if (link.has(kind)) text_ += remark_line(of_.remark(kind, link));
    }
    text_ += fmt::format("ET,{0},COMBIN14\nKEYOPT,{0},2,{1}\n", number, component(first)) +
             constants(number, {k.value, c.value}) +
             element(number, number, node(first.node), link.second ? node(of_.dofs()[*link.second].node) : node(ground));
  }

 private:
  static constexpr std::int64_t ground = 0;

  std::string node(std::int64_t number) {
    if (number != ground) return std::to_string(number);
    uses_ground_ = true;
    return "JGROUND";
  }

  std::string element(std::size_t type, std::size_t real, const std::string& first, const std::string& second) {
    return fmt::format("TYPE,{}\nREAL,{}\nEN,{},{},{}\n", type, real, id_++, first, second);
  }

  /// The block between two nodes, and those of each that no element has yet; the upper triangle row by row.
  void add_pair(Kind kind, std::size_t type, std::int64_t first, std::int64_t second, std::set<std::int64_t>& done) {
    const bool own_first = done.insert(first).second, own_second = done.insert(second).second;
    std::array<std::array<double, side>, side> block{};
    std::string remarks;
    for (std::size_t i = 0; i < of_.size(); ++i) {
      for (std::size_t j = i; j < of_.size(); ++j) {
        const frf::Dof &row = of_.dofs()[i], &column = of_.dofs()[j];
        const bool pair = (row.node == first && column.node == second) || (row.node == second && column.node == first);
        const bool own = row.node == column.node && ((row.node == first && own_first) || (row.node == second && own_second));
        const double value = of_.at(kind, i, j).value;
        if ((!pair && !own) || value == 0.0) continue;
        const auto place = [&](const frf::Dof& dof) {
          return static_cast<std::size_t>(component(dof) - 1) + (dof.node == first ? 0 : 6);
        };
        block[std::min(place(row), place(column))][std::max(place(row), place(column))] = value;
        remarks += remark_line(of_.remark(kind, i, j));
      }
    }
    if (remarks.empty()) return;
    std::vector<double> values;
    for (std::size_t i = 0; i < side; ++i)
      values.insert(values.end(), block[i].begin() + static_cast<std::ptrdiff_t>(i), block[i].end());
    const std::size_t real = id_++;
    text_ += remarks + constants(real, values);
    text_ += element(type, real, node(first), node(second));
  }

  const ExportedMatrices& of_;
  std::size_t id_;
  std::set<std::int64_t> nodes_;
  bool uses_ground_ = false;
  std::string text_;
};

}  // namespace

std::vector<ExportFile> ansys_files(const ExportedMatrices& of, ExportWay way) {
  if (!of.is_symmetric()) {
    of.refuse("the joint has a matrix that is not symmetric, which is written for no MATRIX27",
              "write it for nastran, abaqus or matrix-market, or identify symmetric matrices");
  }
  if (way == ExportWay::bush) of.refuse("there is no bush for ansys", "write --as springs or --as matrix");
  AnsysCards cards(of);
  if (way == ExportWay::springs) {
    for (const Link& link : of.links()) cards.add_spring(link);
    cards.add_matrix(Kind::mass);
    cards.add_matrix(Kind::hysteretic_damping);
  } else {
    for (const Kind kind : restrictions::all_kinds) cards.add_matrix(kind);
  }
  return {{".inp", cards.text()}};
}

}  // namespace jointid::report
