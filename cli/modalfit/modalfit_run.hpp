#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/modalfit/modalfit_arguments.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/symmetric_model.hpp"
#include "modalfit/model/synthesis.hpp"

namespace jointid::cli {

/// A modal fit and what is told of it.
struct ModalRun {
  std::string files;  ///< as named by the user
  frf::FrfHeader header;
  modalfit::Band band;
  modalfit::ModalFit fit;
  std::optional<modalfit::SymmetricModel> symmetric;
  std::string obstacle;  ///< why there is no symmetric model
  frf::FrfSet regenerated;  ///< the band's lines and entries, by the symmetric model where there is one
  std::vector<modalfit::SynthesisError> of_fit, of_model;  ///< per entry; of_model is empty without a symmetric model
  double read_s = 0.0, fit_s = 0.0;
};

/// Reads the files and fits. Throws InputError.
ModalRun run_modalfit(const ModalfitArguments& arguments);

/// Shapes over some coordinates, one per mode: those of the symmetric model, else the residues of the reference with the largest ones
/// (of arbitrary scale).
struct Shapes {
  std::vector<frf::Dof> dofs;
  std::vector<std::vector<std::complex<double>>> of_mode;
};
Shapes shapes(const ModalRun& run);

/// Writes what --regenerate and --shapes ask for. Throws InputError.
void write_regenerated(const ModalRun& run, const std::filesystem::path& path);
void write_shapes(const ModalRun& run, const std::filesystem::path& path);

}  // namespace jointid::cli
