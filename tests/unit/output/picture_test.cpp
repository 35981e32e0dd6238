#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <sstream>

#include "unit/output/fake_stages.h"
#include "unit/output/temporary_folder.h"
#include "unit/output/vtp_read.h"
#include "worker/output/atomic_file.h"
#include "worker/output/vtp_write.h"
#include "worker/output/xyz_write.h"

namespace regolab {
namespace {

using test::VtpFile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(BedVtp, HoldsOneVertexPerSphereWithItsArraysToTheLastBit) {
  const VtpFile file(bed_vtp(test::small_bed()));
  EXPECT_EQ(file.count("NumberOfPoints"), 3);
  EXPECT_EQ(file.count("NumberOfVerts"), 3);
  EXPECT_THAT(file.array<double>("position", "Float64"),
              ElementsAre(0.01, 0.01, 0.005, 0.01, 0.01, 0.0149, 0.02, 0.01, 0.0149));
  EXPECT_THAT(file.array<double>("radius", "Float64"), ElementsAre(0.005, 0.005, 0.005));
  EXPECT_THAT(file.array<double>("velocity", "Float64"), ElementsAre(0.0, 0.0, 0.0, 0.1, -0.2, 1.0 / 3.0, 0.1, -0.2, 0.0));
  EXPECT_THAT(file.array<std::int32_t>("cluster", "Int32"), ElementsAre(0, 1, 1));
  EXPECT_THAT(file.array<std::int32_t>("contacts", "Int32"), ElementsAre(2, 1, 0)) << "the floor counts";
  EXPECT_THAT(file.array<std::int64_t>("connectivity", "Int64"), ElementsAre(0, 1, 2));
  EXPECT_THAT(file.array<std::int64_t>("offsets", "Int64"), ElementsAre(1, 2, 3));
}

TEST(ContactsVtp, DrawsALineFromCentreToCentreOrToTheWall) {
  const VtpFile file(contacts_vtp(test::small_bed()));
  EXPECT_EQ(file.count("NumberOfLines"), 2);
  EXPECT_THAT(file.array<double>("position", "Float64"),
              ElementsAre(0.01, 0.01, 0.005, 0.01, 0.01, 0.0149, 0.01, 0.01, 0.005, 0.01, 0.01, 0.0));
  EXPECT_THAT(file.array<double>("normal_force", "Float64"), ElementsAre(2.5, 4.0));
  EXPECT_THAT(file.array<std::int32_t>("wall", "Int32"), ElementsAre(-1, 4));
  EXPECT_THAT(file.array<std::int64_t>("offsets", "Int64"), ElementsAre(2, 4));
}

TEST(BedVtp, OfNoSpheresIsStillAWholeFile) {
  const VtpFile file(bed_vtp(BedView{}));
  EXPECT_EQ(file.count("NumberOfPoints"), 0);
  EXPECT_TRUE(file.array<double>("radius", "Float64").empty());
}

TEST(BedXyz, StatesItsColumnsAndReadsBackToTheLastBit) {
  std::istringstream in(bed_xyz(test::small_bed()));
  std::string count, comment, species;
  std::getline(in, count);
  std::getline(in, comment);
  EXPECT_EQ(count, "3");
  EXPECT_THAT(comment, HasSubstr("Lattice=\"0.03 0 0 0 0.02 0 0 0 0.025\""));
  EXPECT_THAT(comment, HasSubstr("Properties=species:S:1:pos:R:3:radius:R:1:cluster:I:1:velo:R:3:contacts:I:1"));
  double x, y, z, radius, vx, vy, vz;
  int cluster, contacts;
  for (const SphereView& sphere : test::small_bed().spheres) {
    in >> species >> x >> y >> z >> radius >> cluster >> vx >> vy >> vz >> contacts;
    ASSERT_TRUE(in.good());
    EXPECT_EQ(species, "Si");
    EXPECT_EQ(x, sphere.x);
    EXPECT_EQ(z, sphere.z);
    EXPECT_EQ(radius, sphere.radius);
    EXPECT_EQ(cluster, sphere.cluster);
    EXPECT_EQ(vz, sphere.vz);
  }
}

TEST(Pictures, AreReadByVtkAndAseWhereTheyAreInstalled) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_whole_file(folder / "bed.vtp", bed_vtp(test::small_bed())).ok());
  ASSERT_TRUE(write_whole_file(folder / "contacts.vtp", contacts_vtp(test::small_bed())).ok());
  ASSERT_TRUE(write_whole_file(folder / "bed.xyz", bed_xyz(test::small_bed())).ok());
  const std::string command = "/usr/bin/python3 " REGOLAB_READ_BACK " " + folder.path().string();  // Debian's own python
  const int status = std::system(command.c_str());
  constexpr int kNotInstalled = 77, kNoPython = 127;
  if (WIFEXITED(status) && (WEXITSTATUS(status) == kNotInstalled || WEXITSTATUS(status) == kNoPython)) {
    GTEST_SKIP() << "neither python3-vtk9 nor python3-ase is installed";
  }
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace regolab
