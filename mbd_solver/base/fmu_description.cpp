// A line per fact, tabs between its parts; names and values contain none (the host replaces them by blanks).

#include "mbd_solver/base/fmu_description.h"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "coupler/base/text.h"
#include "mbd_solver/base/text_reader.h"

namespace footfall {
namespace {

constexpr const char* kHost = "footfall_fmu_host";

std::string plain(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return text;
}

long whole(const std::string& text) { return std::strtol(text.c_str(), nullptr, 10); }

std::string dimensions_text(const FmuVariable& variable) {
  std::vector<std::string> words;
  for (const FmuVariable::Dimension& d : variable.dimensions)
    words.push_back(d.fixed ? std::to_string(d.size) : "#" + std::to_string(d.parameter));
  return joined(words, " ");
}

}  // namespace

const FmuVariable* FmuDescription::find(const std::string& name) const {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const FmuVariable& v) { return v.name == name; });
  return found == variables.end() ? nullptr : &*found;
}

std::vector<long> FmuDescription::sizes(const FmuVariable& variable, const FmuStarts& starts) const {
  std::vector<long> all;
  for (const FmuVariable::Dimension& d : variable.dimensions) {
    long size = d.size;
    if (!d.fixed)
      for (const FmuVariable& other : variables) {
        if (other.reference != d.parameter) continue;
        const auto given = starts.find(other.name);
        size = whole(given == starts.end() ? other.start : given->second);
      }
    all.push_back(std::max(0l, size));
  }
  return all;
}

long FmuDescription::count(const std::vector<long>& sizes) {
  long product = 1;
  for (const long size : sizes) product *= std::min(size, 1l << 20);
  return std::min(product, 1l << 20);
}

FmuElement find_element(const FmuDescription& description, const std::string& name, const FmuStarts& starts) {
  if (const FmuVariable* const whole_variable = description.find(name)) {
    if (whole_variable->dimensions.empty()) return {whole_variable, 0, ""};
    const std::vector<long> sizes = description.sizes(*whole_variable, starts);
    std::vector<std::string> words;
    for (const long size : sizes) words.push_back(std::to_string(size));
    const std::vector<std::string> first(sizes.size(), "1");
    return {whole_variable, 0,
            "is an array of " + joined(words, " x ") + "; name its elements, " + name + "[" + joined(first, ",") +
                "] to " + name + "[" + joined(words, ",") + "]"};
  }
  const std::size_t bracket = name.rfind('[');
  if (bracket == std::string::npos || name.back() != ']') return {};
  const FmuVariable* const variable = description.find(name.substr(0, bracket));
  if (!variable) return {};
  const std::vector<long> sizes = description.sizes(*variable, starts);
  if (sizes.empty()) return {variable, 0, "is no array; write it without [ ]"};
  const std::vector<std::string> words = split(name.substr(bracket + 1, name.size() - bracket - 2), ',');
  std::vector<std::string> of;
  for (const long size : sizes) of.push_back(std::to_string(size));
  const FmuElement wrong{variable, 0,
                         "is none of its elements; the array has " + joined(of, " x ") + " of them, counted from 1"};
  if (words.size() != sizes.size()) return wrong;
  long place = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::optional<int> index = whole_number(trimmed(words[i]), 1, static_cast<int>(std::min(sizes[i], 1l << 20)));
    if (!index) return wrong;
    place = place * sizes[i] + (*index - 1);
  }
  return {variable, place, ""};
}

std::string text_of(const FmuDescription& d) {
  std::ostringstream text;
  text << "fmu\t" << plain(d.version) << '\t' << plain(d.model) << '\t' << plain(d.identifier) << '\t' << plain(d.token)
       << '\t' << (d.keeps_state ? 1 : 0) << '\t' << plain(d.obstacle) << "\t.\n";
  for (const FmuVariable& v : d.variables)
    text << plain(v.name) << '\t' << v.type << '\t' << plain(v.causality) << '\t' << plain(v.variability) << '\t'
         << plain(v.unit) << '\t' << plain(v.start) << '\t' << v.reference << '\t' << dimensions_text(v) << "\t.\n";
  return text.str();
}

FmuDescription fmu_description_of(const std::string& text) {
  FmuDescription d;
  std::vector<std::string> lines = split(text, '\n');
  lines.resize(std::max<std::size_t>(1, lines.size()));
  std::vector<std::string> words = split(lines[0], '\t');
  words.resize(8);
  d.version = words[1];
  d.model = words[2];
  d.identifier = words[3];
  d.token = words[4];
  d.keeps_state = words[5] == "1";
  d.obstacle = words[6];
  for (std::size_t i = 1; i < lines.size(); ++i) {
    words = split(lines[i], '\t');
    words.resize(9);
    FmuVariable v;
    v.name = words[0];
    v.type = words[1];
    v.causality = words[2];
    v.variability = words[3];
    v.unit = words[4];
    v.start = words[5];
    v.reference = static_cast<unsigned>(whole(words[6]));
    for (const std::string& size : blank_words(words[7])) {
      FmuVariable::Dimension dimension;
      dimension.fixed = size[0] != '#';
      if (dimension.fixed) dimension.size = whole(size);
      if (!dimension.fixed) dimension.parameter = static_cast<unsigned>(whole(size.substr(1)));
      v.dimensions.push_back(dimension);
    }
    d.variables.push_back(std::move(v));
  }
  return d;
}

std::string fmu_host() {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto runs = [](const fs::path& path) {
    std::error_code ignored;
    return access(path.c_str(), X_OK) == 0 && fs::is_regular_file(path, ignored);
  };
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / kHost;
  if (runs(beside)) return beside.string();
  // In another program, such as Python: in bin of the build or the installation of the library that has this function.
  Dl_info here;
  if (dladdr(reinterpret_cast<const void*>(&fmu_host), &here) != 0 && here.dli_fname != nullptr) {
    fs::path folder = fs::absolute(here.dli_fname, error).parent_path();
    for (int i = 0; i < 5 && folder.has_relative_path(); ++i, folder = folder.parent_path())
      if (const fs::path program = folder / "bin" / kHost; runs(program)) return program.string();
  }
  const char* const path = std::getenv("PATH");
  for (const std::string& folder : split(path ? path : "", ':'))
    if (const fs::path program = fs::path(folder.empty() ? "." : folder) / kHost; runs(program))
      return program.string();
  return "";
}

}  // namespace footfall
