#pragma once

#include <string>
#include <vector>

#include "input_folder.hpp"

/// What spoils an HDF5 file of the folder in ways that the library does not write.
namespace jointid::cli {

Spoil hdf5_text_attribute(std::string file, std::string name, std::string text);
Spoil hdf5_number_attribute(std::string file, std::string name, double value);
Spoil hdf5_without(std::string file, std::string dataset);
Spoil hdf5_frequency(std::string file, std::vector<double> hz);
Spoil hdf5_texts(std::string file, std::string dataset, std::vector<std::string> texts);
Spoil hdf5_coherence(std::string file, std::vector<double> values);
/// Makes a dataset a link into another file.
Spoil hdf5_external_link(std::string file, std::string dataset);

}  // namespace jointid::cli
