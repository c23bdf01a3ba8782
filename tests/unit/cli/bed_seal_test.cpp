// mbd_solver/cli/launch/bed_seal.h: damage to a kept bed is told, and whole ones pass.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/launch/bed_seal.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

template <class T>
std::string bytes_of(T value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}
std::string text_of(const std::string& text) {
  return bytes_of(static_cast<std::int32_t>(text.size() + 1)) + text + '\0';
}

// A restart file as LIGGGHTS writes it: header, whatever is between, and the grains of each process. The numbers of a
// grain behind its place are zeros, as those of a bed at rest nearly are.
std::string restart(const std::vector<int>& grains_of_process, double x = 0.1) {
  std::string bytes;
  int all = 0;
  for (const int grains : grains_of_process) all += grains;
  for (std::int32_t flag = 0; flag <= 23; ++flag) {
    bytes += bytes_of(flag);
    if (flag == 0)
      bytes += text_of("Version LIGGGHTS-PUBLIC 3.8.0");
    else if (flag == 4)
      bytes += text_of("si");
    else if (flag == 22)
      bytes += text_of("granular");
    else if (flag == 5)
      bytes += bytes_of(std::int64_t{0});
    else if (flag == 23)
      bytes += bytes_of(std::int64_t{all});
    else
      bytes += bytes_of(flag == 7 ? static_cast<std::int32_t>(grains_of_process.size()) : 1);
  }
  bytes += "types, forces and fixes";
  for (const int grains : grains_of_process) {
    constexpr int kNumbers = 9;
    bytes += bytes_of(static_cast<std::int32_t>(kNumbers * grains));
    for (int k = 0; k < grains; ++k) {
      bytes += bytes_of(static_cast<double>(kNumbers)) + bytes_of(x) + bytes_of(0.2) + bytes_of(0.3);
      for (int i = 4; i < kNumbers; ++i) bytes += bytes_of(0.0);
    }
  }
  return bytes;
}

class BedSeal : public ::testing::Test, protected TemporaryFolder {
 protected:
  std::string told(const std::string& bytes) { return damage_of_restart(write(kBedRestart, bytes)); }
};

TEST_F(BedSeal, WholeRestartFilesPass) {
  EXPECT_EQ(told(restart({50})), "");
  EXPECT_EQ(told(restart({50, 1, 30})), "");
  EXPECT_EQ(told(restart({50, 0, 30, 0, 0})), "") << "processes without grains";
}

TEST_F(BedSeal, EveryTruncatedRestartFileIsTold) {
  const std::string whole = restart({20, 0, 10});
  for (std::size_t size = 0; size < whole.size(); ++size)
    ASSERT_NE(told(whole.substr(0, size)), "") << size << " of " << whole.size() << " bytes";
}

TEST_F(BedSeal, NoNumberAndForeignFilesAreTold) {
  EXPECT_EQ(told(""), "bed.restart is empty");
  EXPECT_EQ(told("ITEM: TIMESTEP"), "bed.restart does not begin as a restart file of LIGGGHTS does");
  EXPECT_EQ(told(restart({5}, std::nan(""))), "bed.restart does not hold the 5 grains that it begins with");
  EXPECT_EQ(told(restart({5}, std::numeric_limits<double>::infinity())),
            "bed.restart does not hold the 5 grains that it begins with");
}

TEST_F(BedSeal, EveryFlippedByteOfASealedBedIsTold) {
  const std::string whole = restart({6}), dump = "ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y z radius\n1 2 3 4\n";
  write(kBedRestart, whole);
  write(kBedGrains, dump);
  seal_bed(folder_.string());
  EXPECT_EQ(damage_of_bed(folder_.string()), "");
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string flipped = whole;
    flipped[place] = static_cast<char>(flipped[place] ^ 0x10);
    write(kBedRestart, flipped);
    ASSERT_EQ(damage_of_bed(folder_.string()), "bed.restart has changed since it was made (checksum)") << place;
  }
  write(kBedRestart, whole.substr(1));
  EXPECT_NE(damage_of_bed(folder_.string()).find("bytes, it was made with"), std::string::npos);
  write(kBedRestart, whole);
  std::filesystem::remove(folder_ / kBedGrains);
  EXPECT_EQ(damage_of_bed(folder_.string()), "bed.restart.grains is missing");
  std::filesystem::remove(folder_ / kBedRestart);
  EXPECT_EQ(damage_of_bed(folder_.string()), "bed.restart is missing");
}

TEST_F(BedSeal, BedsOfEarlierVersionsAreLookedAtFromOutside) {
  write(kBedRestart, restart({6}));
  EXPECT_EQ(damage_of_bed(folder_.string()), "");
  write(kBedGrains, "ITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS x y z radius\n1 2 3 4\n");
  EXPECT_EQ(damage_of_bed(folder_.string()), "bed.restart.grains holds 1 grains, it begins with 2");
  write(kBedGrains, "ITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS x y z radius\n1 2 3 4\n1 2 3 nan\n");
  EXPECT_EQ(damage_of_bed(folder_.string()), "bed.restart.grains:5: \"1 2 3 nan\" is not finite");
}

}  // namespace
}  // namespace footfall
