// A scan collects switches and values from the parts of the expressions, and finds the corners of one block of the run at a time,
// when it is first needed or the state of the scene has changed.

#include "mbd_solver/model/control/given_signals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "coupler/base/errors.h"
#include "mbd_solver/model/control/signal_blocks.h"

namespace footfall {
namespace {

using PartKind = ExpressionPart::Kind;

constexpr double kNoCorner = std::numeric_limits<double>::infinity();
constexpr int kRounds = 8;                    // of looking for corners between those found so far
constexpr double kFinest = 1e-20;             // times closer than this are one [s]
constexpr double kNoClass = -1e300;           // where an expression has no value
constexpr double kNoWidth = 1e-9;             // variation that does not count, of the largest value in a block [-]
constexpr double kTiny = 1e-12;               // likewise, [unit]
constexpr double kBend = 0.3;                 // distance from a line, of the variation, that does not count [-]
constexpr std::size_t kMostCorners = 200000;  // of a block
constexpr std::size_t kMostExtremes = 200;    // of arguments in a block, where a narrow bump is sought
constexpr int kHalvings = 40;                 // points near a corner: at cell / 2, cell / 4, ...
constexpr double kDense = 0.25;               // turning points per point of the grid from which it is too coarse
constexpr double kQuadrature = 1e-14;         // error of a step, of the largest integral over a block [-]
constexpr double kSlow = 0.125;               // fall of that error with half the step; of smooth values 1/64
constexpr double kRounded = 1e-11;            // the same error, as round-off may be [-]
constexpr int kMostSplits = 12;               // halvings of the time between two corners
constexpr int kGolden = 40;                   // steps of a search for an extreme: to 1e-8 of a cell

// No time of a step lies between: near zero doubles are closer than a step can be long (-0.1 t is zero until 2e-323 s).
bool neighbours(double a, double b) { return std::max(std::nextafter(a, kNoCorner), a + kFinest) >= b; }

}  // namespace

struct GivenSignals::Scan {
  // How a part depends on time: degree 0 is constant, 1 a line, 2 anything else, in one piece or in several between switches.
  struct Shape {
    bool known = true;  // nothing of it depends on the motion
    bool varies = false;
    int degree = 0;
    bool pieces = false;
    bool rough = false;  // of a fuzzy system: bends where nothing shows it
  };
  // The class of a switch, from the value of its argument.
  enum class Classes {
    kNegative,  // g < 0: corners of < >= abs min max, and zeros
    kPositive,  // g > 0: <= >
    kSign,      // -1, 0, 1: == != sign, conditions
    kLevel      // the value itself: rint
  };
  struct Switch {
    std::string owner;
    Expression argument;
    Classes classes;
    bool smooth;  // its argument is no line: it may touch zero between two points
  };
  // A value whose variation the steps must see.
  struct Value {
    std::string owner;
    Expression expression;
    bool curved;  // no line between corners
    bool rough;   // as Shape::rough: no step is short enough for its bends, and the error test decides
    bool splits() const { return curved && !rough; }
  };
  struct Node {
    const SignalBlock* block;
    std::vector<Expression> inputs;
    std::vector<std::string> texts;  // of the inputs
    std::vector<int> active_in;
    double* output;             // of its value among the names; null: not given, or read by none
    std::vector<Shape> shapes;  // of the inputs
    bool pieces = false;        // its block has several, and its inputs are given
    Eigen::VectorXd u;          // its inputs
    std::string name;           // by which others read it
    bool read = false;          // something that is scanned depends on it: it is evaluated at every place
  };
  struct Point {
    double t = 0.0;
    std::vector<double> argument, cls;  // per switch; then pieces per node
    std::vector<double> value;
  };
  using Points = std::vector<Point>;

  Scan(const std::vector<GivenEntry>& entries, const std::function<GivenSource(const std::string&)>& source,
       double t_end);

