// Walks that copy an entry, turn it, and replace "{array}" in its texts.
#include "mbd_solver/scene/arrays.h"

#include <algorithm>

#include "coupler/base/text.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/tracking_visitor.h"

namespace footfall {

namespace {

constexpr int kMostCopies = 1000;

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// Calls action for every text of a member.
template <class Action>
void for_each_text(const FieldRef& ref, const Action& action) {
  if (std::string* text = member<std::string>(ref)) action(*text);
  if (auto* texts = member<std::vector<std::string>>(ref)) std::for_each(texts->begin(), texts->end(), action);
  if (auto* pair = member<std::array<std::string, 2>>(ref)) std::for_each(pair->begin(), pair->end(), action);
}

template <class T>
bool mentions(T& entry, const std::string& mark) {
  bool found = false;
  FieldWalk walk([&](const std::string&, const FieldRef& ref, const Rule&, const FieldWalk&) {
    for_each_text(ref, [&](const std::string& text) { found = found || text.find(mark) != std::string::npos; });
  });
  visit_fields(walk, entry);
  return found;
}

template <class T>
void make_copy(T& entry, const std::string& mark, int index, const Eigen::Quaterniond& turn) {
  const std::string number = std::to_string(index);
  const auto turn_vector = [&](Eigen::Vector3d& v) { v = turn * v; };
  FieldWalk walk([&](const std::string&, const FieldRef& ref, const Rule& rule, const FieldWalk&) {
    for_each_text(ref, [&](std::string& text) { replace_all(text, mark, number); });
    if (Source* source = member<Source>(ref)) replace_all(source->path, mark, number);
    if (auto* orientation = member<Eigen::Quaterniond>(ref)) *orientation = (turn * *orientation).normalized();
    if (rule.meaning != Meaning::kPoint && rule.meaning != Meaning::kDirection && rule.meaning != Meaning::kFree)
      return;
    if (auto* v = member<Eigen::Vector3d>(ref)) turn_vector(*v);
    if (auto* v = member<std::optional<Eigen::Vector3d>>(ref); v && *v) turn_vector(**v);
    if (auto* list = member<std::vector<Eigen::Vector3d>>(ref)) std::for_each(list->begin(), list->end(), turn_vector);
    if (auto* pair = member<std::array<Eigen::Vector3d, 2>>(ref))
      std::for_each(pair->begin(), pair->end(), turn_vector);
  });
  visit_fields(walk, entry);
}

template <class T>
void copy_entries(std::vector<T>& entries, const ArraySpec& array) {
  const std::string mark = "{" + array.name + "}";
  std::vector<T> result;
  for (T& entry : entries) {
    const bool copied = mentions(entry, mark);
    if (!copied) result.push_back(entry);
    for (int k = 1; copied && k <= array.count; ++k) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(array.start + (k - 1) * array.step, array.axis));
      make_copy(result.emplace_back(entry), mark, k, turn);
    }
  }
  entries = std::move(result);
}

// Names in lists that were not copied with an entry: ["footpad_{leg}"] becomes ["footpad_1", "footpad_2", ...].
void expand_names(Scene& scene, const ArraySpec& array) {
  const std::string mark = "{" + array.name + "}";
  FieldWalk walk([&](const std::string&, const FieldRef& ref, const Rule&, const FieldWalk&) {
    auto* names = member<std::vector<std::string>>(ref);
    if (!names) return;
    std::vector<std::string> result;
    for (const std::string& name : *names) {
      const bool copied = name.find(mark) != std::string::npos;
      if (!copied) result.push_back(name);
      for (int k = 1; copied && k <= array.count; ++k) replace_all(result.emplace_back(name), mark, std::to_string(k));
    }
    *names = result;
  });
  visit_fields(walk, scene);
}

// Braces that remain name no array.
void report_unknown_arrays(Scene& scene, const std::vector<std::string>& arrays, Findings& findings) {
  FieldWalk walk([&](const std::string& key, const FieldRef& ref, const Rule& rule, const FieldWalk& at) {
    if (rule.meaning != Meaning::kName) return;
    for_each_text(ref, [&](const std::string& text) {
      const std::size_t open = text.find('{');
      if (open == std::string::npos) return;
      const std::string name = text.substr(open + 1, text.find('}', open) - open - 1);
      findings.error(code::kUnknownArray, *at.source(), at.local(key),
                     "\"" + text + "\" names no array." + known_names("arrays", name, arrays));
    });
  });
  visit_fields(walk, scene);
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
    expand_names(scene, array);
  }
  report_unknown_arrays(scene, names, findings);
}

}  // namespace footfall
