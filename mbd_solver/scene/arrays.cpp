// Visitors that copy an entry, turn it, and replace "{array}" in its texts.
#include "mbd_solver/scene/arrays.h"

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/tracking_visitor.h"

namespace footfall {

namespace {

constexpr int kMostCopies = 1000;

bool replace_all(std::string& text, const std::string& from, const std::string& to) {
  bool found = false;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
    found = true;
  }
  return found;
}

// Calls action for every text of a member.
template <class Action>
void for_each_text(const FieldRef& ref, const Action& action) {
  if (auto* const* text = std::get_if<std::string*>(&ref)) action(**text);
  if (auto* const* texts = std::get_if<std::vector<std::string>*>(&ref)) {
    for (std::string& text : **texts) action(text);
  }
  if (auto* const* pair = std::get_if<std::array<std::string, 2>*>(&ref)) {
    for (std::string& text : **pair) action(text);
  }
}

class MentionFinder final : public TrackingVisitor {
 public:
  explicit MentionFinder(std::string mark) : mark_(std::move(mark)) {}
  bool found() const { return found_; }
  void field(const std::string&, const FieldRef& ref, const Rule&) override {
    for_each_text(ref, [&](const std::string& text) { found_ = found_ || text.find(mark_) != std::string::npos; });
  }

 private:
  std::string mark_;
  bool found_ = false;
};

class Copier final : public TrackingVisitor {
 public:
  Copier(std::string mark, int index, const Eigen::Quaterniond& turn)
      : mark_(std::move(mark)), number_(std::to_string(index)), turn_(turn) {}

  void field(const std::string&, const FieldRef& ref, const Rule& rule) override {
    for_each_text(ref, [&](std::string& text) { replace_all(text, mark_, number_); });
    if (auto* const* source = std::get_if<Source*>(&ref)) replace_all((*source)->path, mark_, number_);
    if (auto* const* orientation = std::get_if<Eigen::Quaterniond*>(&ref))
      **orientation = (turn_ * **orientation).normalized();
    const bool turns =
        rule.meaning == Meaning::kPoint || rule.meaning == Meaning::kDirection || rule.meaning == Meaning::kFree;
    if (!turns) return;
    if (auto* const* v = std::get_if<Eigen::Vector3d*>(&ref)) turn(**v);
    if (auto* const* v = std::get_if<std::optional<Eigen::Vector3d>*>(&ref)) {
      if (**v) turn(***v);
    }
    if (auto* const* list = std::get_if<std::vector<Eigen::Vector3d>*>(&ref)) {
      for (Eigen::Vector3d& v : **list) turn(v);
    }
    if (auto* const* pair = std::get_if<std::array<Eigen::Vector3d, 2>*>(&ref)) {
      for (Eigen::Vector3d& v : **pair) turn(v);
    }
  }

 private:
  void turn(Eigen::Vector3d& v) const { v = turn_ * v; }
  std::string mark_, number_;
  Eigen::Quaterniond turn_;
};

// Names in lists that were not copied with an entry: ["footpad_{leg}"] becomes ["footpad_1", "footpad_2", ...].
class NameExpander final : public TrackingVisitor {
 public:
  NameExpander(std::string mark, int count) : mark_(std::move(mark)), count_(count) {}
  void field(const std::string&, const FieldRef& ref, const Rule&) override {
    auto* const* names = std::get_if<std::vector<std::string>*>(&ref);
    if (!names) return;
    std::vector<std::string> result;
    for (const std::string& name : **names) {
      if (name.find(mark_) == std::string::npos) {
        result.push_back(name);
        continue;
      }
      for (int k = 1; k <= count_; ++k) {
        replace_all(result.emplace_back(name), mark_, std::to_string(k));
      }
    }
    **names = result;
  }

 private:
  std::string mark_;
  int count_;
};

class LeftoverFinder final : public TrackingVisitor {
 public:
  LeftoverFinder(std::vector<std::string> arrays, Findings& findings)
      : arrays_(std::move(arrays)), findings_(findings) {}
  void field(const std::string& key, const FieldRef& ref, const Rule& rule) override {
    if (track(ref) || rule.meaning != Meaning::kName) return;
    for_each_text(ref, [&](const std::string& text) {
      const std::size_t open = text.find('{');
      if (open == std::string::npos) return;
      const std::string name = text.substr(open + 1, text.find('}', open) - open - 1);
      findings_.error(code::kUnknownArray, *source(), local(key),
                      "\"" + text + "\" names no array." + known_names("arrays", name, arrays_));
    });
  }

 private:
  std::vector<std::string> arrays_;
  Findings& findings_;
};

template <class T>
void copy_entries(std::vector<T>& entries, const ArraySpec& array) {
  const std::string mark = "{" + array.name + "}";
  std::vector<T> result;
  for (T& entry : entries) {
    MentionFinder finder(mark);
    visit_fields(finder, entry);
    if (!finder.found()) {
      result.push_back(entry);
      continue;
    }
    for (int k = 1; k <= array.count; ++k) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(array.start + (k - 1) * array.step, array.axis));
      Copier copier(mark, k, turn);
      visit_fields(copier, result.emplace_back(entry));
    }
  }
  entries = std::move(result);
}

}  // namespace

void apply_arrays(Scene& scene, Findings& findings) {
  std::vector<std::string> names;
  for (const ArraySpec& array : scene.arrays) {
    names.push_back(array.name);
    if (array.count > kMostCopies) {
      findings.error(code::kTooManyCopies, array.source, "count",
                     "is " + std::to_string(array.count) + ", expected at most " + std::to_string(kMostCopies));
      continue;
    }
    copy_entries(scene.bodies, array);
    copy_entries(scene.joints, array);
    copy_entries(scene.struts, array);
    copy_entries(scene.springs, array);
    copy_entries(scene.forces, array);
    copy_entries(scene.drives, array);
    copy_entries(scene.gears, array);
    copy_entries(scene.boundaries, array);
    copy_entries(scene.contacts, array);
    copy_entries(scene.initial.bodies, array);
    NameExpander expander("{" + array.name + "}", array.count);
    visit_fields(expander, scene);
  }
  LeftoverFinder leftovers(names, findings);
  visit_fields(leftovers, scene);
}

}  // namespace footfall
