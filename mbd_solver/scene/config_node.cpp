// Look-up and descriptions of nodes.
#include "mbd_solver/scene/config_node.h"

#include "coupler/base/text.h"

namespace footfall {

const ConfigNode* ConfigNode::find(const std::string& key) const {
  for (const auto& [name, node] : table) {
    if (name == key) return &node;
  }
  return nullptr;
}

ConfigNode* ConfigNode::find(const std::string& key) {
  return const_cast<ConfigNode*>(static_cast<const ConfigNode*>(this)->find(key));
}

std::string ConfigNode::entry_name() const {
  for (const char* key : {"name", "body"}) {
    const ConfigNode* node = find(key);
    if (node && node->kind == Kind::kText) return node->text;
  }
  return "";
}

std::string ConfigNode::description() const {
  switch (kind) {
    case Kind::kTable: return "a table";
    case Kind::kList: return "a list of " + std::to_string(list.size());
    case Kind::kText: return "text \"" + text + "\"";
    case Kind::kInteger:
    case Kind::kNumber: return "the number " + number_text(number);
    case Kind::kFlag: return flag ? "true" : "false";
    case Kind::kOther: break;
  }
  return "a date or time";
}

}  // namespace footfall
