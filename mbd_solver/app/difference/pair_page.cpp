// The second run is made into the parts of a page of its own, which become parts of the first one under other names.
#include "mbd_solver/app/difference/pair_page.h"

namespace footfall {

namespace {

constexpr const char* kOther = "other-";
constexpr std::size_t kMostListed = 40;  // keys of scenes in the page

// Makes the parts of a page of its own into parts of another one.
void add_other(PageParts theirs, const std::string& name, const std::string& other, PageParts& parts) {
  theirs.run["name"] = other;
  parts.run["name"] = name;
  parts.run["other"] = theirs.run;
  const auto renamed = [](const PageParts::Chunk& chunk) {
    return PageParts::Chunk(kOther + chunk.first, chunk.second);
  };
  for (const PageParts::Chunk& chunk : theirs.chunks) parts.chunks.push_back(renamed(chunk));
  for (const auto& [k, frame] : theirs.later)
    for (const PageParts::Chunk& chunk : frame) parts.later[k].push_back(renamed(chunk));
}

}  // namespace

void add_second_run(const RunPair& pair, bool shapes, PageParts& parts) {
  PageParts theirs;
  FrameLimits limits;
  add_history(pair.b.history, {}, theirs);
  if (shapes) add_bodies(pair.b.folder, pair.b.summary, limits, theirs);
  add_other(std::move(theirs), pair.a.name, pair.b.name, parts);
  parts.run["differences"] = nlohmann::ordered_json::array();
  for (const KeyDifference& one : scene_differences(pair.a.scene, pair.b.scene))
    if (parts.run["differences"].size() < kMostListed) parts.run["differences"].push_back({one.key, one.a, one.b});
}

PageParts plots_of_histories(const NamedHistory& first, const NamedHistory& second,
                             const std::vector<std::string>& shown) {
  PageParts parts, theirs;
  add_history(first.history, shown, parts);
  add_history(second.history, {}, theirs);
  add_other(std::move(theirs), first.name, second.name, parts);
  return parts;
}

PageParts plots_of_pair(const RunPair& pair, const std::vector<std::string>& shown) {
  PageParts parts;
  add_history(pair.a.history, shown, parts);
  add_second_run(pair, false, parts);
  return parts;
}

}  // namespace footfall
