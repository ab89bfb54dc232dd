#include "card_readers.hpp"

#include <algorithm>
#include <complex>
#include <sstream>
#include <stdexcept>

namespace jointid::cards {
namespace {

using Fields = std::vector<std::string>;

std::string stripped(std::string text) {
  const auto blank = [](char c) { return c == ' ' || c == '\r'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  while (!text.empty() && blank(text.front())) text.erase(text.begin());
  return text;
}

Fields split(const std::string& line, char at) {
  Fields out;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, at);) out.push_back(stripped(cell));
  return out;
}

Fields lines_of(const std::string& text) { return split(text, '\n'); }

double number(std::string text) {
  if (text.empty()) return 0.0;
  const std::size_t sign = text.find_first_of("+-", 1);
  if (text.find('E') == std::string::npos && sign != std::string::npos) text.insert(sign, "E");
  std::size_t used = 0;
  const double value = std::stod(text, &used);
  if (used != text.size()) throw std::runtime_error("no number: " + text);
  return value;
}

int place(const std::vector<frf::Dof>& dofs, long node, int component) {
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    if (dofs[i].node == node && static_cast<int>(dofs[i].direction) == component) return static_cast<int>(i);
  }
  throw std::runtime_error("no DOF " + std::to_string(node) + ":" + std::to_string(component));
}

/// Between i and j, or i and the ground (−1).
void add_link(Eigen::MatrixXd& to, int i, int j, double value) {
  to(i, i) += value;
  if (j < 0) return;
  to(j, j) += value;
  to(i, j) -= value;
  to(j, i) -= value;
}

/// Cards with their continuations joined, blanks where a field is empty.
std::vector<Fields> large_fields(const std::string& text) {
  std::vector<Fields> cards;
  for (const std::string& raw : lines_of(text)) {
    if (raw.empty() || raw[0] == '$') continue;
    std::string line = raw;
    line.resize(72, ' ');
    const std::string name = stripped(line.substr(0, 8));
    if (name.empty() || name.back() != '*') throw std::runtime_error("no large field: " + raw);
    if (name != "*") cards.push_back({name.substr(0, name.size() - 1)});
    for (std::size_t i = 0; i < 4; ++i) cards.back().push_back(stripped(line.substr(8 + 16 * i, 16)));
  }
  return cards;
}

struct Dmig {
  bool symmetric = true;
  std::vector<std::tuple<int, int, std::complex<double>>> elements;
};

class NastranReader {
 public:
  NastranReader(const std::string& text, const std::vector<frf::Dof>& dofs) : dofs_(dofs), out_(dofs.size()) {
    for (const std::string& line : lines_of(text)) {
      const std::string mark = "$ case control: ";
      if (!line.starts_with(mark)) continue;
      const Fields words = split(line.substr(mark.size()), '=');
      selected_[words.at(1)] = words.at(0);
    }
    cards_ = large_fields(text);
    for (const Fields& card : cards_) {
      if (card[0] == "PBUSH") properties_[card[1]] = card;
    }
    for (const Fields& card : cards_) read(card);
    for (const auto& [name, matrix] : matrices_) assemble(name, matrix);
  }

  Assembled result() const { return out_; }

 private:
  int dof(const std::string& grid, const std::string& component) const {
    return grid.empty() ? -1 : place(dofs_, std::stol(grid), std::stoi(component));
  }

  void read(const Fields& card) {
    if (card[0] == "CELAS2") {
      add_link(out_.k, dof(card[3], card[4]), dof(card[5], card[6]), number(card[2]));
      if (card.size() > 7) add_link(out_.d, dof(card[3], card[4]), dof(card[5], card[6]), number(card[2]) * number(card[7]));
    } else if (card[0] == "CDAMP2" || card[0] == "CMASS2") {
      add_link(card[0] == "CDAMP2" ? out_.c : out_.m, dof(card[3], card[4]), dof(card[5], card[6]), number(card[2]));
    } else if (card[0] == "CBUSH") {
      read_bush(card);
    } else if (card[0] == "DMIG") {
      read_dmig(card);
    } else if (card[0] != "PBUSH") {
      throw std::runtime_error("card " + card[0]);
    }
  }

  void read_bush(const Fields& card) {
    if (card.at(8) != "0") throw std::runtime_error("CID of " + card[1]);
    const Fields& property = properties_.at(card[2]);
    std::map<std::string, std::array<double, 6>> rows;
    for (std::size_t row = 1; row + 7 < property.size() + 8; row += 8) {  // eight fields a row, PID or blank first
      if (row + 1 >= property.size() || property[row + 1].empty()) break;
      for (std::size_t i = 0; i < 6 && row + 2 + i < property.size(); ++i)
        rows[property[row + 1]][i] = number(property[row + 2 + i]);
    }
    for (int i = 0; i < 6; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (rows["K"][at] == 0.0 && rows["B"][at] == 0.0) continue;
      const std::string component = std::to_string(i + 1);
      const int a = dof(card[3], component), b = dof(card[4], component);
      add_link(out_.k, a, b, rows["K"][at]);
      add_link(out_.c, a, b, rows["B"][at]);
      add_link(out_.d, a, b, rows["K"][at] * rows["GE"][at]);
    }
  }

