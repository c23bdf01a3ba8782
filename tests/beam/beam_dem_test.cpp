// Beams in runs of their own: what does not depend on segments, ranks, lists and restarts; momentum and
// energy.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "liggghts_fix/beam_hertz.h"
#include "mbd_solver/output/history.h"
#include "tests/beam/beam_run.h"
#include "tests/unit/liggghts_fix/random_beams.h"

namespace footfall::test {
namespace {

// Round-off of a few thousand steps, relative to the largest number of each column.
constexpr double kRoundOff = 1e-11;

const char* const kModel = "model hertz tangential history rolling_friction cdt";
const char* const kColumns =
    "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz f_history_w[1] f_history_w[2] f_history_w[3]";

std::string beam_wall(const std::string& body) {
  return std::string("fix w all wall/gran/beam ") + kModel + " type 2 body " + body + "\n";
}

std::string run(int steps, int every = 5) {
  return "fix integr all nve/sphere\nfix mbd all couple/mbd every " + std::to_string(every) + "\nrun " +
         std::to_string(steps) + "\n";
}

// Grains in rows above a beam along x, moving along it; they do not see each other, so that each has its own
// fate.
std::string cloud() {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::ostringstream text;
  int id = 0;
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 20; ++i) {
      ++id;
      text << "create_atoms 1 single " << -0.24 + 0.024 * i << " " << -0.03 + 0.06 * unit(engine) << " "
           << 0.045 + 0.02 * row << "\n";
      text << "group g id " << id << "\nset group g diameter " << 0.02 + 0.02 * unit(engine) << " density 2600\n";
      text << "velocity g set " << -0.8 + 1.6 * unit(engine) << " 0 " << -0.6 * unit(engine) << "\ngroup g delete\n";
    }
  text << "neigh_modify exclude type 1 1\n";
  return text.str();
}

// A beam that rises into the cloud, turns and sways.
std::string sweeping_beam() {
  std::vector<std::string> nodes;
  for (int i = 0; i <= 10; ++i) nodes.push_back(std::to_string(-0.25 + 0.05 * i) + " 0 0");
  return "end 0.1\nbody tine\n" + chain(nodes, 0.02) + "velocity 0 0 0.5\nspin 0.4 0.3 1.0\nsway 0 0.01 0.02 60\n";
}

std::string sweep(const std::string& settings, const Material& material = {}, const std::string& dt = "2e-5") {
  return settings + preamble("-0.6 0.6 -0.4 0.4 -0.3 0.6", material) + "timestep " + dt + "\npair_style gran " +
         kModel + "\npair_coeff * *\n" + cloud() + beam_wall("tine");
}

// How many grains of a dump have a tangential history.
int touching(const Rows& rows) {
  int count = 0;
  for (const auto& row : rows) count += row[16] != 0.0 || row[17] != 0.0 || row[18] != 0.0 ? 1 : 0;
  return count;
}

TEST(BeamHistory, DoesNotSeeTheJointsOfAStraightBeam) {
  const BeamRun folder("joints");
  const auto slide = [&folder](const std::vector<std::string>& nodes, const std::string& file) {
    return folder.coupled(
        preamble("-0.5 0.5 -0.5 0.5 -0.5 0.5") + "timestep 2e-5\npair_style gran " + kModel +
            "\npair_coeff * *\ncreate_atoms 1 single -0.2 0 0.0749\nset group all diameter 0.04 density "
            "2600\n" +
            "velocity all set 1.0 0.02 0\n" + beam_wall("tine") + "fix g all gravity 9.81 vector 0 0 -1\n" +
            dump_command(file, 20, kColumns) + run(18000, 50),
        "end 0.36\nbody tine\n" + chain(nodes, 0.055));
  };
  ASSERT_EQ(slide({"-0.4 0 0", "0.4 0 0"}, "one.txt").exit_code, 0);
  const Outcome many = slide({"-0.4 0 0", "-0.19 0 0", "-0.1 0 0", "-0.09 0 0", "0.03 0 0", "0.4 0 0"}, "many.txt");
  ASSERT_EQ(many.exit_code, 0) << many.text;
  const Dump expected = folder.dump("one.txt");
  EXPECT_LT(relative_difference(expected, folder.dump("many.txt")), kRoundOff);
  const std::vector<double>& end = expected.rbegin()->second.at(0);
  EXPECT_GT(end[1], 0.031);       // it went over all the joints
  EXPECT_EQ(touching({end}), 1);  // and is still in contact
}

TEST(BeamRuns, AreTheSameOnOneTwoAndThreeRanks) {
  const BeamRun folder("ranks");
  Dump one;
  Rows loads;
  for (int ranks = 1; ranks <= 3; ++ranks) {
    const std::string file = "ranks" + std::to_string(ranks) + ".txt";
    const Outcome outcome = folder.coupled(sweep("processors * 1 1\n") + dump_command(file, 20, kColumns) + run(5000),
                                           sweeping_beam(), ranks);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    const Dump dump = folder.dump(file);
    if (ranks == 1) {
      one = dump;
      loads = folder.loads();
      int contacts = 0, migrated = 0;
      for (const auto& [step, rows] : one) {
        contacts += touching(rows);
        for (std::size_t i = 0; i < rows.size(); ++i)
          migrated += touching({rows[i]}) == 1 && (rows[i][1] > 0.0) != (one.at(0)[i][1] > 0.0) ? 1 : 0;
      }
      EXPECT_GT(contacts, 500);
      EXPECT_GT(migrated, 10);  // grains in contact cross the border that two ranks have at x = 0
      continue;
    }
    // Every grain feels the beam alone: its motion and history agree to the last bit.
    EXPECT_EQ(relative_difference(one, dump), 0.0) << ranks << " ranks";
    // The loads are sums over ranks, in another order.
    const Rows others = folder.loads();
    ASSERT_EQ(others.size(), loads.size());
    std::vector<double> largest(loads[0].size(), 0.0);
    for (const auto& row : loads)
      for (std::size_t k = 0; k < row.size(); ++k) largest[k] = std::max(largest[k], std::abs(row[k]));
    for (std::size_t i = 0; i < loads.size(); ++i)
      for (std::size_t k = 0; k < loads[i].size(); ++k)
        ASSERT_NEAR(others[i][k], loads[i][k], 1e-13 * largest[k]) << "window " << i << " column " << k;
  }
}

// A beam that is nowhere near when the run begins, and comes turning and swaying, is noticed in time: as with
// a list made at every step.
TEST(BeamRuns, ABeamThatComesFromAfarIsNoticed) {
  const BeamRun folder("from_afar");
  const auto with = [&folder](const std::string& lists, const std::string& file) {
    std::string motion = sweeping_beam();
    motion.replace(motion.find("velocity 0 0 0.5"), 16, "at 0 0 -0.25\nvelocity 0 0 5");
    return folder.coupled(
        sweep("") + "velocity all set 0 0 0\n" + lists + dump_command(file, 100, kColumns) + run(5000), motion);
  };
  ASSERT_EQ(with("", "usual.txt").exit_code, 0);
  ASSERT_EQ(with("neigh_modify every 1 delay 0 check no\n", "always.txt").exit_code, 0);
  const Dump usual = folder.dump("usual.txt");
  EXPECT_EQ(relative_difference(usual, folder.dump("always.txt")), 0.0);
  EXPECT_EQ(touching(usual.begin()->second), 0);
  int contacts = 0;
  for (const auto& [step, rows] : usual) contacts += touching(rows);
  EXPECT_GT(contacts, 50);
}

// The same beam and grains, in the middle of a periodic box and across its border: the beam's own place is outside for
// one half of its grains.
TEST(BeamRuns, AreTheSameAcrossThePeriodicBorder) {
  const BeamRun folder("periodic");
  const auto loads = [&folder](const std::string& shift, int ranks) {
    std::string script = sweep("");
    script.replace(script.find("boundary f f f"), 14, "boundary p f f");
    script += "displace_atoms all move " + shift + " 0 0 units box\n";
    std::string motion = sweeping_beam();
    motion.replace(motion.find("velocity"), 0, "at " + shift + " 0 0\n");
    const Outcome outcome = folder.coupled(script + run(5000), motion, ranks);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    return folder.loads();
  };
  const Rows inside = loads("0.0", 1);
  double largest = 0.0, difference = 0.0;
  for (const int ranks : {1, 2}) {
    const Rows across = loads("0.55", ranks);
    ASSERT_EQ(across.size(), inside.size());
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (std::size_t k = 1; k <= 6; ++k) {  // force and moment about Bo
        largest = std::max(largest, std::abs(inside[i][k]));
        difference = std::max(difference, std::abs(across[i][k] - inside[i][k]));
      }
  }
  EXPECT_GT(largest, 1.0);
  // round-off of places in the box, which a contact's stiffness and the grains' way to the next one multiply
  EXPECT_LT(difference, 1e-7 * largest);
}

// Distance and direction from the closest point of a segment: the axis is cut into halves around the nearer
// part, without a projection.
Eigen::Vector3d from_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x) {
  double low = 0.0, high = 1.0;
  while (high - low > 1e-14) {  // the distance is convex along the segment: its slope tells the side
    const double mu = 0.5 * (low + high);
    (((1.0 - mu) * a + mu * b - x).dot(b - a) < 0.0 ? low : high) = mu;
  }
  return x - ((1.0 - low) * a + low * b);
}

