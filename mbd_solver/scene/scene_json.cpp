#include "mbd_solver/scene/scene_json.h"

#include <nlohmann/json.hpp>

#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(double v) { return v; }
Json to_json(int v) { return v; }
Json to_json(bool v) { return v; }
Json to_json(const std::string& v) { return v; }
Json to_json(const Eigen::Vector2d& v) { return {v[0], v[1]}; }
Json to_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
Json to_json(const Eigen::Quaterniond& q) { return {{"quaternion", {q.w(), q.x(), q.y(), q.z()}}}; }
Json to_json(const Eigen::Matrix3d& m) { return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}; }
Json to_json(const std::map<std::string, std::string>& v) { return v.empty() ? Json::object() : Json(v); }
Json to_json(const Choice& v) { return v.names[static_cast<std::size_t>(v.value)]; }
Json to_json(const NumberOrWord& v) { return *v.number; }
Json to_json(const PerAxis& v) {
  const Eigen::Vector3d& k = *v.values;
  return k[0] == k[1] && k[1] == k[2] ? Json(k[0]) : to_json(k);
}
Json to_json(const Source&) { return nullptr; }
template <class T>
Json to_json(const std::optional<T>& v) {
  return v ? to_json(*v) : Json(nullptr);
}
template <class Range>
Json list_to_json(const Range& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(to_json(value));
  return list;
}
template <class T>
Json to_json(const std::vector<T>& v) {
  return list_to_json(v);
}
template <class T, std::size_t N>
Json to_json(const std::array<T, N>& v) {
  return list_to_json(v);
}

class JsonWriter final : public FieldVisitor {
 public:
  Json root = Json::object();

  void field(const std::string& key, const FieldRef& ref, const Rule&) override {
    if (!key.empty()) current()[key] = std::visit([](const auto* value) { return to_json(*value); }, ref);
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
