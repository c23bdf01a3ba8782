// A visitor that writes values.
#include "mbd_solver/scene/scene_json.h"

#include "mbd_solver/scene/field_json.h"

namespace footfall {

namespace {

class JsonWriter final : public FieldVisitor {
 public:
  Json root = Json::object();

  void field(const std::string& key, const FieldRef& ref, const Rule&) override {
    if (!key.empty()) current()[key] = json_of(ref);
  }
  bool begin_section(const std::string& key, Presence, bool& present) override {
    Json& place = current()[key];
    if (!present) return false;
    place = Json::object();
    stack_.push_back(&place);
    return true;
  }
  void end_section() override { stack_.pop_back(); }
  int begin_list(const std::string& key, bool named, int count) override {
    Json& place = current()[key];
    place = named ? Json::object() : Json::array();
    stack_.push_back(&place);
    return count;
  }
  void begin_item(int, std::string* name) override {
    Json& list = current();
    if (!name) list.push_back(Json::object());
    Json& item = name ? list[*name] : list.back();
    stack_.push_back(&item);
  }
  void end_item() override { stack_.pop_back(); }
  void end_list() override { stack_.pop_back(); }

 private:
  Json& current() { return stack_.empty() ? root : *stack_.back(); }
  std::vector<Json*> stack_;
};

}  // namespace

std::string scene_json(const Scene& scene) {
  JsonWriter writer;
  Scene copy = scene;
  visit_fields(writer, copy);
  return writer.root.dump(2);
}

}  // namespace footfall
