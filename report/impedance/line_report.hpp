#pragma once

#include <string>

#include "impedance/identify_lines.hpp"
#include "report/page/contents.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// An element of a way over frequency, at most so many lines spread over them: Z, standard errors, loss factor, χ² over f.
Table line_table(const impedance::IdentifiedLines& found, const impedance::WayResult& way, std::size_t element, std::size_t most);

/// Laws by AIC, least first.
Table law_table(const impedance::IdentifiedLines& found);

/// Its parameters with their errors.
Table parameter_table(const impedance::LawFit& law);

/// All of it for people.
std::string line_text(const impedance::LineScene& scene, const impedance::IdentifiedLines& found);

/// Everything. The keys stay; numbers that are not there are null.
std::string line_json(const impedance::LineScene& scene, const impedance::IdentifiedLines& found);

/// A line for each way, element and frequency: "way,element,unit,frequency_hz,re,im,std_error_re,std_error_im,…".
std::string line_csv(const impedance::IdentifiedLines& found);

/// Elements of a way over frequency with their 95 % bands, laws and splines over them, and loss factors; a choice for each
/// element.
PlotGroup line_element_plots(const impedance::IdentifiedLines& found, const impedance::WayResult& way);
/// χ²/f of the likelihood, line by line.
PlotGroup line_misfit_plot(const impedance::IdentifiedLines& found);

/// HTML page: the elements over frequency with their 95 % bands, loss factors, χ²/f.
std::string line_page(const impedance::LineScene& scene, const impedance::IdentifiedLines& found);

}  // namespace jointid::report
