#pragma once
// What a page of a run holds for its scripts: one JSON with all that is small, and chunks of packed numbers by name.
// web/src/page.js takes them.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/output/history.h"

namespace footfall {

struct PageParts {
  using Chunk = std::pair<std::string, std::string>;  // name, text: base64, as packed_series.h makes it

  nlohmann::ordered_json run;
  std::vector<Chunk> chunks;                             // what the first picture needs
  std::map<std::size_t, std::vector<Chunk>> later = {};  // by frame

  // The chunk NAME-k of frame k.
  void add_frame(const std::string& name, std::size_t k, std::string text);

  // As elements of a page: the JSON, the script, the chunks, frame by frame. The script draws while a browser still
  // reads the frames. Well-formed XML as well, whatever the texts hold.
  std::string elements(const std::string& script) const;
};

// The history's columns in single precision, and the times as they are. Of more than 4000 rows the lowest and highest
// values of each span (reduced_rows.h). `shown`: the columns that are plotted at first.
void add_history(const History& history, const std::vector<std::string>& shown, PageParts& parts);

// The columns of a run that are worth a first look, at most six: acceleration of the observed body, contact forces or
// forces of struts, else what there is.
std::vector<std::string> first_columns(const History& history, const std::string& observed);

}  // namespace footfall
