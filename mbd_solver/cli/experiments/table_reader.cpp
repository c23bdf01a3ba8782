#include "mbd_solver/cli/experiments/table_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {

namespace {

using Json = nlohmann::ordered_json;

const ConfigNode& empty_table() {
  static const ConfigNode node = [] {
    ConfigNode table;
    table.kind = ConfigNode::Kind::kTable;
    return table;
  }();
  return node;
}

// A value, or a list of such.
Json one_or_more(const Json& type) { return {{"anyOf", {type, {{"type", "array"}, {"items", type}}}}}; }

}  // namespace

TableReader::TableReader(Json& schema) : node_(empty_table()), schema_(&schema) {
  schema = {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

// What is known of a key already stays.
void TableReader::list(const std::string& key, Json type) {
  Json& place = (*schema_)["properties"][key];
  if (place.is_null() || place.empty()) place = std::move(type);
}

TableReader::TableReader(const std::string& file, const std::string& path, const ConfigNode& node)
    : file_(file), path_(path), node_(node) {
  if (node.kind != ConfigNode::Kind::kTable) fail(node, "", "is " + node.description() + ", expected a table");
}

void TableReader::take(const std::string& key, std::string& out) {
  if (schema_) {
    list(key, {{"type", {"string", "number"}}});
    out = "x";
    return;
  }
  if (const ConfigNode* value = next(key)) out = text(key, *value);
}

void TableReader::take(const std::string& key, double& out) {
  if (schema_) return list(key, {{"type", "number"}});
  const ConfigNode* value = next(key);
  if (!value) return;
  if (!value->is_number()) fail(*value, key, "is " + value->description() + ", expected a number");
  out = value->number;
}

void TableReader::take(const std::string& key, int& out) {
  if (schema_) return list(key, {{"type", "integer"}});
  double number = out;
  take(key, number);
  out = static_cast<int>(number);
}

void TableReader::take(const std::string& key, bool& out) {
  if (schema_) return list(key, {{"type", "boolean"}});
  const ConfigNode* value = next(key);
  if (!value) return;
  if (value->kind != ConfigNode::Kind::kFlag)
    fail(*value, key, "is " + value->description() + ", expected true or false");
  out = value->flag;
}

void TableReader::take(const std::string& key, std::vector<std::string>& out) {
  if (schema_) {
    list(key, one_or_more({{"type", {"string", "number"}}}));
    out = {"x"};
    return;
  }
  const ConfigNode* value = next(key);
  if (!value) return;
  out.clear();
  if (value->kind != ConfigNode::Kind::kList) {
    out.push_back(text(key, *value));
    return;
  }
  for (const ConfigNode& entry : value->list) out.push_back(text(key, entry));
}

void TableReader::take(const std::string& key, std::vector<double>& out) {
  if (schema_) {
    list(key, one_or_more({{"type", {"number", "string"}}}));  // "" is none
    out = {1.0};
    return;
  }
  std::vector<std::string> texts;
  take(key, texts);
  for (const std::string& text : texts) {
    char* end = nullptr;
    out.push_back(text.empty() ? std::nan("") : std::strtod(text.c_str(), &end));
    if (end && *end != '\0')
      fail(*next(key), key, "\"" + text + "\" is not a number; expected numbers, or \"\" for none");
  }
}

void TableReader::take_file_name(const std::string& key, std::string& out) {
  take(key, out);
  require(key, !out.empty());
  if (!is_plain_name(out))
    fail(*next(key), key,
         "is \"" + out + "\", expected letters, digits, _ - and . only, no dot in front, at most " +
             std::to_string(kLongestName) + " of them: it names a file");
}

const ConfigNode* TableReader::next(const std::string& key) {
  if (schema_) {
    list(key, Json::object());  // any value
    return &node_;
  }
  known_.push_back(key);
  return node_.find(key);
}

void TableReader::require(const std::string& key, bool given) const {
  if (!given) fail(key, "is missing");
}

void TableReader::done() const {
  for (const auto& [key, value] : node_.table) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string guess = nearest_name(key, known_);
    fail(value, key, "is not known" + (guess.empty() ? "" : "; did you mean \"" + guess + "\"?"));
  }
}

void TableReader::fail(const ConfigNode& at, const std::string& key, const std::string& what) const {
  throw InputError(file_ + ":" + std::to_string(at.line) + ": " + (path_.empty() || key.empty() ? path_ : path_ + ".") +
                   key + ": " + what);
}

std::string TableReader::text(const std::string& key, const ConfigNode& value) const {
  if (value.kind == ConfigNode::Kind::kText) return value.text;
  if (!value.is_number()) fail(value, key, "is " + value.description() + ", expected a text or a number");
  if (value.kind == ConfigNode::Kind::kInteger)
    return std::to_string(static_cast<long long>(value.number));  // seeds have many digits
  return number_text(value.number);
}

}  // namespace footfall