  static Shape combined(const Shape& a, const Shape& b, int degree);
  static Shape shape_of(const ExpressionPart& part, const std::vector<Shape>& of_parts,
                        const std::map<std::string, Shape>& names);
  static double class_of(Classes classes, double g);
  void add(const GivenEntry& entry, const std::function<GivenSource(const std::string&)>& source);
  Shape analyse(const ExpressionPart& part, const std::string& owner);  // of an input; collects switches and values
  Shape shape(const ExpressionPart& part, std::map<const ExpressionPart*, Shape>& shapes) const;
  void collect(const ExpressionPart& part, const std::string& owner, std::map<const ExpressionPart*, Shape>& shapes);
  void collect_switches(const ExpressionPart& part, const std::string& owner, bool bends,
                        std::map<const ExpressionPart*, Shape>& shapes);
  void add_switch(const std::string& owner, const std::string& text, Classes classes, bool smooth);
  void read_by(const std::string& text);  // marks the nodes that an expression reads, and those that these read
  void report_too_fast(const std::string& owner);

  double block_length() const { return curved ? t_end / kBlocks : t_end; }
  bool is_empty() const { return switches.empty() && values.empty() && piece_count == 0; }
  void evaluate(double t, Point& point);
  Point at(double t) {
    Point point;
    evaluate(t, point);
    return point;
  }
  Corner next(double t, const Eigen::VectorXd& values_now);
  void scan_block(long block);
  Points find_switches(double begin, double end);
  void bisect(const Point& a, const Point& b, std::size_t k, Points& found);
  bool find_touch(const Point& a, const Point& b, const Point& c, std::size_t k, Points& found);
  void find_extreme(const Point& a, const Point& b, const Point& c, std::size_t k);
  std::vector<Corner> corners_of(const Points& points) const;
  void add_turns(const Points& points, double cell);
  void add_turns_of(std::size_t value, const Points& points, std::size_t begin, std::size_t end, double floor);
  void add_bends(const Points& points, std::size_t value, std::size_t begin, std::size_t end, double floor);
  void add_splits(double begin, double end);
  std::vector<double> quadrature(double a, double b);
  void split(double a, double b, const std::vector<double>& whole, const std::vector<double>& errors_before,
             int halvings);

  double t_end;  // [s]
  NamedValues names;
  std::map<std::string, Shape> name_shapes;
  std::vector<std::pair<double*, GivenSource>> sources;  // of names that are read from the run
  std::vector<Node> nodes;
  std::vector<Switch> switches;
  std::set<std::pair<std::string, Classes>> known_switches;
  std::vector<Value> values;
  std::size_t piece_count = 0;
  bool curved = false;  // something is no line: the grid is required
  std::vector<std::string> too_fast;

