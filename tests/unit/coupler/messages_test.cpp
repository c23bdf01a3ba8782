#include "coupler/messages.h"

#include <gtest/gtest.h>

#include <cstring>

#include "coupler/base/errors.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

using test::Random;

Motion sample_motion() {
  Random random(41);
  Motion motion;
  motion.window = 12345678901;
  motion.time = 0.125;
  motion.n = 7;
  motion.last_window = true;
  motion.bodies = {random.motion(0), random.motion(3)};
  return motion;
}

Load sample_load() {
  Random random(42);
  Load load;
  load.window = 9;
  load.particles = 40000;
  load.wall_seconds = 0.25;
  for (const int modes : {0, 2}) {
    BodyLoad body;
    body.mean = MeanLoad(modes);
    body.mean.F_W = random.vector();
    body.mean.T_B = random.vector();
    random.fill(body.mean.Q_a);
    body.mean.work = 1.5;
    body.mean.jump_work = -0.5;
    body.mean.impulse_W = random.vector();
    body.contacts = 17;
    body.contact_stiffness = 1e6;
    body.max_overlap_over_radius = 0.02;
    load.bodies.push_back(body);
  }
  load.bodies[1].tangent.resize(1);
  random.fill(load.bodies[1].tangent[0].K);
  random.fill(load.bodies[1].tangent[0].C);
  return load;
}

Geometry sample_geometry() {
  Random random(43);
  Geometry geometry;
  geometry.bodies.push_back({random.boundary(6, 0), random.motion(0)});
  geometry.bodies.push_back({random.boundary(5, 4), random.motion(4)});
  return geometry;
}

TEST(Messages, ReusedBuffersAreNotAllocatedAnew) {
  const Load load = sample_load();
  Bytes bytes;
  pack(load, bytes);
  const std::uint8_t* const memory = bytes.data();
  Load received;
  unpack(bytes, received);
  const double* const modal = received.bodies[1].mean.Q_a.data();
  pack(load, bytes);
  unpack(bytes, received);
  EXPECT_EQ(bytes.data(), memory);
  EXPECT_EQ(received.bodies[1].mean.Q_a.data(), modal);
}

template <class Message>
class EveryMessage : public testing::Test {};
using Kinds = testing::Types<Hello, Geometry, Start, Accept, Motion, Load, Close>;
TYPED_TEST_SUITE(EveryMessage, Kinds);

template <class Message>
Message sample() {
  if constexpr (std::is_same_v<Message, Geometry>) return sample_geometry();
  if constexpr (std::is_same_v<Message, Motion>) return sample_motion();
  if constexpr (std::is_same_v<Message, Load>) return sample_load();
  return Message{};
}

TYPED_TEST(EveryMessage, CutShortOrTooLongIsRefused) {
  Bytes whole;
  pack(sample<TypeParam>(), whole);
  TypeParam received;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(unpack(part, received), ProtocolError) << size << " of " << whole.size();
  }
  whole.push_back(0);
  EXPECT_THROW(unpack(whole, received), ProtocolError);
}

TYPED_TEST(EveryMessage, GarbageIsRefusedOrReadButNeverCrashes) {
  Bytes whole;
  pack(sample<TypeParam>(), whole);
  std::mt19937 random(44);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Bytes bytes = whole;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    TypeParam received;
    try {
      unpack(bytes, received);
    } catch (const ProtocolError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);  // the head and the counts alone are more than a tenth of the bytes of any message
  Bytes noise(200);
  for (std::uint8_t& byte : noise) byte = static_cast<std::uint8_t>(random());
  TypeParam received;
  EXPECT_THROW(unpack(noise, received), ProtocolError);
}

TYPED_TEST(EveryMessage, OfAnotherKindIsRefusedByName) {
  Bytes bytes;
  if constexpr (std::is_same_v<TypeParam, Start>)
    pack(Accept{}, bytes);
  else
    pack(Start{}, bytes);
  TypeParam received;
  try {
    unpack(bytes, received);
    FAIL();
  } catch (const ProtocolError& error) {
    EXPECT_NE(std::string(error.what()).find(message_name(TypeParam::kKind)), std::string::npos);
  }
}

TEST(Messages, AnotherProtocolVersionIsRefusedNamingBoth) {
  Bytes bytes;
  pack(Start{}, bytes);
  const std::int32_t foreign = 999;
  std::memcpy(bytes.data() + 8, &foreign, sizeof foreign);
  Start start;
  try {
    unpack(bytes, start);
    FAIL();
  } catch (const ProtocolError& error) {
    EXPECT_NE(std::string(error.what()).find("999"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("version " + std::to_string(kProtocolVersion)), std::string::npos);
  }
  EXPECT_THROW(check_partner("mbd_solver", 999, kFootfallVersion), ProtocolError);
  EXPECT_THROW(check_partner("mbd_solver", kProtocolVersion, "0.0.0"), ProtocolError);
  EXPECT_NO_THROW(check_partner("mbd_solver", kProtocolVersion, kFootfallVersion));
}

}  // namespace
}  // namespace footfall