  void read_dmig(const Fields& card) {
    Dmig& matrix = matrices_[card[1]];
    if (card[2] == "0") {
      matrix.symmetric = card[3] == "6";
      if (!matrix.symmetric && (card[3] != "1" || card.at(8).empty())) throw std::runtime_error("form of DMIG");
      return;
    }
    const int column = dof(card[2], card[3]);
    for (std::size_t i = 5; i + 3 < card.size() && !card[i].empty(); i += 4)
      matrix.elements.emplace_back(dof(card[i], card[i + 1]), column,
                                   std::complex<double>(number(card[i + 2]), number(card[i + 3])));
  }

  void assemble(const std::string& name, const Dmig& matrix) {
    const std::string& selected = selected_.at(name);
    for (const auto& [row, column, value] : matrix.elements) {
      for (const bool mirrored : {false, true}) {
        if (mirrored && (!matrix.symmetric || row == column)) continue;
        const int i = mirrored ? column : row, j = mirrored ? row : column;
        if (selected == "K42GG") out_.d(i, j) += value.real();
        if (selected.starts_with("K2")) out_.k(i, j) += value.real();
        if (selected.starts_with("K2")) out_.d(i, j) += value.imag();
        if (selected.starts_with("M2")) out_.m(i, j) += value.real();
        if (selected.starts_with("B2")) out_.c(i, j) += value.real();
      }
    }
  }

  const std::vector<frf::Dof>& dofs_;
  Assembled out_;
  std::vector<Fields> cards_;
  std::map<std::string, std::string> selected_;  ///< command of a matrix
  std::map<std::string, Fields> properties_;
  std::map<std::string, Dmig> matrices_;
};

class AnsysReader {
 public:
  AnsysReader(const std::string& text, const std::vector<frf::Dof>& dofs) : dofs_(dofs), out_(dofs.size()) {
    for (const std::string& line : lines_of(text)) {
      if (!line.empty() && line[0] != '!') read(split(line, ','));
    }
  }

  Assembled result() const { return out_; }

 private:
  void read(const Fields& words) {
    if (words[0] == "ET") types_[words[1]] = words[2];
    if (words[0] == "KEYOPT") options_[words[1]][std::stoi(words[2])] = std::stoi(words[3]);
    if (words[0] == "R") real_ = words[1];
    if (words[0] == "R" || words[0] == "RMORE") {
      for (std::size_t i = words[0] == "R" ? 2 : 1; i < words.size(); ++i) constants_[real_].push_back(number(words[i]));
    }
    if (words[0] == "TYPE") type_ = words[1];
    if (words[0] == "REAL") real_ = words[1];
    if (words[0] == "EN") add(words.at(2), words.at(3));
  }

  int dof(const std::string& node, int component) const {
    return node == "JGROUND" ? -1 : place(dofs_, std::stol(node), component);
  }

  void add(const std::string& first, const std::string& second) {
    const std::vector<double>& values = constants_.at(real_);
    std::map<int, int>& options = options_.at(type_);
    if (types_.at(type_) == "COMBIN14") {
      const int a = dof(first, options.at(2)), b = dof(second, options.at(2));
      add_link(out_.k, a, b, values.at(0));
      add_link(out_.c, a, b, values.at(1));
      return;
    }
    Eigen::MatrixXd& to = options.at(3) == 2 ? out_.m : options.at(3) == 4 ? out_.k : options.at(3) == 5 ? out_.c : out_.d;
    std::size_t next = 0;
    for (int i = 0; i < 12; ++i) {
      for (int j = i; j < 12; ++j) {
        const double value = values.at(next++);
        if (value == 0.0) continue;
        const int a = dof(i < 6 ? first : second, i % 6 + 1), b = dof(j < 6 ? first : second, j % 6 + 1);
        to(a, b) += value;
        if (a != b) to(b, a) += value;
      }
    }
  }

  const std::vector<frf::Dof>& dofs_;
  Assembled out_;
  std::map<std::string, std::string> types_;
  std::map<std::string, std::map<int, int>> options_;
  std::map<std::string, std::vector<double>> constants_;
  std::string type_, real_;
};

class AbaqusReader {
 public:
  AbaqusReader(const std::string& text, const std::vector<frf::Dof>& dofs) : dofs_(dofs), out_(dofs.size()) {
    std::vector<std::string> data;
    for (const std::string& line : lines_of(text)) {
      if (line.starts_with("**") || line.empty()) continue;
      if (line[0] == '*') {
        close(data);
        data.clear();
        open(line);
      } else {
        data.push_back(line);
      }
    }
    close(data);
  }

  Assembled result() const { return out_; }