  std::vector<int> places;   // of the inputs that are read
  std::vector<double> held;  // their values, for which a block was scanned
  const Eigen::VectorXd* inputs = nullptr;
  long scanned = -1;              // block; -1: none
  std::vector<Corner> corners;    // of that block, in order
  std::vector<double> splits;     // likewise [s]
  std::vector<double> integrals;  // per value: the largest over a block so far
  std::vector<double> extremes;   // of the arguments of smooth switches in it [s]
  double asked = 0.0;             // the last time [s], and
  Corner answer;                  // the corner after it
};

GivenSignals::Scan::Shape GivenSignals::Scan::combined(const Shape& a, const Shape& b, int degree) {
  return {a.known && b.known, a.varies || b.varies, std::min(degree, 2), a.pieces || b.pieces, a.rough || b.rough};
}

GivenSignals::Scan::Shape GivenSignals::Scan::shape_of(const ExpressionPart& part, const std::vector<Shape>& of_parts,
                                                       const std::map<std::string, Shape>& names) {
  Shape all;
  int highest = 0;
  for (const Shape& shape : of_parts) {
    all = combined(all, shape, 0);
    highest = std::max(highest, shape.degree);
  }
  const auto stepped = [&] { return Shape{all.known, all.varies, 0, all.varies, false}; };
  const auto bent = [&](int degree) { return Shape{all.known, all.varies, degree, true, all.rough}; };
  const auto smooth = [&](int degree) { return Shape{all.known, all.varies, degree, all.pieces, all.rough}; };
  switch (part.kind) {
    case PartKind::kNumber: return {};
    case PartKind::kName: {
      const auto found = names.find(part.name);
      return found == names.end() ? Shape{} : found->second;  // else a constant
    }
    case PartKind::kCall:
      if (part.name == "abs" || part.name == "min" || part.name == "max") return bent(highest);
      if (part.name == "sign" || part.name == "rint") return stepped();
      return smooth(highest == 0 ? 0 : 2);
    case PartKind::kChoice: return bent(std::max(of_parts[1].degree, of_parts[2].degree));
    case PartKind::kLogic:
    case PartKind::kCompare: return stepped();
    case PartKind::kSum: return smooth(highest);
    case PartKind::kProduct: {
      const int left = of_parts[0].degree, right = of_parts[1].degree;
      return smooth(part.name == "*" ? std::min(left + right, 2) : right == 0 ? left : 2);
    }
    case PartKind::kPower: return smooth(highest == 0 ? 0 : 2);
    case PartKind::kPrefix: return part.name == "!" ? stepped() : smooth(highest);
  }
  FOOTFALL_DEMAND(false);
}

double GivenSignals::Scan::class_of(Classes classes, double g) {
  if (std::isnan(g)) return kNoClass;
  switch (classes) {
    case Classes::kNegative: return g < 0.0 ? 1.0 : 0.0;
    case Classes::kPositive: return g > 0.0 ? 1.0 : 0.0;
    case Classes::kSign: return g > 0.0 ? 1.0 : g < 0.0 ? -1.0 : 0.0;
    case Classes::kLevel: return g;
  }
  return kNoClass;
}

GivenSignals::Scan::Scan(const std::vector<GivenEntry>& entries,
                         const std::function<GivenSource(const std::string&)>& source, double end)
    : t_end(end) {
  for (const GivenEntry& entry : entries) add(entry, source);
}

void GivenSignals::Scan::add(const GivenEntry& entry, const std::function<GivenSource(const std::string&)>& source) {
  for (const std::string& input : entry.inputs)
    for (const std::string& name : Expression::names_in(input)) {
      if (name_shapes.count(name) != 0) continue;
      const GivenSource from = source(name);
      Shape& shape = name_shapes[name];
      double* const value = &names[name];
      shape.known = from.kind != GivenSource::Kind::kUnknown && from.kind != GivenSource::Kind::kSignal;
      shape.varies = from.kind == GivenSource::Kind::kTime || from.kind == GivenSource::Kind::kSince;
      shape.degree = shape.varies ? 1 : 0;
      if (!shape.known) *value = std::nan("");
      if (shape.known) sources.push_back({value, from});
      if (shape.known && from.place >= 0) places.push_back(from.place);
    }

  places.insert(places.end(), entry.active_in.begin(), entry.active_in.end());
  Shape all;
  Node node{entry.block,
            {},
            entry.inputs,
            entry.active_in,
            nullptr,
            {},
            false,
            Eigen::VectorXd::Zero(static_cast<Eigen::Index>(entry.inputs.size())),
            "signal." + entry.name,
            false};
  for (const std::string& input : entry.inputs) {
    node.inputs.emplace_back(input, names);
    const std::optional<ExpressionPart> part = parts_of(input);
    const Shape shape = part ? analyse(*part, entry.label) : Shape{false, false, 2, true, false};
    node.shapes.push_back(shape);
    all = combined(all, shape, std::max(all.degree, shape.degree));
  }
  const bool memoryless = entry.block->state_count() == 0 && entry.block->passes_through();
  node.pieces = all.known && all.varies && entry.block->has_pieces();
  piece_count += node.pieces ? 1 : 0;
  if (memoryless && all.known && !entry.name.empty()) {
    const bool plain = dynamic_cast<const PassBlock*>(entry.block) != nullptr;
    const bool lines = node.pieces && entry.inputs.size() == 1;
    node.output = &names["signal." + entry.name];
    const bool rough = all.rough || (all.varies && !plain && !node.pieces);
    name_shapes["signal." + entry.name] = {true, all.varies,
                                           plain || lines ? all.degree
                                           : all.varies   ? 2
                                                          : 0,
                                           all.pieces || node.pieces, rough};
    // Its own shape is not known. A fuzzy system costs much, bends where nothing shows it, and is left to the error test.
    if (all.varies && !plain && !lines && node.pieces) {
      values.push_back({entry.label, Expression("signal." + entry.name, names), true, rough});
      curved = true;
    }
  }
  if (node.output == nullptr && !node.pieces) return;
  node.read = node.pieces;
  if (node.read)
    for (const std::string& input : entry.inputs) read_by(input);
  nodes.push_back(std::move(node));
}

GivenSignals::Scan::Shape GivenSignals::Scan::shape(const ExpressionPart& part,
                                                    std::map<const ExpressionPart*, Shape>& shapes) const {
  std::vector<Shape> of_parts;
  for (const ExpressionPart& inner : part.parts) of_parts.push_back(shape(inner, shapes));
  return shapes[&part] = shape_of(part, of_parts, name_shapes);
}

GivenSignals::Scan::Shape GivenSignals::Scan::analyse(const ExpressionPart& part, const std::string& owner) {
  std::map<const ExpressionPart*, Shape> shapes;
  const Shape whole = shape(part, shapes);
  collect(part, owner, shapes);
  return whole;
}

// The largest parts that are given.
void GivenSignals::Scan::collect(const ExpressionPart& part, const std::string& owner,
                                 std::map<const ExpressionPart*, Shape>& shapes) {
  const Shape& shape = shapes[&part];
  if (!shape.known) {
    for (const ExpressionPart& inner : part.parts) collect(inner, owner, shapes);
    return;
  }
  if (!shape.varies || part.kind == PartKind::kName) return;
  const bool bends = shape.degree == 2;
  values.push_back({owner, Expression(part.text, names), bends, shape.rough});
  read_by(part.text);
  curved = curved || bends;
  collect_switches(part, owner, bends, shapes);
}

void GivenSignals::Scan::read_by(const std::string& text) {
  const std::vector<std::string> read = Expression::names_in(text);
  for (Node& node : nodes)
    if (!node.read && std::find(read.begin(), read.end(), node.name) != read.end()) {
      node.read = true;
      for (const std::string& input : node.texts) read_by(input);
    }
}

void GivenSignals::Scan::add_switch(const std::string& owner, const std::string& text, Classes classes, bool smooth) {
  if (!known_switches.insert({text, classes}).second) return;
  switches.push_back({owner, Expression(text, names), classes, smooth});
  read_by(text);
  curved = curved || smooth;
}

void GivenSignals::Scan::collect_switches(const ExpressionPart& part, const std::string& owner, bool bends,
                                          std::map<const ExpressionPart*, Shape>& shapes) {
  const auto smooth = [&](const ExpressionPart& p) { return shapes[&p].degree == 2; };
  const auto add = [&](const ExpressionPart& p, Classes classes) {
    if (shapes[&p].varies) add_switch(owner, p.text, classes, smooth(p));
  };
  const auto compare = [&](const ExpressionPart& a, const ExpressionPart& b, Classes classes) {
    if (shapes[&a].varies || shapes[&b].varies)
      add_switch(owner, "(" + a.text + ") - (" + b.text + ")", classes, smooth(a) || smooth(b));
  };
  const auto condition = [&](const ExpressionPart& p) {
    const bool is_logical =
        p.kind == PartKind::kCompare || p.kind == PartKind::kLogic || (p.kind == PartKind::kPrefix && p.name == "!");
    if (!is_logical) add(p, Classes::kSign);
  };
  switch (part.kind) {
    case PartKind::kNumber:
    case PartKind::kName: break;
    case PartKind::kCall:
      if (part.name == "rint") {
        if (shapes[&part].varies) add_switch(owner, part.text, Classes::kLevel, false);
      } else if (part.name == "sign") {
        add(part.parts[0], Classes::kSign);
      } else if (part.name == "min" || part.name == "max") {
        for (std::size_t i = 0; i < part.parts.size(); ++i)
          for (std::size_t j = i + 1; j < part.parts.size(); ++j)
            compare(part.parts[i], part.parts[j], Classes::kNegative);
      } else if (part.name == "abs" || bends) {
        for (const ExpressionPart& argument : part.parts) add(argument, Classes::kNegative);
      }
      break;
    case PartKind::kChoice: condition(part.parts[0]); break;
    case PartKind::kLogic:
      for (const ExpressionPart& operand : part.parts) condition(operand);
      break;
    case PartKind::kCompare:
      compare(part.parts[0], part.parts[1],
              part.name == "<" || part.name == ">="   ? Classes::kNegative
              : part.name == "<=" || part.name == ">" ? Classes::kPositive
                                                      : Classes::kSign);
      break;
    case PartKind::kSum:
      if (bends) add(part, Classes::kNegative);
      break;
    case PartKind::kPower: add(part.parts[0], Classes::kNegative); break;
    case PartKind::kProduct: break;
    case PartKind::kPrefix:
      if (part.name == "!") condition(part.parts[0]);
      break;
  }
  for (const ExpressionPart& inner : part.parts) collect_switches(inner, owner, bends, shapes);
}

void GivenSignals::Scan::evaluate(double t, Point& point) {
  point.t = t;
  point.argument.clear();
  point.cls.clear();
  point.value.clear();
  for (const auto& [value, source] : sources) {
    const double held_value = source.place >= 0 ? (*inputs)[source.place] : 0.0;
    *value = source.kind == GivenSource::Kind::kTime    ? t
             : source.kind == GivenSource::Kind::kSince ? t - held_value
                                                        : held_value;
  }
  std::vector<double> pieces;
  const Eigen::VectorXd none;
  for (Node& node : nodes) {
    const bool active = node.active_in.empty() || std::any_of(node.active_in.begin(), node.active_in.end(),
                                                              [&](int place) { return (*inputs)[place] != 0.0; });
    for (std::size_t i = 0; i < node.inputs.size(); ++i)
      node.u[static_cast<Eigen::Index>(i)] = node.inputs[i].value_or_nan();
    const bool has_value = active && node.u.allFinite();
    if (node.pieces) pieces.push_back(has_value ? node.block->piece(node.u) : kNoClass);
    if (node.output && node.read)
      *node.output = !active ? 0.0 : has_value ? node.block->value(node.u, none) : std::nan("");
  }
  for (const Switch& s : switches) {
    point.argument.push_back(s.argument.value_or_nan());
    point.cls.push_back(class_of(s.classes, point.argument.back()));
  }
  point.cls.insert(point.cls.end(), pieces.begin(), pieces.end());
  for (const Value& value : values) point.value.push_back(value.expression.value_or_nan());
}

// Every change of class k between a and b that appears from left to right.
void GivenSignals::Scan::bisect(const Point& a, const Point& b, std::size_t k, Points& found) {
  Point left = a;
  while (left.cls[k] != b.cls[k] && !neighbours(left.t, b.t)) {
    Point low = left, high = b;
    while (!neighbours(low.t, high.t)) {
      Point middle = at(low.t + 0.5 * (high.t - low.t));
      (middle.cls[k] == left.cls[k] ? low : high) = std::move(middle);
    }
    left = high;
    if (low.t > a.t) found.push_back(std::move(low));
    if (high.t < b.t) found.push_back(std::move(high));
    if (found.size() > kMostCorners) return report_too_fast(k < switches.size() ? switches[k].owner : "");
  }
}

// An extreme of the argument of switch k near b that crosses zero, though a, b and c lie on one side.
bool GivenSignals::Scan::find_touch(const Point& a, const Point& b, const Point& c, std::size_t k, Points& found) {
  const double fa = std::abs(a.argument[k]), fb = std::abs(b.argument[k]), fc = std::abs(c.argument[k]);
  if (a.cls[k] != b.cls[k] || b.cls[k] != c.cls[k] || !(fb <= fa && fb <= fc) || fb == 0.0) return false;
  const double bend = fa + fc - 2.0 * fb;
  if (!(fb < 2.0 * bend)) return false;  // far above the axis for its curvature
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = a.t, high = c.t;
  for (int i = 0; i < kGolden; ++i) {
    Point p = at(high - golden * (high - low)), q = at(low + golden * (high - low));
    for (Point* const inner : {&p, &q})
      if (inner->cls[k] != b.cls[k]) {
        found.push_back(std::move(*inner));
        return true;
      }
    (std::abs(p.argument[k]) < std::abs(q.argument[k]) ? high : low) =
        std::abs(p.argument[k]) < std::abs(q.argument[k]) ? q.t : p.t;
  }
  return false;
}

// Where the argument of switch k has an extreme near b without a zero: sin(t)^1e9 and exp(-1e9 (t^2 - t + 1/4)) are bumps there.
void GivenSignals::Scan::find_extreme(const Point& a, const Point& b, const Point& c, std::size_t k) {
  const double side = b.argument[k] > a.argument[k] ? 1.0 : -1.0;
  if (!(side * (b.argument[k] - a.argument[k]) > 0.0 && side * (b.argument[k] - c.argument[k]) >= 0.0)) return;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = a.t, high = c.t;
  for (int i = 0; i < kGolden; ++i) {
    const double p = high - golden * (high - low), q = low + golden * (high - low);
    const bool left = side * at(p).argument[k] > side * at(q).argument[k];
    (left ? high : low) = left ? q : p;
  }
  extremes.push_back(0.5 * (low + high));
}

// The grid of a block, with all changes of classes in it.
GivenSignals::Scan::Points GivenSignals::Scan::find_switches(double begin, double end) {
  Points points;
  const int cells = curved ? kCellsOfBlock : 1;
  for (int i = 0; i <= cells; ++i) points.push_back(at(i == cells ? end : begin + (end - begin) * i / cells));
  for (int round = 0; round < kRounds; ++round) {
    Points found;
    for (std::size_t i = 1; i < points.size() && found.size() <= kMostCorners; ++i)
      for (std::size_t k = 0; k < points[i].cls.size(); ++k) {
        if (points[i - 1].cls[k] != points[i].cls[k]) {
          bisect(points[i - 1], points[i], k, found);
        } else if (round < 2 && k < switches.size() && switches[k].smooth && i + 1 < points.size()) {
          if (!find_touch(points[i - 1], points[i], points[i + 1], k, found) && round == 0 &&
              extremes.size() < kMostExtremes)
            find_extreme(points[i - 1], points[i], points[i + 1], k);
        }
      }
    if (found.empty()) break;
    for (Point& point : found) points.push_back(std::move(point));
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.t < b.t; });
    points.erase(std::unique(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.t == b.t; }),
                 points.end());
  }
  return points;
}

