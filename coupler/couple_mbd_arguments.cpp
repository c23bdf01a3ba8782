// Reads keyword after keyword; every error repeats the syntax or the values that are expected.

#include "coupler/couple_mbd_arguments.h"

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/codes.h"

namespace footfall {
namespace {

constexpr const char* kUsage =
    "expected: fix ID all couple/mbd every N|auto [patience SECONDS] [gravity scene|script] [end scene|script] "
    "[lost SHARE] [outflow yes|no] [surface smooth|facets|round] [edge DEGREES] [damping_mass grain|pair] [mesh "
    "MESH-ID BODY]...";
const std::vector<std::string> kKeywords = {"every",   "patience", "gravity", "end",          "lost",
                                            "outflow", "surface",  "edge",    "damping_mass", "mesh"};
constexpr int kMostSubsteps = 1000000;  // per window

// Reads the words in order. Throws InputError, whose message begins with `fix`, for unexpected words.
class Reader {
 public:
  Reader(std::string fix, const std::vector<std::string>& words, std::size_t first)
      : fix_(std::move(fix)), words_(words), next_(first) {}
  bool more() const { return next_ < words_.size(); }
  const std::string& keyword() const { return words_[next_]; }
  // The n-th word after the keyword.
  const std::string& value(std::size_t n = 1) const {
    if (next_ + n >= words_.size()) wrong_keyword();
    return words_[next_ + n];
  }
  void step(std::size_t words) { next_ += words; }
  [[noreturn]] void wrong_keyword() const {
    const std::string meant = nearest_name(keyword(), kKeywords);
    throw InputError(code::kCoupleMbdSyntax,
                     fix_ + "at \"" + keyword() + "\" " +
                         (meant.empty() || meant == keyword() ? "" : "(did you mean \"" + meant + "\"?) ") + kUsage);
  }
  [[noreturn]] void wrong_value(const std::string& needs) const {
    throw InputError(code::kCoupleMbdValue, fix_ + "`" + keyword() + "` needs " + needs + ", not \"" + value() + "\"");
  }
  // Is the value `scene` (and not `script`)?
  bool is_scene() const {
    if (value() != "scene" && value() != "script") wrong_value("`scene` or `script`");
    return value() == "scene";
  }

 private:
  std::string fix_;
  const std::vector<std::string>& words_;
  std::size_t next_;
};

}  // namespace

CoupleMbdArguments::CoupleMbdArguments(int narg, const char* const* arg) {
  const std::vector<std::string> words(arg, arg + narg);
  FOOTFALL_DEMAND(words.size() >= 3);
  fix = "fix " + words[0] + " " + words[2] + ": ";
  if (words.size() < 4) throw InputError(code::kCoupleMbdSyntax, fix + kUsage);
  Reader reader(fix, words, 3);
  if (words[3] != "every") reader.wrong_keyword();
  if (reader.value() != "auto") {
    const std::optional<int> n = whole_number(reader.value(), 1, kMostSubsteps);
    if (!n) reader.wrong_value("a number of steps from 1 to " + std::to_string(kMostSubsteps) + " or `auto`");
    every = *n;
  }
  for (reader.step(2); reader.more();) {
    const std::string& keyword = reader.keyword();
    if (keyword == "mesh") {
      const MeshOfBody pair{reader.value(1), reader.value(2)};
      for (const MeshOfBody& other : meshes)
        if (other.mesh == pair.mesh)
          throw InputError(code::kMeshNamedTwice, fix + "mesh " + pair.mesh + " is already coupled to body \"" +
                                                      other.body + "\"; name it once");
      meshes.push_back(pair);
      reader.step(3);
      continue;
    }
    if (keyword == "patience") {
      patience = positive_number(reader.value());
      if (!patience) reader.wrong_value("a positive number of seconds");
    } else if (keyword == "gravity") {
      gravity_of_scene = reader.is_scene();
    } else if (keyword == "end") {
      end_of_scene = reader.is_scene();
    } else if (keyword == "lost") {
      const std::optional<double> share = positive_number(reader.value());
      if (!share || *share > 1.0) reader.wrong_value("a share of the grains above 0 and at most 1");
      max_lost = *share;
    } else if (keyword == "outflow") {
      if (reader.value() != "yes" && reader.value() != "no") reader.wrong_value("`yes` or `no`");
      outflow = reader.value() == "yes";
    } else if (keyword == "surface") {
      if (reader.value() == "smooth") {
        surface = Surface::kSmooth;
      } else if (reader.value() == "facets") {
        surface = Surface::kFacets;
      } else if (reader.value() == "round") {
        surface = Surface::kRound;
      } else {
        reader.wrong_value("`smooth`, `facets` or `round`");
      }
    } else if (keyword == "damping_mass") {
      if (reader.value() != "grain" && reader.value() != "pair") reader.wrong_value("`grain` or `pair`");
      mass_of_pair = reader.value() == "pair";
    } else if (keyword == "edge") {
      const std::optional<double> degrees = positive_number(reader.value());
      if (!degrees || *degrees > 90.0) reader.wrong_value("an angle above 0 and at most 90 degrees");
      edge_angle = *degrees * M_PI / 180.0;
    } else {
      reader.wrong_keyword();
    }
    reader.step(2);
  }
}

}  // namespace footfall
