#pragma once
// Parts of report.html that pages of runs and of sweeps share.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mbd_solver/cli/analysis/html_page.h"

namespace footfall {

using Rows = std::vector<std::vector<std::string>>;  // of a table

constexpr const char* kLedgerPicture = "ledger.png";  // stands in a section of its own

std::string short_text(double value);  // five digits

// A picture that gnuplot began and did not draw is empty.
bool has_content(const std::string& file);
std::vector<std::string> pictures_in(const std::string& folder);
// The PNG files of a folder under a heading; nothing when there are none.
void show_pictures(const std::string& folder, const std::string& heading, HtmlPage& page);

// What was assumed, the scene file with those that it is built on, the scripts of the grains, and the scene with its
// defaults.
void show_scene(const nlohmann::ordered_json& summary, HtmlPage& page);
void show_versions(const nlohmann::ordered_json& summary, HtmlPage& page);

}  // namespace footfall
