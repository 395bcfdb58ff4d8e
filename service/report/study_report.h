// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "study/work_precision.h"

namespace slipstitch {

/// What the errors of positions are drawn over.
enum class StudyAxis { wall_time, newton_iterations };

/// Files of the plots, beside that of study_markdown().
std::string study_plot_file(StudyAxis axis);  // error-time.svg, error-newton.svg

/// One row a rung, all that was measured; numbers with 9 digits, empty where there is none.
std::string study_csv(const WorkPrecision& study);

/// Errors of positions, both axes logarithmic: a colour and a marker a method, the front underlaid. SVG.
std::string study_plot(const WorkPrecision& study, StudyAxis axis);

/// Tables and plots, to which it refers as files. `command` made it or, where a server's `job` did, makes another such.
std::string study_markdown(const WorkPrecision& study, const std::string& command, const std::string& job = {});

/// Parts of that: of the study, its plots in `folder` ("" or with a slash at its end), and what the columns mean.
std::string study_section(const WorkPrecision& study, const std::string& folder);
std::string study_legend(const WorkPrecision& study);

/// The same as one self-contained page.
std::string study_page(const WorkPrecision& study, const std::string& command, const std::string& job = {});

}  // namespace slipstitch