// 1000 spheres at random places among 50 winding beams, turned and moved at random, all at rest: Hertz' force
// of every sphere with every beam, against a search through all segments. Every beam is a body of its own,
// all in one fix.
TEST(BeamRuns, ThousandSpheresAmongFiftyBeamsFeelTheForcesOfABruteForceSearch) {
  RandomBeams random(21);
  const int spheres = 1000, beams = 50;
  std::vector<Eigen::Vector3d> x;
  std::vector<double> r;
  std::ostringstream grains, motion;
  grains.precision(17);
  motion.precision(17);
  for (int i = 0; i < spheres; ++i) {
    x.push_back(random.vector(1.0));
    r.push_back(random.between(0.05, 0.15));
    grains << "create_atoms 1 single " << x.back().transpose() << "\nset atom " << i + 1 << " diameter "
           << 2.0 * r.back() << " density 2600\n";
  }
  motion << "end 1e-6\n";
  std::string bodies;
  struct Segment {
    Eigen::Vector3d a, b;
    double radius;
  };
  std::vector<std::vector<Segment>> chains(beams);
  for (int k = 0; k < beams; ++k) {
    const ModalBoundary beam = random_chain(random, 1 + k % 6);
    const Eigen::Vector3d turned = random.vector(1.5);
    motion << "body beam" << k << "\n";
    for (Eigen::Index j = 0; j < beam.rho0().cols(); ++j) motion << "node " << beam.rho0().col(j).transpose() << "\n";
    const Eigen::AngleAxisd turn(turned.norm(), turned.normalized());
    const Eigen::Vector3d middle = beam.rho0().rowwise().mean();
    const Eigen::Vector3d at = random.vector(0.5) - turn * middle;
    for (const BeamSegment& s : beam.segments()) {
      motion << "segment " << s.start << " " << s.end << " " << s.radius << " 0\n";
      chains[static_cast<std::size_t>(k)].push_back(
          {at + turn * beam.rho0().col(s.start), at + turn * beam.rho0().col(s.end), s.radius});
    }
    motion << "at " << at.transpose() << "\nturned " << turned.transpose() << "\n";
    bodies += " body beam" + std::to_string(k);
  }

  // Hertz' force of a flat wall [N]; both sides have E = 35 MPa and nu = 0.25.
  const double E = 35e6 / (2.0 * (1.0 - 0.25 * 0.25));
  std::vector<Eigen::Vector3d> on_sphere(spheres, Eigen::Vector3d::Zero()), on_beam(beams, Eigen::Vector3d::Zero());
  std::vector<int> count(beams, 0);
  int contacts = 0;
  double largest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < chains.size(); ++k) {
      double overlap = -1.0;
      Eigen::Vector3d away = Eigen::Vector3d::Zero();
      for (const Segment& s : chains[k]) {
        const Eigen::Vector3d d = from_segment(s.a, s.b, x[i]);
        if (r[i] + s.radius - d.norm() > overlap) {
          overlap = r[i] + s.radius - d.norm();
          away = d.normalized();
        }
      }
      if (overlap < 0.0) continue;
      const Eigen::Vector3d f = 4.0 / 3.0 * E * std::sqrt(r[i]) * std::pow(overlap, 1.5) * away;
      on_sphere[i] += f;
      on_beam[k] -= f;
      largest = std::max(largest, f.norm());
      ++count[k];
      ++contacts;
    }
  ASSERT_GT(contacts, 500);

  const BeamRun folder("random");
  const std::string model = "model hertz tangential no_history";
  for (int ranks = 1; ranks <= 3; ++ranks) {
    const Outcome outcome =
        folder.coupled("processors * 1 1\n" + preamble("-4 4 -4 4 -4 4") + "timestep 1e-6\npair_style gran " + model +
                           "\npair_coeff * *\n" + grains.str() +
                           "neigh_modify exclude type 1 1\nfix w all wall/gran/beam " + model + " type 2" + bodies +
                           "\n" + dump_command("forces.txt", 1, "fx fy fz") + "fix mbd all couple/mbd every 1\nrun 1\n",
                       motion.str(), ranks);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    // Sums of a few dozen forces, directions to a round-off of 1e-15 over overlaps down to some micrometres.
    const double tolerance = 1e-11 * largest;
    const Rows forces = folder.dump("forces.txt").at(1);
    ASSERT_EQ(forces.size(), x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      ASSERT_LT((Eigen::Vector3d(forces[i][1], forces[i][2], forces[i][3]) - on_sphere[i]).norm(), tolerance)
          << "sphere " << i << " on " << ranks << " ranks, seed " << random.seed();
    const Rows loads = folder.loads();  // window, force, moment, modal force, work, contacts
    ASSERT_EQ(loads.size(), chains.size());
    for (std::size_t k = 0; k < chains.size(); ++k) {
      ASSERT_LT((Eigen::Vector3d(loads[k][1], loads[k][2], loads[k][3]) - on_beam[k]).norm(), 30 * tolerance)
          << "beam " << k << " on " << ranks << " ranks";
      ASSERT_EQ(loads[k][9], count[k]);
    }
  }
}

