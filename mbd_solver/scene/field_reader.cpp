// The visitor that fills structs from a tree of values and remembers which keys were known, found and refused.
#include "mbd_solver/scene/field_reader.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/value_checks.h"
#include "mbd_solver/scene/value_reader.h"

namespace footfall {

using namespace code;

namespace {

const ConfigNode& empty_table() {
  static const ConfigNode node;
  return node;
}

class FieldReader final : public FieldVisitor {
 public:
  FieldReader(const ConfigNode& root, const std::string& folder, Findings& findings)
      : folder_(folder), findings_(findings) {
    frames_.push_back({&root, "", "", nullptr, {}, {}});
  }
  void finish() { report_unknown_keys(); }

  void field(const std::string& key, const FieldRef& ref, const Rule& rule) override {
    if (Source* const* source = std::get_if<Source*>(&ref)) {
      Frame& frame = frames_.back();
      **source = Source{frame.path, frame.node->line, {}, {}};
      frame.source = *source;
      frame.local.clear();
      return;
    }
    const std::optional<Given> given = take(key, rule);
    if (!given) return;
    const ValueContext context{rule, given->factor, folder_};
    const std::string problem =
        std::visit([&](auto* target) { return read_value(*given->node, context, *target); }, ref);
    if (problem.empty()) return;
    findings_.coded_error(given->node->line, path_of(given->written), problem);
    const Frame& frame = frames_.back();
    if (frame.source) frame.source->refused.insert(frame.local + key);
  }

  bool begin_section(const std::string& key, Presence presence, bool& present) override {
    const std::optional<Given> given = take(key, {});
    const ConfigNode* node = given ? given->node : &empty_table();
    if (given && presence == Presence::kSwitch && node->kind == ConfigNode::Kind::kFlag) {
      present = true;  // flexible = true / false is short for { enabled = true / false }
      switch_table_ = ConfigNode{};
      switch_table_.table.emplace_back("enabled", *node);
      node = &switch_table_;
    } else if (given && node->kind != ConfigNode::Kind::kTable) {
      const std::string expected = presence == Presence::kSwitch ? "a table, true or false" : "a table";
      findings_.coded_error(node->line, path_of(key), is_expected(*node, expected));
      node = &empty_table();
      present = presence == Presence::kAlways;
      if (!present) return false;
    } else if (presence != Presence::kAlways) {
      present = given.has_value();
      if (!present) return false;
    }
    push(key, *node);
    return true;
  }

  void end_section() override { pop(); }

  int begin_list(const std::string& key, bool named, int) override {
    lists_.push_back({nullptr, key, named});
    const std::optional<Given> given = take(key, {});
    if (!given) return 0;
    const ConfigNode& node = *given->node;
    const bool is_list = node.kind == ConfigNode::Kind::kList &&
                         std::all_of(node.list.begin(), node.list.end(),
                                     [](const ConfigNode& n) { return n.kind == ConfigNode::Kind::kTable; });
    const bool is_named = node.kind == ConfigNode::Kind::kTable &&
                          std::all_of(node.table.begin(), node.table.end(),
                                      [](const auto& n) { return n.second.kind == ConfigNode::Kind::kTable; });
    if (named ? !is_named : !is_list) {
      const std::string path = path_of(key);
      findings_.coded_error(node.line, path,
                            is_expected(node, named ? "tables with names, [" + path + ".NAME]"
                                                    : "a list of tables, [[" + path + "]] or [{...}, {...}]"));
      return 0;
    }
    lists_.back().node = &node;
    return static_cast<int>(named ? node.table.size() : node.list.size());
  }

  void begin_item(int index, std::string* name) override {
    const List& list = lists_.back();
    const auto i = static_cast<std::size_t>(index);
    const ConfigNode& node = list.named ? list.node->table[i].second : list.node->list[i];
    if (name) *name = list.node->table[i].first;
    std::string label = list.named ? list.node->table[i].first : node.entry_name();
    if (label.empty()) label = std::to_string(index);
    push(list.key + "." + label, node);
    frames_.back().local = frames_[frames_.size() - 2].local + list.key + "." + std::to_string(index) + ".";
  }

