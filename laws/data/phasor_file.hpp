#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "frf/set/frf_system.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::laws {

/// Phasors of one file: those of some DOFs over its lines.
struct Phasors {
  std::string file;
  std::vector<double> frequency_hz;
  Eigen::MatrixXcd values;    ///< [line, DOF]; NaN where not measured
  Eigen::MatrixXd variances;  ///< of real and imaginary part each, their mean; empty when the file says nothing
};

/// Opens files as ident::open_all does.
using Opener = std::function<std::vector<std::unique_ptr<frf::FrfSource>>(const std::vector<ident::DataFile>&)>;

/// Files of phasors: any format that FRFs have, displacements (m) of every line, or forces as the file has them. The one
/// reference says nothing here. Each file is opened once, and read once for the same DOFs, however many harmonics it holds.
class PhasorFiles {
 public:
  PhasorFiles();  ///< by ident::open_all
  explicit PhasorFiles(Opener opener) : opener_(std::move(opener)) {}

  /// The responses of a file.
  const std::vector<frf::Dof>& dofs(const ident::DataFile& file);

  /// Throws InputError (data) when the file has more than one reference, or lacks a DOF.
  std::shared_ptr<const Phasors> read(const ident::DataFile& file, const std::vector<frf::Dof>& dofs);

 private:
  struct Opened {
    std::optional<frf::FrfSystem> system;
    std::vector<frf::Dof> dofs;                ///< read last
    std::shared_ptr<const Phasors> phasors{};  ///< of them
  };
  Opened& opened(const ident::DataFile& file);

  Opener opener_;
  std::map<std::tuple<ident::Path, std::optional<frf::Quantity>, frf::OpenOptions::Spectra>, Opened> files_;
};

}  // namespace jointid::laws