std::vector<Corner> GivenSignals::Scan::corners_of(const Points& points) const {
  std::vector<Corner> all;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &a = points[i - 1], &b = points[i];
    if (a.cls != b.cls) all.push_back(neighbours(a.t, b.t) ? Corner(a.t, b.t) : Corner(b.t));
  }
  return all;
}

// Where values are curved: their turning points, and points between which lines represent them.
void GivenSignals::Scan::add_turns(const Points& points, double cell) {
  Points all = points;
  const std::size_t places_count = std::max<std::size_t>(corners.size() + extremes.size(), 1);
  const auto halvings = std::min<std::size_t>(kHalvings, 8 * kCellsOfBlock / places_count);
  std::vector<Corner> centres = corners;
  for (const double t : extremes) {
    centres.emplace_back(t);
    all.push_back(at(t));
  }
  for (const Corner& corner : centres)
    for (std::size_t i = 1; i <= halvings; ++i) {
      const double d = std::ldexp(cell, -static_cast<int>(i));
      if (corner.before - d > points.front().t) all.push_back(at(corner.before - d));
      if (corner.after + d < points.back().t) all.push_back(at(corner.after + d));
    }
  std::sort(all.begin(), all.end(), [](const Point& a, const Point& b) { return a.t < b.t; });
  all.erase(std::unique(all.begin(), all.end(), [](const Point& a, const Point& b) { return a.t == b.t; }), all.end());

  std::vector<Corner> jumps;
  for (const Corner& corner : corners)
    if (corner.before < corner.after) jumps.push_back(corner);
  bool varies = false;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!values[k].curved) continue;
    double largest = 0.0, least_value = kNoCorner, most_value = -kNoCorner;
    for (const Point& point : all) {
      if (std::isnan(point.value[k])) continue;
      largest = std::max(largest, std::abs(point.value[k]));
      least_value = std::min(least_value, point.value[k]);
      most_value = std::max(most_value, point.value[k]);
    }
    const double floor = kTiny + kNoWidth * largest;
    varies = varies || most_value - least_value > floor;
    // In parts between jumps and missing values.
    std::size_t begin = 0;
    auto jump = jumps.begin();
    for (std::size_t i = 0; i <= all.size(); ++i) {
      while (jump != jumps.end() && i < all.size() && jump->after < all[i].t) ++jump;
      const bool ends =
          i == all.size() || std::isnan(all[i].value[k]) || (jump != jumps.end() && jump->after == all[i].t);
      if (!ends) continue;
      if (i > begin + 1) add_turns_of(k, all, begin, i, floor);
      begin = i < all.size() && std::isnan(all[i].value[k]) ? i + 1 : i;
    }
  }
  // So that a new state of the scene requires the scan of one block only.
  if (varies || !places.empty()) corners.emplace_back(points.back().t);
}