// A list made at every step, one that lives long, and the usual one find the same contacts while beam and
// grains move.
TEST(BeamRuns, DoNotDependOnWhenListsAreMade) {
  const BeamRun folder("lists");
  const auto with = [&folder](const std::string& lists, const std::string& file) {
    return folder.coupled(sweep("") + lists + dump_command(file, 100, kColumns) + run(5000), sweeping_beam());
  };
  ASSERT_EQ(with("", "usual.txt").exit_code, 0);
  ASSERT_EQ(with("neigh_modify every 1 delay 0 check no\n", "always.txt").exit_code, 0);
  ASSERT_EQ(with("neighbor 0.08 bin\n", "rarely.txt").exit_code, 0);
  ASSERT_EQ(with("neighbor 0.0005 bin\n", "often.txt").exit_code, 0);
  const Dump usual = folder.dump("usual.txt");
  EXPECT_EQ(relative_difference(usual, folder.dump("always.txt")), 0.0);
  EXPECT_EQ(relative_difference(usual, folder.dump("rarely.txt")), 0.0);
  EXPECT_EQ(relative_difference(usual, folder.dump("often.txt")), 0.0);
}

// A run that is stopped in the middle of contacts and goes on from its restart file ends with the same bits;
// without the histories it would not. Two grains slide along the groove between the two beams of one fix; one
// of them passes from rank to rank after the restart.
TEST(BeamHistory, SurvivesARestart) {
  const BeamRun folder("restart");
  const std::string body = "body groove\n" + chain({"-0.4 -0.04 0", "-0.05 -0.04 0", "0.4 -0.04 0"}, 0.055) +
                           chain({"-0.4 0.04 0", "0.01 0.04 0", "0.4 0.04 0"}, 0.055, 3, 1);
  const auto wall = [](const std::string& id) {
    return "fix " + id + " all wall/gran/beam " + kModel + " type 2 body groove\n" +
           "fix g all gravity 9.81 vector 0 0 -1\n";
  };
  const auto columns = [](const std::string& id) {
    std::string text = "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz";
    for (const std::string& beam : {id, id + "_2"})
      for (const char* c : {"[1]", "[2]", "[3]"}) text += " f_history_" + beam + c;
    return text;
  };
  for (const int ranks : {1, 2}) {
    const Outcome whole = folder.coupled(
        "processors * 1 1\n" + preamble("-0.5 0.5 -0.5 0.5 -0.5 0.5") + "timestep 2e-5\npair_style gran " + kModel +
            "\npair_coeff * *\ncreate_atoms 1 single -0.055 0 0.063432\ncreate_atoms 1 single 0.1 0 "
            "0.063432\nset group all diameter 0.04 density 2600\nvelocity all set 1.0 0.002 0\n" +
            wall("w") + dump_command("whole.txt", 2000, columns("w")) + run(2000) +
            "write_restart half.restart\nrun 2000\n",
        "end 0.08\n" + body, ranks);
    ASSERT_EQ(whole.exit_code, 0) << whole.text;
    const auto resume = [&](const std::string& id, const std::string& file) {
      return folder.coupled(
          "atom_modify map array\nunits si\nnewton off\nprocessors * 1 1\nread_restart half.restart\n"
          "communicate single vel yes\nneighbor 0.01 bin\nneigh_modify delay 0\n" +
              materials() + "timestep 2e-5\npair_style gran " + kModel + "\npair_coeff * *\n" + wall(id) +
              dump_command(file, 2000, columns(id)) + run(2000, 50),
          "start 0.04\nend 0.08\n" + body, ranks);
    };
    const Outcome resumed = resume("w", "resumed.txt");
    ASSERT_EQ(resumed.exit_code, 0) << resumed.text;
    ASSERT_EQ(resume("other", "without_history.txt").exit_code, 0);
    const Dump expected = folder.dump("whole.txt");
    for (const auto& row : expected.at(2000))
      for (std::size_t k = 16; k < 22; ++k) EXPECT_NE(row[k], 0.0);  // both grains touch both beams
    EXPECT_LT(expected.at(2000)[0][1], 0.0);
    EXPECT_GT(expected.at(4000)[0][1], 0.0);  // came to the other rank
    // Not at step 2000: the set-up of a run evaluates friction once more without moving its springs, and a
    // dump then shows that.
    const auto end_of = [](const Dump& dump) { return Dump{{4000, dump.at(4000)}}; };
    EXPECT_EQ(relative_difference(end_of(expected), end_of(folder.dump("resumed.txt"))), 0.0) << ranks << " ranks";
    EXPECT_GT(relative_difference(end_of(expected), end_of(folder.dump("without_history.txt"))), 1e-6);
  }
}