  void end_item() override { pop(); }
  void end_list() override { lists_.pop_back(); }

 private:
  struct Frame {
    const ConfigNode* node;
    std::string path;                // for messages: "bodies.cabin.shape"
    std::string local;               // before a key in source->lines: "shape."
    Source* source;                  // of the entry around
    std::vector<std::string> known;  // keys that are described
    std::vector<std::string> taken;  // keys that the file has, as written
  };
  struct List {
    const ConfigNode* node;
    std::string key;
    bool named;
  };
  struct Given {
    const ConfigNode* node;
    double factor;        // to SI
    std::string written;  // the key with its suffix
  };

  void push(const std::string& key, const ConfigNode& node) {
    const Frame& outer = frames_.back();
    frames_.push_back({&node, path_of(key), outer.local + key + ".", outer.source, {}, {}});
  }

  void pop() {
    report_unknown_keys();
    frames_.pop_back();
  }

  std::string path_of(const std::string& key) const {
    const std::string& path = frames_.back().path;
    return path.empty() ? key : path + "." + key;
  }
  void report(const MessageCode& code, const std::string& key, int line, const std::string& what) {
    findings_.error(code, line, path_of(key), what);
  }

  // The value of `key`, whichever unit suffix it is written with; records it as known, taken and given.
  std::optional<Given> take(const std::string& key, const Rule& rule) {
    Frame& frame = frames_.back();
    frame.known.push_back(key);
    std::vector<Given> found;
    if (const ConfigNode* node = frame.node->find(key)) found.push_back({node, 1.0, key});
    for (const UnitSuffix& unit : unit_suffixes(rule.unit)) {
      const std::string written = key + unit.suffix;
      if (const ConfigNode* node = frame.node->find(written)) found.push_back({node, unit.factor, written});
    }
    if (found.empty()) {
      if (rule.required) {
        const std::string unit = unit_name(rule.unit);
        report(kMissingKey, key, frame.node->line,
               "is missing; it has no default" + (unit.empty() ? "" : " (unit " + unit + ")"));
      }
      return std::nullopt;
    }
    for (const Given& g : found) frame.taken.push_back(g.written);
    if (found.size() > 1)
      report(kUnitSuffix, found[1].written, found[1].node->line,
             "is also given as \"" + found[0].written + "\"; keep one of the two");
    // --set overrides the file.
    const auto set =
        std::find_if(found.begin(), found.end(), [](const Given& g) { return g.node->line == Source::kFromSet; });
    const Given& chosen = set != found.end() ? *set : found.front();
    if (frame.source) frame.source->lines[frame.local + key] = chosen.node->line;
    return chosen;
  }

  void report_unknown_keys() {
    const Frame& frame = frames_.back();
    for (const auto& [key, node] : frame.node->table) {
      if (std::find(frame.taken.begin(), frame.taken.end(), key) != frame.taken.end()) continue;
      report(kUnknownKey, key, node.line, "unknown key." + known_names("keys here", key, frame.known));
    }
  }

  std::string folder_;
  Findings& findings_;
  std::vector<Frame> frames_;
  std::vector<List> lists_;
  ConfigNode switch_table_;
};

}  // namespace

void read_fields(const ConfigNode& root, const std::string& folder, const std::function<void(FieldVisitor&)>& describe,
                 Findings& findings) {
  FieldReader reader(root, folder, findings);
  describe(reader);
  reader.finish();
}

void read_fields(const ConfigNode& root, Scene& scene, Findings& findings) {
  read_fields(
      root, scene.folder, [&](FieldVisitor& reader) { visit_fields(reader, scene); }, findings);
}

}  // namespace footfall