// In [begin, end): a turning point is an extreme from which the value departs by more than `floor` on both sides.
void GivenSignals::Scan::add_turns_of(std::size_t value, const Points& points, std::size_t begin, std::size_t end,
                                      double floor) {
  const auto f = [&](std::size_t i) { return points[i].value[value]; };
  std::size_t from = begin, turn = begin, turns = 0;
  double direction = 0.0;
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (direction == 0.0) {
      if (std::abs(f(i) - f(from)) > floor) {
        direction = f(i) > f(from) ? 1.0 : -1.0;
        turn = i;
      }
      continue;
    }
    if (direction * (f(i) - f(turn)) > 0.0) {
      turn = i;
    } else if (direction * (f(turn) - f(i)) > floor) {
      corners.emplace_back(points[turn].t);
      ++turns;
      add_bends(points, value, from, turn, floor);
      from = turn;
      turn = i;
      direction = -direction;
    }
  }
  add_bends(points, value, from, end - 1, floor);
  if (static_cast<double>(turns) > kDense * static_cast<double>(end - begin) && end - begin > kCellsOfBlock / 4)
    report_too_fast(values[value].owner);
}

void GivenSignals::Scan::report_too_fast(const std::string& owner) {
  if (std::find(too_fast.begin(), too_fast.end(), owner) == too_fast.end()) too_fast.push_back(owner);
}