// m and moment of momentum about the origin of W, orbit and spin.
struct Momentum {
  double linear[3] = {0, 0, 0}, angular[3] = {0, 0, 0}, energy = 0.0;
};

// Rows: id mass radius x y z vx vy vz omegax omegay omegaz.
Momentum momentum(const Rows& rows) {
  Momentum sum;
  for (const auto& g : rows) {
    const double m = g[1], inertia = 0.4 * m * g[2] * g[2];
    const double* x = &g[3];
    const double* v = &g[6];
    const double* w = &g[9];
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      sum.linear[c] += m * v[c];
      sum.angular[c] += m * (x[d] * v[e] - x[e] * v[d]) + inertia * w[c];
      sum.energy += 0.5 * (m * v[c] * v[c] + inertia * w[c] * w[c]);
    }
  }
  return sum;
}

const char* const kMomentumColumns = "mass radius x y z vx vy vz omegax omegay omegaz";

// What the grains lose the beam gets, in every step: momentum and moment of momentum, with friction and
// rolling friction, while the beam moves, turns and sways. The beam starts and ends clear of all grains.
class BeamMomentum : public testing::TestWithParam<int> {};

TEST_P(BeamMomentum, IsGivenAsItIsReceived) {
  const int ranks = GetParam();
  const BeamRun folder("momentum" + std::to_string(ranks));
  // Of the one beam, its moment about the body's origin; and of all beams, about the origin of W. Every such
  // number of every step is a sum over the ranks: two and three of them check the windows only.
  std::string print, line = "${n}";
  for (int k = 1; k <= 14; ++k) {
    const std::string name = "v" + std::to_string(k);
    print +=
        "variable " + name + " equal f_w" + (k <= 7 ? "[1][" + std::to_string(k) : "[" + std::to_string(k - 7)) + "]\n";
    line += " ${" + name + "}";
  }
  print += "variable n equal step\nfix out all print 1 \"" + line + "\" file beam.txt screen no\n";
  const Outcome outcome =
      folder.coupled(sweep("processors * 1 1\n") + dump_command("grains.txt", 6000, kMomentumColumns) +
                         (ranks == 1 ? print : "") + "thermo_modify lost ignore\n" + run(6000),
                     "end 0.12\n" + sweeping_beam().substr(sweeping_beam().find("body")), ranks);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Dump grains = folder.dump("grains.txt");
  const Momentum before = momentum(grains.begin()->second), after = momentum(grains.rbegin()->second);
  ASSERT_EQ(grains.rbegin()->second.size(), 80u);

  const double dt = 2e-5;
  // What the other program is told, window by window.
  double told[3] = {0, 0, 0}, size = 0.0;
  for (const auto& window : folder.loads())
    for (std::size_t c = 0; c < 3; ++c) {
      told[c] += 5 * dt * window[1 + c];
      size += 5 * dt * std::abs(window[1 + c]);
    }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(after.linear[c] - before.linear[c], -told[c], 1e-12 * size);
  if (ranks > 1) return;

  const double velocity[3] = {0.0, 0.0, 0.5};  // of the beam's origin
  double impulse[3] = {0, 0, 0}, turn[3] = {0, 0, 0}, contacts = 0.0, turn_size = 0.0;
  const Rows steps = folder.table("beam.txt");
  ASSERT_EQ(steps.size(), 6000u);
  for (const auto& s : steps) {
    double r[3];
    for (int c = 0; c < 3; ++c) r[c] = velocity[c] * s[0] * dt;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      impulse[c] += dt * s[static_cast<std::size_t>(1 + c)];
      ASSERT_EQ(s[static_cast<std::size_t>(8 + c)], s[static_cast<std::size_t>(1 + c)]);
      const double moment = s[static_cast<std::size_t>(4 + c)] + r[d] * s[static_cast<std::size_t>(1 + e)] -
                            r[e] * s[static_cast<std::size_t>(1 + d)];
      turn[c] += dt * moment;
      // Moments here are below 10 N m; `print` writes 15 digits.
      ASSERT_NEAR(s[static_cast<std::size_t>(11 + c)], moment, 1e-12);
      turn_size += dt * std::abs(moment);
    }
    contacts += s[7];
    ASSERT_EQ(s[14], s[7]);
  }
  EXPECT_EQ(steps.back()[7], 0.0);  // clear of all grains
  EXPECT_GT(contacts, 1000);
  for (int c = 0; c < 3; ++c) {
    // `print` writes 15 digits of 6000 numbers.
    EXPECT_NEAR(after.linear[c] - before.linear[c], -impulse[c], 1e-12 * size);
    EXPECT_NEAR(after.angular[c] - before.angular[c], -turn[c], 1e-12 * turn_size);
  }
}

