#pragma once
// The scripts of web/dist, as they are built into the program.

namespace footfall {

extern const char* const kViewScript;    // of view.html: three.js, uPlot and ours
extern const char* const kReportScript;  // of report.html: uPlot and ours

}  // namespace footfall
