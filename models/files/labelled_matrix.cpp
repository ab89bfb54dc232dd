#include "models/files/labelled_matrix.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>

#include "base/text.hpp"
#include "models/files/failure.hpp"

namespace jointid::models {
namespace {

using Cells = std::vector<std::string>;

std::string without_blanks(std::string text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<std::int64_t> whole(const std::string& text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(value) : std::nullopt;
}

Cells split(const std::string& line, const std::string& separators) {
  Cells out;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    out.push_back(without_blanks(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return out;
}

/// Elements by labels, which become rows in ascending order once all are known.
class LabelledElements {
 public:
  explicit LabelledElements(const std::filesystem::path& file) : file_(file) {}

  void add(const RowLabel& row, const RowLabel& column, double re, double im) {
    elements_.push_back({place(row), place(column), re, im});
  }

  /// Labels of columns without an element.
  std::size_t place(const RowLabel& label) { return places_.try_emplace(label, places_.size()).first->second; }

  FileMatrix matrix(FileElements::Mirror mirror) const {
    if (places_.empty()) refuse_file(file_, "", "it has no element", "write the matrix again");
    if (places_.size() > most_sparse_rows) refuse_file(file_, "", "the matrix has more than 2000000 rows");
    std::vector<RowLabel> labels;
    std::vector<std::size_t> rows(places_.size());
    for (const auto& [label, place] : places_) {
      rows[place] = labels.size();
      labels.push_back(label);
    }
    FileElements out(file_);
    for (const auto& [row, column, re, im] : elements_) out.add(rows[row], rows[column], re, im);
    const std::size_t n = labels.size();
    return out.matrix(n, mirror, std::move(labels));
  }

 private:
  struct Element {
    std::size_t row, column;
    double re, im;
  };
  const std::filesystem::path& file_;
  std::map<RowLabel, std::size_t> places_;
  std::vector<Element> elements_;
};

/// Cards with their continuations, fields without the name's asterisk; lines that begin no card and continue none are passed
/// over.
class DmigReader {
 public:
  DmigReader(const std::filesystem::path& file, const std::string& wanted)
      : file_(file), wanted_(wanted), in_(file), elements_(file) {}

  FileMatrix read() {
    for (std::string line; std::getline(in_, line);) {
      ++number_;
      if (line.empty() || line[0] == '$' || without_blanks(line).empty()) continue;
      const bool continues = line[0] == '*' || line[0] == '+' || line[0] == ' ' || line[0] == ',';
      if (!continues) {
        close();
        card_.clear();
        in_card_ = std::string_view(line).substr(0, 4) == "DMIG" || std::string_view(line).substr(0, 4) == "dmig";
        if (in_card_ && line.size() > 4 && std::isalpha(static_cast<unsigned char>(line[4]))) in_card_ = false;  // DMIGROT …
        begin_ = number_;
      }
      if (in_card_) add_fields(line, continues);
    }
    close();
    if (!has_head_) {
      refuse_file(file_, wanted_,
                  names_.empty() ? "it has no head of a DMIG" : "there is no such matrix; there are: " + comma_list(names_),
                  "name one of them: \"FILE:NAME\"");
    }
    return elements_.matrix(symmetric_ ? FileElements::Mirror::always : FileElements::Mirror::none);
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = "punch the matrix again") const {
    refuse_file(file_, "line " + std::to_string(begin_), problem, remedy);
  }

  void add_fields(const std::string& line, bool continues) {
    if (line.find(',') != std::string::npos) {
      Cells cells = split(line, ",");
      cells.erase(cells.begin());
      cells.resize(8);
      card_.insert(card_.end(), cells.begin(), cells.end());
      return;
    }
    const std::string name = without_blanks(line.substr(0, 8));
    const std::size_t width = name.ends_with('*') || (continues && line[0] == '*') ? 16 : 8;
    for (std::size_t i = 0; i < 64 / width; ++i) {
      const std::size_t at = 8 + i * width;
      card_.push_back(at < line.size() ? without_blanks(line.substr(at, width)) : "");
    }
  }

  std::int64_t integer(std::size_t field) const {
    const auto value = field < card_.size() ? whole(card_[field]) : std::nullopt;
    if (!value) fail("field " + std::to_string(field + 2) + " is no whole number");
    return *value;
  }

  double number(std::size_t field) const {
    double value = 0.0;
    if (field >= card_.size() || card_[field].empty()) return 0.0;
    if (!parse_real(card_[field], value)) fail("'" + card_[field] + "' is no finite number");
    return value;
  }

  RowLabel label(std::size_t field) const {
    const std::int64_t component = card_.size() > field + 1 && card_[field + 1].empty() ? 0 : integer(field + 1);
    const RowLabel label{integer(field), static_cast<int>(component)};
    if (label.node < 1 || component < 0 || component > 6)
      fail("grid point " + std::to_string(label.node) + ", component " + std::to_string(component) + " is none");
    return label;
  }

  void close() {
    if (!in_card_ || card_.empty()) return;
    const std::string name = card_[0];
    if (card_.size() < 8) fail("a DMIG has eight fields");
    const bool is_head = card_[1] == "0";
    if (is_head) names_.push_back(name);
    if (is_head && has_head_ && (wanted_.empty() || name == wanted_))
      fail("the file holds several matrices: " + comma_list(names_), "name one: \"FILE:NAME\"");
    if (!wanted_.empty() && name != wanted_) return;
    if (is_head) {
      read_head();
    } else {
      if (!has_head_) fail("a column of '" + name + "' comes before its head");
      read_column();
    }
  }

  void read_head() {
    has_head_ = true;
    const std::int64_t form = integer(2), type = integer(3);
    if (form != 1 && form != 6)
      fail("form " + std::to_string(form) + " is neither square (1) nor symmetric (6)", "mass, damping and stiffness are square");
    if (type < 1 || type > 4) fail("type " + std::to_string(type) + " is none of 1 to 4");
    if (!card_[5].empty() && card_[5] != "0" && type > 2)
      fail("its complex numbers are amplitudes and phases", "write real and imaginary parts (POLAR 0)");
    symmetric_ = form == 6;
    complex_ = type > 2;
  }

  void read_column() {
    const RowLabel column = label(1);
    elements_.place(column);
    for (std::size_t at = 4; at < card_.size(); at += 4) {
      if (card_[at].empty()) continue;
      const double re = number(at + 2), im = complex_ ? number(at + 3) : 0.0;
      elements_.add(label(at), column, re, im);
    }
  }

  const std::filesystem::path& file_;
  std::string wanted_;
  std::ifstream in_;
  std::size_t number_ = 0, begin_ = 0;
  bool in_card_ = false, has_head_ = false, symmetric_ = false, complex_ = false;
  Cells card_;  ///< fields from the second on, four or eight a line
  std::vector<std::string> names_;
  LabelledElements elements_;
};

/// Cells of a line of a matrix of Abaqus; none of a comment or keyword.
Cells abaqus_cells(const std::string& line) {
  const std::string text = without_blanks(line);
  if (text.empty() || text[0] == '*' || text[0] == '%' || text[0] == '#') return {};
  if (text.find(',') == std::string::npos) {
    Cells cells = split(text, " \t");
    std::erase(cells, "");
    return cells;
  }
  Cells cells = split(text, ",");
  if (cells.back().empty()) cells.pop_back();
  return cells;
}

}  // namespace

bool is_dmig(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  for (int count = 0; count < 200 && std::getline(in, line); ++count) {
    if (line.find('\0') != std::string::npos) return false;
    if (line.starts_with("DMIG") || line.starts_with("dmig")) return true;
    if (!line.empty() && line[0] != '$' && !std::isalpha(static_cast<unsigned char>(line[0])) && line[0] != '*' &&
        line[0] != '+' && line[0] != ' ')
      return false;
  }
  return false;
}

FileMatrix read_dmig(const std::filesystem::path& file, const std::string& name) { return DmigReader(file, name).read(); }

bool is_abaqus_matrix(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  for (int count = 0; count < 50 && std::getline(in, line); ++count) {
    if (line.find('\0') != std::string::npos) return false;
    const Cells cells = abaqus_cells(line);
    if (cells.empty()) continue;
    double value = 0.0;
    const bool labelled = cells.size() == 5 && line.find(',') != std::string::npos,
               placed = cells.size() == 3 && file.extension() == ".mtx";
    return (labelled || placed) &&
           std::all_of(cells.begin(), cells.end() - 1, [](const std::string& cell) { return whole(cell).has_value(); }) &&
           parse_real(cells.back(), value);
  }
  return false;
}

FileMatrix read_abaqus_matrix(const std::filesystem::path& file) {
  std::ifstream in(file);
  LabelledElements labelled(file);
  FileElements placed(file);
  std::size_t width = 0, rows = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const Cells cells = abaqus_cells(line);
    if (cells.empty()) continue;
    const auto fail = [&](const std::string& problem) {
      refuse_file(file, "line " + std::to_string(number), problem, "write it anew by *MATRIX OUTPUT");
    };
    if (width == 0) width = cells.size();
    double value = 0.0;
    if (cells.size() != width) fail(std::to_string(cells.size()) + " cells where other lines have " + std::to_string(width));
    if (!parse_real(cells.back(), value)) fail("'" + cells.back() + "' is no finite number");
    std::vector<std::int64_t> places;
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
      const auto place = whole(cells[i]);
      if (!place) fail("'" + cells[i] + "' is no whole number");
      places.push_back(*place);
    }
    if (width == 5) {
      for (const std::size_t i : {1U, 3U}) {
        if (places[i] < 0 || places[i] > 1000) fail("degree of freedom " + cells[i] + " is none");
      }
      labelled.add({places[0], static_cast<int>(places[1])}, {places[2], static_cast<int>(places[3])}, value, 0.0);
    } else {
      for (const std::int64_t place : places) {
        if (place < 1 || static_cast<std::size_t>(place) > most_sparse_rows)
          fail("row or column " + std::to_string(place) + " is not from 1 to 2000000");
        rows = std::max(rows, static_cast<std::size_t>(place));
      }
      placed.add(static_cast<std::size_t>(places[0] - 1), static_cast<std::size_t>(places[1] - 1), value);
    }
  }
  return width == 5 ? labelled.matrix(FileElements::Mirror::where_missing)
                    : placed.matrix(rows, FileElements::Mirror::where_missing);
}

}  // namespace jointid::models
