#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ident/likelihood/parts/group_line.hpp"
#include "ident/result/control.hpp"
#include "ident/variance/variances.hpp"

namespace jointid::ident {

/// FRFs and variances of all groups at all lines.
class PartsData {
 public:
  PartsData(const Plan& plan, const PartGroups& groups);

  /// Reads what is measured; variances are those of the measured values. Throws InputError as Variances::prepare().
  void read(const Control& control);

  /// Variances that depend on the values are taken at the corrected ones; false where none does.
  bool reweigh();

  std::vector<std::vector<GroupLine>>& groups() { return lines_; }  ///< [group, line]
  const std::vector<std::size_t>& columns(std::size_t group) const { return columns_[group]; }  ///< of the plan, ascending
  std::size_t lines() const { return frequency_hz_.size(); }
  double frequency_hz(std::size_t line) const { return frequency_hz_[line]; }
  std::vector<FileVariances> origins() const;
  std::size_t entries_per_line() const;
  std::size_t bytes() const;

 private:
  /// A rectangle of FRFs with its variances.
  struct Source {
    std::unique_ptr<frf::BlockReader> reader;
    std::unique_ptr<Variances> variances;
    std::size_t group = 0, member = 0;  ///< of a substructure

    std::size_t size() const { return reader->rows() * reader->columns(); }
  };
  void plan_lines(const Plan& plan);
  void prepare();
  void read_line(std::size_t line);
  void take_motion(std::size_t line, std::span<const Complex> values, std::span<const Complex> variances);
  void take_part(const Source& source, std::size_t line, std::span<const Complex> values, std::span<const Complex> variances);
  void reweigh_motion(std::size_t line);
  void reweigh_part(Source& part, std::size_t line);
  std::vector<Complex> corrected_motion(std::size_t line) const;

  const PartGroups& all_;
  std::vector<double> frequency_hz_;
  std::vector<std::size_t> substructure_lines_, assembly_lines_;
  std::vector<std::vector<std::size_t>> columns_;
  std::vector<std::vector<std::vector<std::size_t>>> places_;  ///< [group, line]: GroupLine::columns
  std::vector<std::vector<std::size_t>> motion_places_;        ///< [group]: of its motions among all
  Source assembly_;
  std::vector<Source> parts_;
  std::vector<std::vector<GroupLine>> lines_;
};

}  // namespace jointid::ident