 private:
  void open(const std::string& line) {
    parameters_.clear();
    const Fields words = split(line, ',');
    keyword_ = words[0];
    for (std::size_t i = 1; i < words.size(); ++i) {
      const Fields parts = split(words[i], '=');
      parameters_[parts[0]] = parts.size() > 1 ? parts[1] : "";
    }
    if (keyword_ != "*MATRIX ASSEMBLE") return;
    for (const auto& [which, name] : parameters_) {
      const Eigen::MatrixXd& value = matrices_.at(name);
      (which == "STIFFNESS" ? out_.k : which == "MASS" ? out_.m : which == "VISCOUS DAMPING" ? out_.c : out_.d) += value;
    }
  }

  void close(const std::vector<std::string>& data) {
    if (keyword_ == "*ELEMENT") nodes_[parameters_.at("ELSET")] = split(data.at(0), ',');
    if (keyword_ == "*SPRING" || keyword_ == "*DASHPOT") add_element(split(data.at(0), ','), split(data.at(1), ','));
    if (keyword_ == "*CONNECTOR SECTION") connected_[parameters_.at("BEHAVIOR")] = nodes_.at(parameters_.at("ELSET"));
    if (keyword_ == "*CONNECTOR BEHAVIOR") behaviour_ = parameters_.at("NAME");
    if (keyword_ == "*CONNECTOR ELASTICITY" || keyword_ == "*CONNECTOR DAMPING") add_connector(number(data.at(0)));
    if (keyword_ == "*MATRIX INPUT") add_matrix(data);
  }

  int dof(const std::string& node, int component) const { return node.empty() ? -1 : place(dofs_, std::stol(node), component); }

  void add_element(const Fields& components, const Fields& values) {
    const Fields& nodes = nodes_.at(parameters_.at("ELSET"));
    const int a = dof(nodes.at(1), std::stoi(components.at(0)));
    const int b = nodes.size() > 2 ? dof(nodes[2], std::stoi(components.at(1))) : -1;
    add_link(keyword_ == "*SPRING" ? out_.k : out_.c, a, b, number(values.at(0)));
    if (parameters_.contains("COMPLEX STIFFNESS")) add_link(out_.d, a, b, number(values.at(0)) * number(values.at(1)));
  }

  void add_connector(double value) {
    const Fields& nodes = connected_.at(behaviour_);
    const int component = std::stoi(parameters_.at("COMPONENT"));
    const int a = dof(nodes.at(1), component), b = nodes.size() > 2 ? dof(nodes[2], component) : -1;
    if (keyword_ == "*CONNECTOR ELASTICITY") {
      add_link(out_.k, a, b, value);
      stiffness_[{behaviour_, component}] = value;
    } else if (parameters_.contains("TYPE") && parameters_.at("TYPE") == "STRUCTURAL") {
      add_link(out_.d, a, b, value * stiffness_.at({behaviour_, component}));
    } else {
      add_link(out_.c, a, b, value);
    }
  }

  void add_matrix(const std::vector<std::string>& data) {
    Eigen::MatrixXd& to = matrices_[parameters_.at("NAME")];
    to = Eigen::MatrixXd::Zero(out_.k.rows(), out_.k.rows());
    for (const std::string& line : data) {
      const Fields words = split(line, ',');
      const int a = dof(words.at(0), std::stoi(words.at(1))), b = dof(words.at(2), std::stoi(words.at(3)));
      to(a, b) = number(words.at(4));
      if (parameters_.at("TYPE") == "SYMMETRIC") to(b, a) = to(a, b);
    }
  }

  const std::vector<frf::Dof>& dofs_;
  Assembled out_;
  std::string keyword_, behaviour_;
  std::map<std::string, std::string> parameters_;
  std::map<std::string, Fields> nodes_, connected_;
  std::map<std::string, Eigen::MatrixXd> matrices_;
  std::map<std::pair<std::string, int>, double> stiffness_;
};

}  // namespace

Assembled::Assembled(std::size_t n) {
  for (Eigen::MatrixXd* each : {&k, &m, &c, &d})
    *each = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
}

Eigen::MatrixXcd Assembled::impedance(double omega) const {
  Eigen::MatrixXcd z(k.rows(), k.cols());
  z.real() = k - omega * omega * m;
  z.imag() = omega * c + d;
  return z;
}

Assembled read_nastran(const std::string& text, const std::vector<frf::Dof>& dofs) { return NastranReader(text, dofs).result(); }

Assembled read_ansys(const std::string& text, const std::vector<frf::Dof>& dofs) { return AnsysReader(text, dofs).result(); }

Assembled read_abaqus(const std::string& text, const std::vector<frf::Dof>& dofs) { return AbaqusReader(text, dofs).result(); }

Eigen::MatrixXd read_market(const std::string& text) {
  Eigen::MatrixXd out;
  bool symmetric = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("%%")) symmetric = line.ends_with("symmetric");
    if (line.empty() || line[0] == '%') continue;
    std::istringstream in(line);
    Eigen::Index i = 0, j = 0;
    double value = 0.0;
    in >> i >> j >> value;
    if (out.size() == 0) {
      out = Eigen::MatrixXd::Zero(i, j);
    } else {
      out(i - 1, j - 1) = value;
      if (symmetric) out(j - 1, i - 1) = value;
    }
  }
  return out;
}

}  // namespace jointid::cards
