#include "mbd_solver/cli/launch/script_trace.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class ScriptTrace : public ::testing::Test, protected TemporaryFolder {
 protected:
  // The log of a run of in.grains that ended here, without the folder.
  std::string stopped(const std::string& log) const {
    const std::string place = where_liggghts_stopped(write("log", log), file("in.grains"), {});
    return place.substr(folder_.string().size() + 1);
  }
};

TEST_F(ScriptTrace, NamesTheLastLineThatTheLogRepeats) {
  write("in.grains", "units si\nrun 20\nfix 3 all ave/time 1 1 &\n   1 c_nothing\nrun 20\n");
  EXPECT_EQ(stopped("LIGGGHTS\nunits si\nrun 20\nStep Atoms\n0 4\n20 4\nfix 3 all ave/time 1 1    1 c_nothing\n"
                    "ERROR: Compute ID for fix ave/time does not exist\n"),
            "in.grains:3: fix 3 all ave/time 1 1 1 c_nothing");
  EXPECT_EQ(stopped("units si\nrun 20\nERROR: lost\n"), "in.grains:2: run 20");
  EXPECT_EQ(stopped("ERROR: before the first line\n"), "in.grains");
}

TEST_F(ScriptTrace, FollowsIncludesLoopsAndOtherLogs) {
  write("more.in", "variable n loop 2\nlabel again\ntimestep 1e-5\nnext n\njump SELF again\n");
  write("in.grains", "variable dt index 1e-5\ntimestep ${dt}\ninclude ${here}/more.in\nunits si\n");
  const std::string begin = "variable dt index 1e-5\ntimestep ${dt}\ntimestep 1e-5\n";
  // Its value stands in the log as well, and is no line of another file.
  EXPECT_EQ(stopped(begin + "ERROR: no\n"), "in.grains:2: timestep ${dt}");
  const std::string loop = begin + "include ${here}/more.in\ninclude /x/more.in\nvariable n loop 2\nlabel again\n";
  EXPECT_EQ(stopped(loop + "timestep 1e-5\nnext n\njump SELF again\ntimestep 1e-5\nERROR: no\n"),
            "more.in:3: timestep 1e-5");
  const std::string other = write("other", "units si\nERROR: no\n");
  EXPECT_EQ(stopped(loop + "timestep 1e-5\nlog ${out}/other\nlog " + other + "\n"), "in.grains:4: units si");
}

TEST_F(ScriptTrace, SaysWhatAnErrorMeansWhereThatIsKnown) {
  write("in.grains", "run 20\n");
  const auto why = [&](const std::string& error) {
    return why_liggghts_stopped(write("log", "run 20\n" + error + "\n"), file("in.grains"), {});
  };
  const std::string place = file("in.grains") + ":1: run 20\n";
  EXPECT_EQ(why("ERROR: lost"), place + "ERROR: lost");
  for (const char* header : {"./src/tri_mesh_I.h", "/usr/include/liggghts/tri_mesh_I.h"}) {
    const std::string internal = std::string("ERROR on proc 0: Internal error (") + header + ":109)";
    EXPECT_EQ(why(internal).rfind(place + internal + "\nThe place of a grain at a mesh is no number.", 0), 0U);
  }
}

}  // namespace
}  // namespace footfall