// Points between which the value is within kBend of a line (Ramer 1972, Douglas and Peucker 1973).
void GivenSignals::Scan::add_bends(const Points& points, std::size_t value, std::size_t begin, std::size_t end,
                                   double floor) {
  if (end <= begin + 1) return;
  const double t0 = points[begin].t, f0 = points[begin].value[value], f1 = points[end].value[value];
  const double slope = (f1 - f0) / (points[end].t - t0);
  double lowest = std::min(f0, f1), highest = std::max(f0, f1), farthest = 0.0;
  std::size_t split = begin;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double f = points[i].value[value], distance = std::abs(f - f0 - slope * (points[i].t - t0));
    lowest = std::min(lowest, f);
    highest = std::max(highest, f);
    if (distance > farthest) {
      farthest = distance;
      split = i;
    }
  }
  if (highest - lowest <= floor || farthest <= kBend * (highest - lowest) || split == begin) return;
  corners.emplace_back(points[split].t);
  add_bends(points, value, begin, split, floor);
  add_bends(points, value, split, end, floor);
}

Corner GivenSignals::Scan::next(double t, const Eigen::VectorXd& values_now) {
  if (is_empty()) return {};
  inputs = &values_now;
  std::vector<double> now;
  for (const int place : places) now.push_back(values_now[place]);
  if (now != held) scanned = -1;
  if (scanned >= 0 && asked <= t && t < answer.after) return answer;
  held = std::move(now);
  const double length = block_length();
  answer = {};
  for (long block = static_cast<long>(t / length); static_cast<double>(block) * length < t_end; ++block) {
    if (block != scanned) scan_block(block);
    const auto found = std::find_if(corners.begin(), corners.end(), [&](const Corner& c) { return c.after > t; });
    if (found == corners.end()) continue;
    answer = *found;
    break;
  }
  asked = t;
  return answer;
}

