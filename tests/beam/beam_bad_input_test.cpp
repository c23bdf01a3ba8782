// What a user can get wrong with beams: each ends the run at once, on both sides, and says what is wrong and
// what to do.

#include <gtest/gtest.h>

#include <ostream>

#include "tests/beam/beam_run.h"

namespace footfall::test {
namespace {

struct Mistake {
  std::string name;
  std::string wall;     // after `model ...`
  std::string message;  // must be said
  std::string motion = {};
  int ranks = 1;
  std::string couple = "fix mbd all couple/mbd every 5\n";
};

std::ostream& operator<<(std::ostream& out, const Mistake& m) { return out << m.name; }

class BeamMistake : public testing::TestWithParam<Mistake> {};

TEST_P(BeamMistake, IsToldAndEndsTheRun) {
  const Mistake& m = GetParam();
  const BeamRun folder("mistake_" + m.name);
  const std::string tines = "end 0.001\nbody tine_1\n" + chain({"-0.2 0 0", "0 0 0", "0.2 0 0"}, 0.02) +
                            "body plate\nnode 0 0 0\nbody fork\n" + chain({"-0.2 0.1 0", "0.2 0.1 0"}, 0.02) +
                            chain({"-0.2 0.2 0", "0.2 0.2 0"}, 0.02, 2, 3);
  const Outcome outcome =
      folder.coupled(preamble("-0.3 0.3 -0.3 0.3 -0.3 0.3") +
                         "timestep 2e-5\npair_style gran model hertz tangential history\npair_coeff * *\n"
                         "create_atoms 1 single 0 0 0.1\nset group all diameter 0.04 density 2600\n"
                         "fix w all wall/gran/beam model hertz tangential history " +
                         m.wall + "\n" + m.couple + "run 50\n",
                     m.motion.empty() ? tines : m.motion, m.ranks);
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.text.find(m.message), std::string::npos) << outcome.text;
}

const std::string kOne = "end 0.001\nbody tine_1\n";

INSTANTIATE_TEST_SUITE_P(
    Each, BeamMistake,
    testing::Values(
        Mistake{"unknown_body", "type 2 body tine_2", "Did you mean \"tine_1\"?"},
        Mistake{"body_without_beams", "type 2 body plate", "body \"plate\" has no beams that grains may touch"},
        Mistake{"no_such_beam", "type 2 body fork chain 1",
                "body \"fork\" has no beam 1. It has 2 beams, numbers 0, 3"},
        Mistake{"chain_without_body", "type 2 chain 1 body tine_1",
                "\"chain 1\" does not follow a body, whose beam it would be"},
        Mistake{"chain_not_a_number", "type 2 body fork chain first", "\"chain first\" is not the number of a beam"},
        Mistake{"type_without_material", "type 3 body tine_1",
                "no material is known for type 3: the box has types 1 to 2"},
        Mistake{"no_type", "body tine_1", "the material is missing, keyword \"type\""},
        Mistake{"no_body", "type 2", "the body is missing, keyword \"body\""},
        Mistake{"two_types", "type 2 body tine_1 type 1", "keyword \"type\" stands twice"},
        Mistake{"beam_twice", "type 2 body fork chain 3 body tine_1 body fork",
                "the same beam of body \"fork\" is asked for twice"},
        Mistake{"forces_of_two_beams", "type 2 body fork store_force_contact yes",
                "store_force_contact keeps one contact per grain and fix"},
        Mistake{"value_missing", "type 2 body", "nothing follows keyword \"body\""},
        Mistake{"mesh_keyword", "mesh n_meshes 1 meshes x type 2 body tine_1",
                "keyword \"mesh\" belongs to fix wall/gran"},
        Mistake{
            "nothing_moves_it", "type 2 body tine_1", "Add `fix ID all couple/mbd every N` to the script", {}, 1, ""},
        Mistake{"zero_radius", "type 2 body tine_1", "segment 0 has no radius",
                kOne + chain({"-0.2 0 0", "0.2 0 0"}, 0.0)},
        Mistake{"zero_length", "type 2 body tine_1", "segment 1 has no length",
                kOne + chain({"-0.2 0 0", "0.1 0 0", "0.1 0 0"}, 0.02)},
        Mistake{"longer_than_the_box", "type 2 body tine_1", "longer than a subdomain",
                kOne + chain({"-400 0 0", "400 0 0"}, 20.0)},
        Mistake{"longer_than_a_subdomain", "type 2 body tine_1",
                "is 0.400000 m long, longer than a subdomain of this run (0.300000 m)",
                kOne + chain({"-0.2 0 0", "0.2 0 0"}, 0.02), 2}),
    [](const auto& mistake) { return mistake.param.name; });

}  // namespace
}  // namespace footfall::test
