#include "mbd_solver/cli/analysis/viewer/page_parts.h"

#include <algorithm>

#include "coupler/base/text.h"
#include "mbd_solver/cli/analysis/reduced_rows.h"
#include "mbd_solver/cli/analysis/viewer/packed_series.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kSpans = 2000;  // of time, when there are more rows than twice as many

// JSON that neither ends a script element nor means anything in XML.
std::string harmless(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else if (c == '>') {
      text += "\\u003e";
    } else if (c == '&') {
      text += "\\u0026";
    } else {
      text += c;
    }
  }
  return text;
}

std::string element(const std::string& name, const std::string& type, const std::string& text) {
  return "<script type=\"" + type + "\" id=\"footfall-" + name + "\">" + text + "</script>\n";
}

}  // namespace

void PageParts::add_frame(const std::string& name, std::size_t k, std::string text) {
  (k == 0 ? chunks : later[k]).emplace_back(name + "-" + std::to_string(k), std::move(text));
}

std::string PageParts::elements(const std::string& script) const {
  std::string text = element("run", "application/json", harmless(run));
  text += "<script>//<![CDATA[\n" + script + "\n//]]></script>\n";
  for (const auto& [name, chunk] : chunks) text += element(name, "text/plain", chunk);
  for (const auto& [k, frame] : later)
    for (const auto& [name, chunk] : frame) text += element(name, "text/plain", chunk);
  return text;
}

void add_history(const History& history, const std::vector<std::string>& shown, PageParts& parts) {
  const std::vector<double>& time = history.column("time");
  const std::vector<std::size_t> rows = rows_to_draw(time, kSpans);
  Json& json = parts.run["history"];
  json["rows"] = rows.size();
  json["time"] = Json::array();
  for (const std::size_t row : rows) json["time"].push_back(time[row]);
  json["names"] = Json::array();
  json["units"] = Json::array();
  std::vector<float> values;
  for (std::size_t i = 0; i < history.names.size(); ++i) {
    if (history.names[i] == "time") continue;
    json["names"].push_back(history.names[i]);
    json["units"].push_back(history.units[i]);
    for (const double value : drawn_values(history.columns[i], rows)) values.push_back(static_cast<float>(value));
  }
  parts.run["shown"] = shown;
  parts.chunks.emplace_back("history", packed_numbers(values));
}

std::vector<std::string> first_columns(const History& history, const std::string& observed) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> shown;
  const auto add = [&](const std::string& name) {
    if (history.find(name) >= 0 && shown.size() < kMost) shown.push_back(name);
  };
  add(observed + ".az");
  for (const char* ending : {".contact.fz", ".force", ".joint_torque", ".joint_force", ".angle", ".displacement"}) {
    const std::size_t before = shown.size();
    for (const std::string& name : history.names)
      if (ends_with(name, ending)) add(name);
    if (shown.size() > std::max<std::size_t>(before, 1)) break;
  }
  if (shown.size() < 2) {
    for (const char* name : {"energy.kinetic", "energy.gravity", "energy.strain", "energy.total"}) add(name);
  }
  return shown;
}

}  // namespace footfall