void GivenSignals::Scan::scan_block(long block) {
  const double length = block_length(), begin = static_cast<double>(block) * length;
  const double end = static_cast<double>(block + 1) * length;
  extremes.clear();
  const Points points = find_switches(begin, end);
  corners = corners_of(points);
  if (curved) add_turns(points, length / kCellsOfBlock);
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return a.before != b.before ? a.before < b.before : a.after > b.after;
  });
  splits.clear();
  if (curved && !corners.empty()) add_splits(begin, end);
  scanned = block;
}

// Per value, of one step from a to b: Radau IIA of three stages [Hairer, Wanner 1996, IV.5].
std::vector<double> GivenSignals::Scan::quadrature(double a, double b) {
  static const double root = std::sqrt(6.0);
  const double places_of[] = {(4.0 - root) / 10.0, (4.0 + root) / 10.0, 1.0};
  const double weights[] = {(16.0 - root) / 36.0, (16.0 + root) / 36.0, 1.0 / 9.0};
  std::vector<double> sums(values.size(), 0.0);
  for (int i = 0; i < 3; ++i) {
    const Point point = at(i == 2 ? b : a + places_of[i] * (b - a));
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += weights[i] * (b - a) * point.value[k];
  }
  return sums;
}

// A small error that hardly falls with the step is the round-off of the values.
void GivenSignals::Scan::split(double a, double b, const std::vector<double>& whole,
                               const std::vector<double>& errors_before, int halvings) {
  const double middle = a + 0.5 * (b - a);
  if (halvings >= kMostSplits || splits.size() >= kCellsOfBlock || !(a < middle && middle < b)) return;
  const std::vector<double> left = quadrature(a, middle), right = quadrature(middle, b);
  bool exact = true;
  std::vector<double> errors(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double error = errors[k] = std::abs(left[k] + right[k] - whole[k]);
    const bool rounded = error > kSlow * errors_before[k] && error < kRounded * integrals[k];
    exact = exact &&
            !(values[k].splits() && error > kQuadrature * integrals[k] && !rounded);  // also where there is no value
  }
  if (exact) return;
  split(a, middle, left, errors, halvings + 1);
  splits.push_back(middle);
  split(middle, b, right, errors, halvings + 1);
}

