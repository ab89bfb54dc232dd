#include "cli/options/own_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/set/quantity.hpp"

namespace jointid::cli {
namespace {

constexpr std::size_t head_bytes = 4096;

/// Beginnings of the tables that commands write as CSV, long enough to be no one else's.
constexpr std::array csv_heads = {"name,value,unit,std_error,",
                                  "name,unit,truth,mean,bias,",
                                  "method,equations,weighting,delta,",
                                  "joint,quantity,unit,truth,bound,",
                                  "joint,law,quantity,unit,value,",
                                  "joint,level,frequency [Hz],displacement [m],",
                                  "law,curve,name,value,unit,",
                                  "curve,x,y\n",
                                  "curve,place,parameter,force [N],",
                                  "number,file,from_s,force_n,kept,",
                                  "mode,frequency_hz,frequency_std,damping,",
                                  "force [N],frequency [Hz],way,",
                                  "force [N],frequency [Hz],harmonic,dof,",
                                  "sweep,value,method,solver,",
                                  "displacement [m],stiffness [N/m],damping [N/m],misfit",
                                  "joint displacement [m],force [N]",
                                  "table,row,column,print,doubtful,",
                                  "channel,unit,mean,mode 1",
                                  "relative velocity [m/s],friction coefficient\n",
                                  "motion,time [s],x(",
                                  "frequency_hz,condition,kept,usable",
                                  "response,reference,lines,frac,",
                                  "mode,frequency_hz,partner,",
                                  "y("};

/// Keys of the JSON that commands write, at its top level.
constexpr std::array json_keys = {"status", "verdict", "trials", "method", "methods", "laws", "joints", "modes", "levels", "channels",
                                  "delay", "files", "title", "message", "plan", "table", "reproduce", "scenes", "sweeps", "cases",
                                  "friction", "system", "estimator", "reason", "suspects", "unknowns", "rows",
                                  "made_by"};

std::string bytes_of(const std::filesystem::path& file, bool end) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(in.tellg());
  std::string text(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, head_bytes)), '\0');
  in.seekg(end ? size - static_cast<std::streamoff>(text.size()) : 0);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

bool has(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

/// Indented by two blanks, with one of our keys at the top.
bool is_own_json(const std::string& head) {
  return std::ranges::any_of(json_keys, [&](const char* key) { return has(head, "\n  \"" + std::string(key) + "\": "); });
}

/// "x1 [m],v1 [m/s]", as motions and their events are titled.
bool all_with_units(const std::string& line) {
  std::istringstream cells(line);
  bool any = false;
  for (std::string cell; std::getline(cells, cell, ',');) {
    if (!has(cell, " [") || !cell.ends_with(']')) return false;
    any = true;
  }
  return any;
}

/// Motions, their events and sweeps, and aligned records, as others write theirs, too.
bool is_record(const std::string& head) {
  const std::string line = head.substr(0, head.find('\n'));
  return line.starts_with("time [s],") || line.starts_with("t [s],") || all_with_units(line) || has(line, ",status,");
}

bool is_own_csv(const std::string& head) {
  return std::ranges::any_of(csv_heads, [&](const char* begin) { return head.starts_with(begin); });
}

/// As frf::write_csv() begins: quantity, its SI unit, then keys, titles with blanks between them and numbers without.
bool is_own_frfs(const std::string& head) {
  std::istringstream lines(head);
  std::string line, unit;
  std::getline(lines, line);
  std::getline(lines, unit);
  for (const frf::Quantity quantity : {frf::Quantity::receptance, frf::Quantity::mobility, frf::Quantity::accelerance}) {
    if (line != "# quantity = " + frf::name(quantity) || unit != "# unit = " + frf::unit(quantity)) continue;
    while (std::getline(lines, line) && (line.starts_with("# node ") || line.starts_with("# averages = "))) {
    }
    const bool titles = line.starts_with("frequency_hz, ");
    return titles && (!std::getline(lines, line) || !has(line, " "));
  }
  return false;
}

bool is_own_hdf5(const std::filesystem::path& file) {
  try {
    return frf::has_format_attribute(file);
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

bool is_own_file(const std::filesystem::path& file, bool record) {
  const std::string head = bytes_of(file, false);
  if (head.empty()) return true;
  if (head.starts_with("\x89HDF\r\n")) return is_own_hdf5(file);
  if (head.starts_with("%PDF")) return bytes_of(file, true).ends_with(pdf_mark);
  if (head.starts_with("<!DOCTYPE html>")) return has(head, "Content-Security-Policy");
  if (head.starts_with("{\n")) return is_own_json(head);
  if (head.starts_with("MATLAB 5.0")) return has(head.substr(0, 128), "written by jointid");
  if (head.starts_with("    -1\n")) return has(head, "\njointid\n");
  if (head.starts_with("# quantity = ")) return is_own_frfs(head);
  for (const char* begin : {"$ jointid", "! jointid", "** jointid"}) {
    if (head.starts_with(begin)) return true;
  }
  if (head.starts_with("%%MatrixMarket")) return has(head, "\n% jointid: joint of ");
  for (const char* begin : {"# jointid", "jointid-journa", "jointid-state"}) {
    if (head.starts_with(begin)) return true;
  }
  if (is_own_csv(head)) return true;
  return record && is_record(head);
}

}  // namespace jointid::cli
