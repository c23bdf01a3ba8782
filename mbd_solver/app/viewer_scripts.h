#pragma once
// The scripts of web/dist, built into the program.

namespace footfall {

extern const char* const kViewScript;    // of view.html: three.js, uPlot and web/src
extern const char* const kReportScript;  // of report.html: uPlot and web/src

}  // namespace footfall