INSTANTIATE_TEST_SUITE_P(Ranks, BeamMomentum, testing::Values(1, 2, 3));

// A free rod on the multibody side, falling upon free grains without gravity: what one program's bodies lose,
// the other's grains get, and the two together keep their momentum.
TEST(BeamMomentumOfBothPrograms, OfARodAndTheGrainsItStrikesIsKept) {
  const BeamRun folder("rod_and_grains");
  const std::string scene = R"(title = "a rod among grains"
end_time = 0.06
gravity = [0, 0, 0]
materials.steel = { density = 7850, young = 2e11, poisson = 0.3 }
[[bodies]]
name = "rod"
material = "steel"
shape = { kind = "rod", from = [-0.25, 0, 0], to = [0.25, 0, 0], diameter = 0.04 }
[[boundaries]]
body = "rod"
beams = { segments = 5 }
[initial]
velocity = [0.1, 0.0, 0.8]
[ground]
kind = "particles"
[particles]
script = "in.coupled"
ranks = 1
[output]
interval = 1e-3
plots = false
)";
  std::string script = sweep("") + "set group all density 26000\n" + dump_command("grains.txt", 3000, kMomentumColumns);
  script.replace(script.find("body tine"), 9, "body rod");
  const Outcome outcome = folder.scene(script + run(3000), scene);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const Dump grains = folder.dump("grains.txt");
  const Momentum before = momentum(grains.begin()->second), after = momentum(grains.rbegin()->second);
  const History history = read_history(folder.file("out/history.csv"));
  const double mass = 7850.0 * M_PI * 0.02 * 0.02 * 0.5;
  const char* const axis[3] = {"rod.vx", "rod.vy", "rod.vz"};
  for (int c = 0; c < 3; ++c) {
    const std::vector<double>& v = history.column(axis[c]);
    EXPECT_NEAR(mass * (v.back() - v.front()), before.linear[c] - after.linear[c], 1e-10 * mass * 0.8) << axis[c];
  }
  EXPECT_LT(history.column("rod.vz").back(), 0.7);  // it lost much of its own
}

