#include "frf/csv/lvm_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "frf/text/footer.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/special_number.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view lvm_begin = "LabVIEW Measurement", lvm_header_end = "***End_of_Header***";

class LvmReader {
 public:
  explicit LvmReader(const std::string& file) { out_.file = file; }

  LvmFile read(std::string_view rest) {
    separator_ =
        rest.substr(0, rest.find('\n')).find('\t') == std::string_view::npos && rest.find("Separator,") != std::string_view::npos
            ? ','
            : '\t';
    const bool cut = ends_in_a_cut_number(rest);
    for (line_ = 1; !rest.empty(); ++line_) take(take_until(rest, '\n'));
    if (cut) fail(cut_number, whole_file);
    if (out_.channels.empty()) fail("has no row of titles that begins with X_Value", "write it again with column headings");
    finish_axis();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(std::string problem, std::string remedy) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = out_.file,
                      .place = "line " + std::to_string(line_),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  }

  void take(std::string_view line) {
    if (trimmed(line).empty()) return;
    const std::vector<std::string_view> cells = split(line, separator_);
    if (cells[0] == lvm_header_end) {
      ++headers_;
    } else if (!out_.channels.empty() && headers_ < 3 && cells[0] != "Channels") {
      read_row(cells);
    } else if (!out_.channels.empty()) {
      fail("begins another segment", "write one segment to a file, with one heading");
    } else if (headers_ > 0 && lower_case(cells[0]).starts_with("x_value")) {
      read_titles(cells);
    } else {
      keys_[lower_case(cells[0])].assign(cells.begin() + 1, cells.end());
    }
  }

  std::string key(const std::string& name, std::size_t channel = 0) const {
    const auto found = keys_.find(name);
    return found != keys_.end() && channel < found->second.size() ? found->second[channel] : std::string();
  }

  void read_titles(const std::vector<std::string_view>& cells) {
    out_.titles_line = line_;
    multi_ = lower_case(key("x_columns")) == "multi";
    no_x_ = lower_case(key("x_columns")) == "no";
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const std::string plain = lower_case(cells[i]);
      if (cells[i].empty() || plain == "comment" || plain.starts_with("x_value")) continue;
      const std::size_t k = out_.channels.size();
      out_.channels.push_back({std::string(cells[i]), key("y_unit_label", k), {}});
      places_.push_back(i);
    }
    if (out_.channels.empty()) fail("has no channel beside X_Value", "write the channels to it");
    read_axis();
  }

  /// Every channel has an axis of its own in the keys, and they must be the same.
  void read_axis() {
    out_.dimension = key("x_dimension").empty() ? "Time" : key("x_dimension");
    out_.x_unit = key("x_unit_label");
    for (std::size_t k = 1; k < out_.channels.size(); ++k) {
      for (const char* name : {"x_dimension", "x_unit_label", "x0", "delta_x"}) {
        if (!key(name, k).empty() && key(name, k) != key(name))
          fail("channels 1 and " + std::to_string(k + 1) + " have different " + name + ", " + key(name) + " and " + key(name, k),
               "write channels of one axis to a file");
      }
    }
  }

  double number(std::string_view cell) const {
    double value = 0.0;
    if (!parse_cell(cell, separator_ != ',', value)) {
      if (!states_no_value(cell)) fail("'" + std::string(cell.substr(0, 40)) + "' is not a number", "write the file again");
      value = std::numeric_limits<double>::quiet_NaN();
    }
    return value;
  }

  void read_row(const std::vector<std::string_view>& cells) {
    if (cells.size() <= places_.back())
      fail("has " + std::to_string(cells.size()) + " cells, fewer than the titles", "write the file again");
    if (!no_x_) out_.x.push_back(number(cells[0]));
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (multi_ && k > 0 && number(cells[places_[k] - 1]) != out_.x.back())
        fail("channels 1 and " + std::to_string(k + 1) + " have different X_Value", "write channels of one axis to a file");
      out_.channels[k].values.push_back(number(cells[places_[k]]));
    }
  }

  void finish_axis() {
    if (!no_x_) return;
    const double first = key("x0").empty() ? 0.0 : number(key("x0")), step = number(key("delta_x"));
    if (!(step > 0.0)) fail("has neither a column of X_Value nor a Delta_X above 0", "write it with X columns");
    for (std::size_t i = 0; i < out_.channels.front().values.size(); ++i) out_.x.push_back(first + step * static_cast<double>(i));
  }

  LvmFile out_;
  std::map<std::string, std::vector<std::string>, std::less<>> keys_;
  std::vector<std::size_t> places_;  ///< cells of the channels
  std::size_t line_ = 0, headers_ = 0;
  char separator_ = '\t';
  bool multi_ = false, no_x_ = false;
};

}  // namespace

bool looks_like_lvm(std::string_view head) { return head.starts_with(lvm_begin); }

LvmFile read_lvm(const std::string& file, std::string_view text) { return LvmReader(file).read(text); }

}  // namespace jointid::frf