void GivenSignals::Scan::add_splits(double begin, double end) {
  if (std::none_of(values.begin(), values.end(), [](const Value& value) { return value.splits(); })) return;
  std::vector<std::pair<double, double>> spans;
  double from = begin;
  for (const Corner& corner : corners) {
    if (corner.before > from) spans.emplace_back(from, std::min(corner.before, end));
    from = std::max(from, corner.after);
  }
  if (from < end) spans.emplace_back(from, end);
  if (spans.size() > kCellsOfBlock / 8) return;  // the error test decides
  std::vector<std::vector<double>> wholes;
  std::vector<double> sums(values.size(), 0.0);
  for (const auto& [a, b] : spans) {
    wholes.push_back(quadrature(a, b));
    for (std::size_t k = 0; k < sums.size(); ++k)
      if (std::isfinite(wholes.back()[k])) sums[k] += std::abs(wholes.back()[k]);
  }
  integrals.resize(values.size(), 0.0);
  for (std::size_t k = 0; k < sums.size(); ++k) integrals[k] = std::max(integrals[k], sums[k]);
  const std::vector<double> unknown(values.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < spans.size(); ++i) split(spans[i].first, spans[i].second, wholes[i], unknown, 0);
}

GivenSignals::GivenSignals(const std::vector<GivenEntry>& entries,
                           const std::function<GivenSource(const std::string&)>& source, double t_end)
    : scan_(std::make_unique<Scan>(entries, source, t_end)) {}

GivenSignals::~GivenSignals() = default;
GivenSignals::GivenSignals(GivenSignals&&) noexcept = default;
GivenSignals& GivenSignals::operator=(GivenSignals&&) noexcept = default;

const std::vector<std::string>& GivenSignals::too_fast() const { return scan_->too_fast; }

Corner GivenSignals::next(double t, const Eigen::VectorXd& values) { return scan_->next(t, values); }

double GivenSignals::next_split(double t, const Eigen::VectorXd& values) {
  const Corner corner = scan_->next(t, values);
  const std::vector<double>& splits = scan_->splits;
  const auto found = std::upper_bound(splits.begin(), splits.end(), t);
  return found != splits.end() && *found < corner.before ? *found : kNoCorner;
}

}  // namespace footfall