// Elastic grains without friction: what they gain is the work of the beam, up to the error of the time steps,
// which is of second order. The windows are equally long, so that the beam moves in the same way.
class BeamEnergy : public testing::TestWithParam<bool> {};  // curvature
INSTANTIATE_TEST_SUITE_P(Curvature, BeamEnergy, testing::Bool());

TEST_P(BeamEnergy, OfElasticGrainsIsTheWorkOfTheBeamToSecondOrder) {
  const std::string curvature = GetParam() ? "yes" : "no";
  const BeamRun folder("energy_" + curvature);
  const Material elastic{1.0, 0.0, 0.0};
  double error[3];
  const char* const dt[3] = {"1.6e-4", "8e-5", "4e-5"};
  for (int k = 0; k < 3; ++k) {
    const int n = 5 << k, steps = 750 << k;
    const std::string file = std::string("grains") + dt[k] + ".txt";
    std::string script = sweep("", elastic, dt[k]);
    script.insert(script.find(" body tine"), " curvature " + curvature);
    const Outcome outcome = folder.coupled(script + dump_command(file, steps, kMomentumColumns) + run(steps, n),
                                           "end 0.12\n" + sweeping_beam().substr(sweeping_beam().find("body")));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
    const Dump grains = folder.dump(file);
    const double gain = momentum(grains.rbegin()->second).energy - momentum(grains.begin()->second).energy;
    double work = 0.0;  // of the grains on the beam
    for (const auto& row : folder.loads()) work += row[8];
    EXPECT_EQ(folder.loads().back()[9], 0.0);  // clear of all grains: no energy is left in contacts
    EXPECT_GT(gain, 0.1);
    error[k] = std::abs(gain + work) / gain;
  }
  EXPECT_LT(error[0], 1e-4);
  // Two halvings: 16 times less, and half of that is asked for, as contacts open and close between the steps.
  EXPECT_LT(error[2], error[0] / 8.0);
}

