#pragma once
// Reads one table of an experiment's file key by key; what nobody took is unknown, and is told with a guess. The same
// functions that read a file list their keys for the schema of experiments: there every key is taken for given.

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/scene/config_node.h"

namespace footfall {

class TableReader {
 public:
  // `path` of the table within the file, for messages; `file` and `node` must outlive the reader.
  TableReader(const std::string& file, const std::string& path, const ConfigNode& node);

  // Reads no file: the keys that are asked for become properties of this JSON schema, with their types. Values are "x",
  // 1 and the like, so that a reading function goes on to its last key; where it then finds that they do not fit
  // together, take_list ends it.
  explicit TableReader(nlohmann::ordered_json& schema);

  // Each leaves `out` alone when the key is not there. Throws InputError "file:line: path.key: what is wrong, what was
  // expected".
  void take(const std::string& key, std::string& out);  // a number as a person writes it, too
  void take(const std::string& key, double& out);
  void take(const std::string& key, int& out);
  void take(const std::string& key, bool& out);
  void take(const std::string& key, std::vector<std::string>& out);  // a list of texts and numbers, or one of them
  void take(const std::string& key, std::vector<double>& out);       // likewise numbers; "" is none: NaN
  void take_file_name(const std::string& key, std::string& out);     // must be there, and may be the name of a file
  // Several keys: take("name", name, "until", until, ...).
  template <class First, class... Rest>
  void take(const std::string& key, First& out, const std::string& next_key, Rest&... rest) {
    take(key, out);
    take(next_key, rest...);
  }
  // The value that a word stands for.
  template <class Value>
  void take_one_of(const std::string& key, Value& out, const std::vector<std::pair<std::string, Value>>& known) {
    if (schema_) {
      auto words = nlohmann::ordered_json::array();
      for (const auto& one : known) words.push_back(one.first);
      list(key, {{"enum", words}});
      return;
    }
    std::string word;
    take(key, word);
    if (!next(key)) return;
    std::string expected;
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (known[i].first == word) {
        out = known[i].second;
        return;
      }
      expected += (i == 0 ? "" : i + 1 < known.size() ? ", " : " or ") + known[i].first;
    }
    fail(*next(key), key, "is \"" + word + "\", expected " + expected);
  }
  // [[key]]: read(TableReader&, Spec&) for each entry.
  template <class Spec, class Read>
  void take_list(const std::string& key, std::vector<Spec>& out, const Read& read) {
    if (schema_) {
      nlohmann::ordered_json entry;
      out.emplace_back();
      try {
        TableReader table(entry);
        read(table, out.back());
      } catch (const InputError&) {  // its keys are listed
      }
      list(key, {{"type", "array"}, {"items", entry}});
      return;
    }
    const ConfigNode* value = next(key);
    if (!value) return;
    if (value->kind != ConfigNode::Kind::kList) fail(*value, key, "expected [[" + key + "]]");
    for (const ConfigNode& entry : value->list) {
      TableReader table(file_, key, entry);
      out.emplace_back();
      read(table, out.back());
      table.done();
    }
  }
  // [key]: read(TableReader&) when it is there.
  template <class Read>
  void take_table(const std::string& key, const Read& read) {
    if (schema_) {
      nlohmann::ordered_json entry;
      TableReader table(entry);
      read(table);
      list(key, entry);
      return;
    }
    const ConfigNode* node = next(key);
    if (!node) return;
    TableReader table(file_, key, *node);
    read(table);
    table.done();
  }
  const ConfigNode* next(const std::string& key);  // marks the key as known; null when it is not there
  const std::string& file() const { return file_; }
  int line() const { return node_.line; }  // of the table
  void require(const std::string& key, bool given) const;
  void done() const;  // complains about keys that nobody took
  [[noreturn]] void fail(const std::string& key, const std::string& what) const { fail(node_, key, what); }
  [[noreturn]] void fail(const ConfigNode& at, const std::string& key, const std::string& what) const;

 private:
  std::string text(const std::string& key, const ConfigNode& value) const;
  void list(const std::string& key, nlohmann::ordered_json type);

  std::string file_, path_;
  const ConfigNode& node_;
  nlohmann::ordered_json* schema_ = nullptr;
  std::vector<std::string> known_;
};

}  // namespace footfall
