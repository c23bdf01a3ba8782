// Beams among grains: stock cylinders, brute force, ranks, momentum, energy.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <random>
#include <sstream>

#include "liggghts_fix/link/beam_chain.h"
#include "mbd_solver/session/output/history.h"
#include "tests/coupled/coupled_run.h"
#include "tests/coupled/tube.h"
#include "tests/unit/liggghts_fix/random_beams.h"

namespace footfall::test {
namespace beams {

// Beams in runs of their own: what does not depend on segments, ranks, lists and restarts; momentum and
// energy.

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

std::string sweep(const std::string& settings, const ContactMaterial& material = {}, const std::string& dt = "2e-5") {
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

// A list made at every step, a long-lived one, and the usual one find the same contacts while beam and
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

// A run that is stopped in the middle of contacts and continues from its restart file ends with the same bits;
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

// Elastic grains without friction: what they gain is the work of the beam, up to the error of the time steps,
// which is of second order. The windows are equally long, so that the beam moves in the same way.
class BeamEnergy : public testing::TestWithParam<bool> {};  // curvature
INSTANTIATE_TEST_SUITE_P(Curvature, BeamEnergy, testing::Bool());

TEST_P(BeamEnergy, OfElasticGrainsIsTheWorkOfTheBeamToSecondOrder) {
  const std::string curvature = GetParam() ? "yes" : "no";
  const BeamRun folder("energy_" + curvature);
  const ContactMaterial elastic{1.0, 0.0, 0.0};
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

// A straight beam at rest, or sliding along itself, is a cylinder that stock LIGGGHTS has: the same forces,
// history and motion of the grains.

struct Case {
  std::string name;
  std::string model;                 // of pairs and walls
  std::vector<std::string> columns;  // dumped besides motion, force and torque: history and what keywords store
  std::string axis;                  // x, y or z
  double sliding = 0.0;              // of the cylinder along its axis [m/s]
  std::string keywords = {};         // of the wall
  std::string constants = {};        // of the model, besides the constants of all
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

std::vector<std::string> history(int count) {
  std::vector<std::string> columns;
  for (int i = 1; i <= count; ++i) columns.push_back("f_history_w[" + std::to_string(i) + "]");
  return columns;
}

// Grains thrown and pressed (3 N) on a cylinder of 0.055 m from all sides: they hit, slide, roll and fly off,
// past the joints of the beam.
std::string grains(const Case& c) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * M_PI * i / 8.0, along = -0.18 + 0.045 * i;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const auto turned_to_axis = [&c](double a, double b, double d) {
      const std::string u = std::to_string(a), v = std::to_string(b), w = std::to_string(d);
      return c.axis == "x" ? u + " " + v + " " + w : c.axis == "y" ? w + " " + u + " " + v : v + " " + w + " " + u;
    };
    const std::string id = std::to_string(i + 1), group = "g" + id;
    text += "create_atoms 1 single " + turned_to_axis(along, 0.078 * cosine, 0.078 * sine) + "\n";
    text += "group " + group + " id " + id + "\n";
    text += "set group " + group + " diameter 0.04 density 2600\n";
    text += "velocity " + group + " set " +
            turned_to_axis(i % 2 == 0 ? 0.6 : -0.5, -0.3 * cosine - 0.4 * sine, -0.3 * sine + 0.4 * cosine) + "\n";
    text += "fix press" + id + " " + group + " addforce " + turned_to_axis(0.0, -3.0 * cosine, -3.0 * sine) + "\n";
  }
  return text;
}

std::string script(const Case& c, const std::string& wall, const std::string& file) {
  std::string columns = "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz";
  for (const std::string& column : c.columns) columns += " " + column;
  return preamble("-0.5 0.5 -0.5 0.5 -0.5 0.5") + c.constants + "timestep 2e-5\npair_style gran " + c.model +
         "\npair_coeff * *\n" +
         "fix c1 all property/global thermalConductivity peratomtype 5 5\n"
         "fix c2 all property/global thermalCapacity peratomtype 20 20\n"
         "fix heat all heat/gran/conduction initial_temperature 300\n" +
         grains(c) + "fix w all wall/gran" + wall + "\nfix integr all nve/sphere\n" +
         "fix g all gravity 9.81 vector 0.1 -0.2 -1\n" + dump_command(file, 50, columns);
}

// Constants of contact models: one value for all pairs of types, for each type, or for all.
std::string of_pairs(const std::string& name, const std::string& value) {
  return "fix c_" + name + " all property/global " + name + " peratomtypepair 2 " + value + " " + value + " " + value +
         " " + value + "\n";
}
std::string of_types(const std::string& name, const std::string& value) {
  return "fix c_" + name + " all property/global " + name + " peratomtype " + value + " " + value + "\n";
}
std::string of_all(const std::string& name, const std::string& value) {
  return "fix c_" + name + " all property/global " + name + " scalar " + value + "\n";
}

// Springs and dashpots of the stiffness variants; k in N/m, or N/m^2 for Hertz.
std::string springs(const std::string& k, const std::string& gamma) {
  return of_pairs("kn", k) + of_pairs("kt", k) + of_pairs("gamman", gamma) + of_pairs("gammat", gamma);
}

const std::string kPlastic =
    of_pairs("coefficientAdhesionStiffness", "0.2") + of_pairs("coefficientPlasticityDepth", "0.05");
const std::string kLuding = kPlastic + of_pairs("LoadingStiffness", "2e5") + of_pairs("UnloadingStiffness", "1.5") +
                            of_pairs("pullOffForce", "0.1");
const std::string kEdinburgh = of_pairs("coefficientAdhesionStiffness", "0.2") + of_pairs("UnloadingStiffness", "2") +
                               of_all("adhesionExponent", "1.5") + of_all("overlapExponent", "1.5") +
                               of_pairs("pullOffForce", "-0.1") + of_pairs("surfaceEnergy", "1");
const std::string kWet = of_all("surfaceLiquidContentInitial", "0.01") + of_all("surfaceTension", "0.073") +
                         of_all("fluidViscosity", "0.001") + of_types("contactAngle", "0.5") +
                         of_all("minSeparationDistanceRatio", "1.01") + of_all("maxSeparationDistanceRatio", "1.1");

class BeamLikeCylinder : public testing::TestWithParam<Case> {};

TEST_P(BeamLikeCylinder, SameForcesHistoryAndMotionToRoundOff) {
  const Case& c = GetParam();
  const BeamRun folder("cylinder_" + c.name);
  std::string wall = " " + c.model + " primitive type 2 " + c.axis + "cylinder 0.055 0 0";
  if (c.sliding != 0.0) wall += " shear " + c.axis + " " + std::to_string(c.sliding);
  const Outcome stock = folder.stock(script(c, wall + c.keywords, "stock.txt") + "run 3000\n");
  ASSERT_EQ(stock.exit_code, 0) << stock.text;

  const auto on_axis = [&c](const std::string& s) {
    return c.axis == "x" ? s + " 0 0" : c.axis == "y" ? "0 " + s + " 0" : "0 0 " + s;
  };
  std::vector<std::string> nodes;
  for (const char* station : {"-0.4", "-0.11", "0.0", "0.033", "0.4"}) nodes.push_back(on_axis(station));
  const std::string motion =
      "end 0.06\nbody tine\n" + chain(nodes, 0.055) + "velocity " + on_axis(std::to_string(c.sliding)) + "\n";
  const Outcome beam = folder.coupled(script(c, "/beam " + c.model + " type 2 body tine" + c.keywords, "beam.txt") +
                                          "fix mbd all couple/mbd every 5\nrun 3000\n",
                                      motion);
  ASSERT_EQ(beam.exit_code, 0) << beam.text;

  const Dump expected = folder.dump("stock.txt");
  ASSERT_EQ(expected.size(), 61u);
  EXPECT_LT(relative_difference(expected, folder.dump("beam.txt")), kRoundOff);
  int touching = 0;  // friction turns a grain that touches
  for (const auto& [step, rows] : expected)
    for (const auto& row : rows) touching += row[13] != 0.0 || row[14] != 0.0 || row[15] != 0.0 ? 1 : 0;
  EXPECT_GT(touching, 50);
}

INSTANTIATE_TEST_SUITE_P(
    Models, BeamLikeCylinder,
    testing::Values(
        Case{"hertz", kModel, history(3), "x"},  //
        Case{"hertz_y", kModel, history(3), "y"}, Case{"hertz_z", kModel, history(3), "z"},
        Case{"sliding", kModel, history(3), "x", 0.7},
        Case{"hooke", "model hooke tangential history rolling_friction epsd2", history(6), "z"},
        Case{"cohesion", "model hertz tangential history cohesion sjkr rolling_friction cdt", history(3), "x"},
        Case{"no_history", "model hertz tangential no_history", {}, "x"},
        Case{"stored_force", kModel, {"f_force_w[1]", "f_force_w[2]", "f_force_w[3]"}, "x", 0.0, " store_force yes"},
        Case{"warm", kModel, {"f_Temp", "f_heatFlux"}, "x", 0.0, " temperature 600"}),
    [](const auto& model) { return model.param.name; });

// Every normal, tangential, rolling friction and cohesion model that stock walls take.
INSTANTIATE_TEST_SUITE_P(
    EveryModel, BeamLikeCylinder,
    testing::Values(Case{"hertz_stiffness", "model hertz/stiffness tangential history", history(3), "x", 0, "",
                         springs("2e7", "3e5")},
                    Case{"hooke_stiffness", "model hooke/stiffness tangential history", history(3), "y", 0, "",
                         springs("1e5", "500")},
                    Case{"hooke_hysteresis", "model hooke/hysteresis tangential history", history(4), "z", 0, "",
                         kPlastic + of_pairs("coefficientMaxElasticStiffness", "1.5")},
                    Case{"luding", "model luding tangential no_history", history(3), "x", 0, "", kLuding},
                    Case{"edinburgh", "model edinburgh tangential no_history", history(4), "x", 0, "", kEdinburgh},
                    Case{"edinburgh_stiffness", "model edinburgh/stiffness tangential no_history", history(4), "x", 0,
                         "", kEdinburgh + of_pairs("LoadingStiffness", "2e5")},
                    Case{"thornton_ning", "model thornton_ning tangential history", history(3), "y", 0, "",
                         of_pairs("surfaceEnergy", "20") + of_types("coefficientYieldRatio", "0.3")},
                    Case{"tan_luding", "model hooke tangential tan_luding", history(3), "x", 0, "",
                         of_pairs("coeffFrictionStiffness", "0.5") + of_pairs("FrictionViscosity", "0.1") +
                             of_pairs("FluidViscosity", "0.1")},
                    Case{"epsd", "model hertz tangential history rolling_friction epsd", history(6), "x"},
                    Case{"epsd3", "model hooke tangential history rolling_friction epsd3", history(6), "x", 0, "",
                         of_all("rollingStiffness", "100")},
                    Case{"roll_luding", "model hooke tangential history rolling_friction luding", history(6), "x", 0,
                         "", of_pairs("coeffRollingStiffness", "0.2")},
                    Case{"sjkr2", "model hertz tangential history cohesion sjkr2", history(3), "z"},
                    Case{"washino", "model hertz tangential history cohesion washino/capillary/viscous", history(4),
                         "x", 0, "", kWet},
                    Case{"easo", "model hertz tangential history cohesion easo/capillary/viscous", history(4), "x", 0,
                         "", kWet}),
    [](const auto& model) { return model.param.name; });

// Two beams are two contacts: a grain falls between two cylinders and stays there, as between two of stock
// LIGGGHTS'.
TEST(TwoBeams, HoldAGrainBetweenThemLikeTwoCylinders) {
  const BeamRun folder("two_beams");
  const auto fall = [](const std::string& walls, const std::string& file) {
    return preamble("-0.5 0.5 -0.5 0.5 -0.5 0.5") + "timestep 2e-5\npair_style gran " + kModel + "\npair_coeff * *\n" +
           "create_atoms 1 single 0.004 0.1 0.06\nset group all diameter 0.08 density 2600\nvelocity all set "
           "0.02 0.15 -0.1\n" +
           walls + "fix integr all nve/sphere\nfix g all gravity 9.81 vector 0 0 -1\n" +
           dump_command(file, 50,
                        "x y z vx vy vz omegax omegay omegaz fx fy fz f_history_w1[1] f_history_w1[2] "
                        "f_history_w2[1] f_history_w2[2]");
  };
  const std::string wall = std::string(" all wall/gran ") + kModel + " primitive type 2 ycylinder ";
  const Outcome stock = folder.stock(
      fall("fix w1" + wall + "0.03 0 -0.05\nfix w2" + wall + "0.02 0 0.045\n", "stock.txt") + "run 10000\n");
  ASSERT_EQ(stock.exit_code, 0) << stock.text;
  const std::string beam = std::string(" all wall/gran/beam ") + kModel + " type 2 body fork";
  const std::string fork = "end 0.2\nbody fork\n" + chain({"-0.05 -0.4 0", "-0.05 0.1 0", "-0.05 0.4 0"}, 0.03) +
                           chain({"0.045 -0.4 0", "0.045 0.12 0", "0.045 0.4 0"}, 0.02, 3, 7);
  const std::string run = "fix mbd all couple/mbd every 10\nrun 10000\n";
  const Outcome coupled =
      folder.coupled(fall("fix w1" + beam + " chain 0\nfix w2" + beam + " chain 7\n", "beam.txt") + run, fork);
  ASSERT_EQ(coupled.exit_code, 0) << coupled.text;
  const Dump expected = folder.dump("stock.txt");
  EXPECT_LT(relative_difference(expected, folder.dump("beam.txt")), kRoundOff);

  // One fix for both: the same contacts, and its second history has a name of its own.
  std::string script = fall("fix w1" + beam + "\n", "one_fix.txt") + run;
  for (std::size_t at; (at = script.find("history_w2[")) != std::string::npos;) script.replace(at, 11, "history_w1_2[");
  const Outcome one_fix = folder.coupled(script, fork);
  ASSERT_EQ(one_fix.exit_code, 0) << one_fix.text;
  EXPECT_EQ(relative_difference(folder.dump("beam.txt"), folder.dump("one_fix.txt")), 0.0);
  const std::vector<double>& end = expected.rbegin()->second.at(0);
  EXPECT_NE(end[13], 0.0);  // touches both
  EXPECT_NE(end[15], 0.0);
}

// A bent beam against the same tube as a triangle mesh of stock LIGGGHTS.

// Grains pressed into the tube near the middles of its segments, on 12 lines around it, and held there.
std::string held_grains(const BentTube& tube, double r, double overlap) {
  std::ostringstream text;
  text.precision(17);
  int id = 0;
  for (int s = 0; s < tube.segments; ++s)
    for (int k = 0; k < 12; ++k) {
      const Eigen::Vector3d x = tube.beside(s, 0.4 + 0.02 * k, 2.0 * M_PI * k / 12.0, tube.radius + r - overlap);
      text << "create_atoms 1 single " << x.transpose() << "\ngroup g id " << ++id << "\nset group g diameter "
           << 2.0 * r << " density 2600\ngroup g delete\n";
    }
  text << "neigh_modify exclude type 1 1\n";
  return text.str();
}

// A stock mesh adds up all facets that a grain overlaps: finer than the patch of the contact it gives too
// much force (a factor of 2 where the facets are half as wide as the patch). The comparison is fair where a
// grain touches one facet: facets no narrower than the patch, 2 sqrt(2 r overlap), and grains over the
// middles of facets. What is left is the facet's distance from the tube, R (1 - cos(pi / n)), which lowers
// the overlap: second order in the width of the facets.
TEST(BentBeam, ForceOfAMeshConvergesToThatOfTheBeam) {
  const BentTube tube;
  const double r = 5e-4, overlap = 5e-5;  // the patch is 0.45 mm wide; 384 facets are 0.49 mm wide
  const BeamRun folder("bent");
  const auto hold = [&](const std::string& wall, const std::string& file) {
    return preamble("-0.1 0.2 -0.1 0.1 -0.1 0.2") + "neighbor 0.001 bin\ntimestep 1e-7\npair_style gran " + kModel +
           "\npair_coeff * *\n" + held_grains(tube, r, overlap) + wall + dump_command(file, 1, "fx fy fz");
  };
  const Outcome beam =
      folder.coupled(hold(std::string("fix w all wall/gran/beam ") + kModel + " type 2 body arm\n", "beam.txt") +
                         "fix mbd all couple/mbd every 1\nrun 1\n",
                     "end 1e-7\nbody arm\n" + chain(tube.nodes(), tube.radius));
  ASSERT_EQ(beam.exit_code, 0) << beam.text;
  const Rows expected = folder.dump("beam.txt").at(0);
  ASSERT_EQ(expected.size(), 48u);

  std::vector<double> error;
  for (const int around : {96, 192, 384}) {
    const std::string name = "mesh" + std::to_string(around);
    tube.write_stl(folder.file(name + ".stl"), around);
    const Outcome mesh =
        folder.stock(hold("fix tube all mesh/surface file " + name + ".stl type 2\nfix w all wall/gran " + kModel +
                              " mesh n_meshes 1 meshes tube\n",
                          name + ".txt") +
                     "run 0\n");
    ASSERT_EQ(mesh.exit_code, 0) << mesh.text;
    const Rows found = folder.dump(name + ".txt").at(0);
    double worst = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto force = [i](const Rows& rows) { return Eigen::Vector3d(rows[i][1], rows[i][2], rows[i][3]); };
      ASSERT_GT(force(expected).norm(), 0.0);
      worst = std::max(worst, (force(found) - force(expected)).norm() / force(expected).norm());
    }
    // Hertz' force of an overlap that is smaller by the facet's distance from the tube.
    const double sagitta = tube.radius * (1.0 - std::cos(M_PI / around));
    EXPECT_NEAR(worst, 1.0 - std::pow(1.0 - sagitta / overlap, 1.5), 1e-3);
    error.push_back(worst);
  }
  EXPECT_LT(error[2], 0.04);
  EXPECT_GT(error[0] / error[1], 3.5);  // second order
  EXPECT_GT(error[1] / error[2], 3.8);
}

// A flexible tine dragged along fixed grains: the whole loop, mbd_solver with modes and LIGGGHTS with a beam
// wall, against beam theory.

// A plastic rod hangs from a carriage, is pushed 6 mm against a row of fixed grains, and dragged along it at
// 0.2 m/s. A shoe of 1 g at its end shows where that end is.
const char* const kScene = R"(title = "tine along a row of fixed grains"
end_time = 0.29
gravity = [0, 0, 0]
materials.plastic = { density = 1400, young = 3e9, poisson = 0.3 }
[[bodies]]
name = "carriage"
mass = 1.0
shape = { kind = "box", size = [0.1, 0.1, 0.05], centre = [0, 0, 0.325] }
[[bodies]]
name = "tine"
material = "plastic"
shape = { kind = "rod", from = [0, 0, 0.3], to = [0, 0, 0], diameter = 0.012 }
flexible = { elements = 12, modes = 8, damping = 0.05 }
[[bodies]]
name = "shoe"
mass = 0.001
shape = { kind = "sphere", centre = [0, 0, 0], radius = 0.004 }
[[joints]]
name = "drive"
kind = "prescribed"
bodies = ["ground", "carriage"]
point = [0, 0, 0.3]
axis = [0, 0, 1]
axis2 = [1, 0, 0]
[joints.motion]
x = { table = [[0, 0], [0.03, 0.001], [0.06, 0.005], [0.09, 0.006], [0.12, 0.006], [0.3, 0.006]] }
y = { polynomial = [0, 0.2] }
z = { polynomial = [0] }
rotation = { polynomial = [0] }
hold_other_rotations = true
[[joints]]
name = "clamp"
kind = "fixed"
bodies = ["carriage", "tine"]
point = [0, 0, 0.3]
[[joints]]
name = "end"
kind = "fixed"
bodies = ["tine", "shoe"]
point = [0, 0, 0]
[[boundaries]]
body = "tine"
beams = { segments = 12 }
[ground]
kind = "particles"
[particles]
script = "in.coupled"
ranks = 1
[output]
interval = 5e-4
plots = false
)";

std::string row_of_grains() {
  std::string text = preamble("-0.1 0.1 -0.1 0.2 -0.1 0.4", {0.4, 0.3, 0.1}) +
                     "timestep 2e-5\npair_style gran model hertz tangential history\npair_coeff * *\n";
  for (int i = 0; i < 20; ++i) text += "create_atoms 1 single 0.0165 " + std::to_string(-0.05 + 0.008 * i) + " 0.03\n";
  return text +
         "set group all diameter 0.02 density 2600\nneigh_modify exclude type 1 1\n"
         "fix w all wall/gran/beam model hertz tangential history type 2 body tine\nfix mbd all couple/mbd "
         "every 5\nrun 100000\n";
}

// The means over whole periods of the row (8 mm at 0.2 m/s = 0.04 s) obey statics, as the tine is linear:
// force F at the distance a below the clamp moves the end by F a^2 (3 L - a) / (6 E I). F and its moment,
// which gives a, are what mbd_solver got from LIGGGHTS.
TEST(Tine, BendsAsItsContactForceAsks) {
  const BeamRun folder("tine");
  const Outcome outcome = folder.scene(row_of_grains(), kScene);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  const History history = read_history(folder.file("out/history.csv"));
  const auto mean = [&history](const std::string& name) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < history.columns[0].size(); ++i) {
      const double t = history.columns[0][i];
      if (t < 0.13 - 1e-9 || t > 0.29 - 1e-9) continue;  // four periods
      sum += history.column(name)[i];
      ++count;
    }
    return sum / count;
  };
  const double L = 0.3, EI = 3e9 * M_PI * std::pow(0.012, 4) / 64.0;
  const double fx = mean("tine.contact.fx"), fy = mean("tine.contact.fy");
  const double height_x = mean("tine.z") + mean("tine.contact.my") / fx;
  const double height_y = mean("tine.z") - mean("tine.contact.mx") / fy;
  EXPECT_NEAR(height_x, 0.03, 2e-3);  // where the grains are
  EXPECT_NEAR(height_y, 0.03, 2e-3);
  const auto deflection = [&](double f, double height) {
    const double a = L - height;
    return f * a * a * (3.0 * L - a) / (6.0 * EI);
  };
  const double dx = mean("shoe.x") - mean("carriage.x"), dy = mean("shoe.y") - mean("carriage.y");
  EXPECT_LT(dx, -5e-3);
  EXPECT_LT(dy, -1e-3);
  // Measured: 0.9996 and 1.0008.
  EXPECT_NEAR(dx / deflection(fx, height_x), 1.0, 0.01);
  EXPECT_NEAR(dy / deflection(fy, height_y), 1.0, 0.01);
}

}  // namespace beams
}  // namespace footfall::test