// A grain that is held in a beam of its own radius, at the side and at the end: the force of Hertz' cylinder and sphere.
TEST(BeamCurvature, MakesTheContactAsSoftAsHertzSays) {
  constexpr double kRadius = 0.02, kOverlap = 2e-4;  // [m]
  const auto force = [&](const std::string& name, const std::string& place, const std::string& words) {
    const BeamRun folder("curvature_" + name + words);
    const std::string script = preamble("-0.6 0.6 -0.4 0.4 -0.3 0.6") + "timestep 1e-6\npair_style gran " + kModel +
                               "\npair_coeff * *\ncreate_atoms 1 single " + place +
                               "\nset group all diameter 0.04 density 2600\nfix w all wall/gran/beam " + kModel +
                               " type 2 body tine curvature " + words + "\nfix mbd all couple/mbd every 2\nrun 2\n";
    const Outcome outcome =
        folder.coupled(script, "end 2e-6\nbody tine\n" + chain({"-0.1 0 0", "0 0 0", "0.1 0 0"}, kRadius));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
    const std::vector<double> row = folder.loads().front();
    return Eigen::Vector3d(row[1], row[2], row[3]).norm();
  };
  const std::string side = "0.03 0 " + std::to_string(2 * kRadius - kOverlap);
  const std::string end = std::to_string(0.1 + 2 * kRadius - kOverlap) + " 0 0";
  const double flat = force("side", side, "no");
  EXPECT_GT(flat, 1.0);
  EXPECT_NEAR(force("end", end, "no"), flat, 1e-9 * flat);
  EXPECT_NEAR(force("side", side, "yes") / flat, hertz_on_side(kRadius, kRadius), 1e-9);  // round-off of the overlap
  EXPECT_NEAR(force("end", end, "yes") / flat, std::sqrt(0.5), 1e-9);
}

}  // namespace
}  // namespace footfall::test
