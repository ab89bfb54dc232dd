#pragma once

#include <string>
#include <vector>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"
#include "tasks/series/contact.hpp"

namespace jointid::report {

std::vector<std::string> contact_remarks(const tasks::ContactResult& report);
Table contact_table(const tasks::ContactResult& report);
/// The coefficient over the relative velocity, and the law.
PlotGroup contact_law_plots(const tasks::ContactResult& report);
/// "A law that falls with speed."
std::string contact_summary(const tasks::ContactResult& report);

/// For people.
std::string contact_text(const tasks::ContactResult& report);
/// The keys stay.
std::string contact_json(const tasks::ContactResult& report);
/// "relative velocity [m/s],friction coefficient": a row a sample.
std::string contact_csv(const tasks::ContactResult& report);
/// The page of `jointid series friction`.
std::string contact_page(const tasks::ContactResult& report);

}  // namespace jointid::report
