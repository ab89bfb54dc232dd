#pragma once

#include "models/files/file_matrix.hpp"

namespace jointid::models {

/// Whether a file of text has punched DMIG cards of Nastran; its first card says so.
bool is_dmig(const std::filesystem::path& file);

/// A matrix of DMIG cards (small, large or free fields; form 1 or 6; real or complex as real and imaginary part), labelled by
/// grid point and component. `name`: which; empty: the only one. Throws InputError (data) with the line of what is no such card.
FileMatrix read_dmig(const std::filesystem::path& file, const std::string& name = {});

/// Whether a file of text has the lines of Abaqus' *MATRIX GENERATE with *MATRIX OUTPUT: FORMAT=MATRIX INPUT, five cells, or
/// COORDINATE, three.
bool is_abaqus_matrix(const std::filesystem::path& file);

/// Such a matrix: "node, dof, node, dof, value", whose rows are labelled, or "row column value". Symmetric matrices list a
/// triangle or all elements. Throws InputError (data) with the line of what is no such one.
FileMatrix read_abaqus_matrix(const std::filesystem::path& file);

}  // namespace jointid::models
