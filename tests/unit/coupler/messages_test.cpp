#include "coupler/messages.h"

#include <gtest/gtest.h>

#include <cstring>

#include "coupler/base/errors.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

using test::Random;

void expect_equal(const BodyMotion& a, const BodyMotion& b) {
  EXPECT_EQ(a.r, b.r);
  EXPECT_EQ(a.L, b.L);
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.dr, b.dr);
  EXPECT_EQ(a.w, b.w);
  EXPECT_EQ(a.da, b.da);
  EXPECT_EQ(a.ddr, b.ddr);
  EXPECT_EQ(a.dw, b.dw);
  EXPECT_EQ(a.dda, b.dda);
}

template <class Message>
Message round_trip(const Message& sent) {
  Bytes bytes;
  pack(sent, bytes);
  Message received;
  unpack(bytes, received);
  return received;
}

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

TEST(Messages, HelloComesBackAsItWas) {
  Hello hello;
  hello.protocol = 77;
  hello.unit_style = "si";
  const Hello back = round_trip(hello);
  EXPECT_EQ(back.protocol, 77);  // every version can be read, so that both values can be named
  EXPECT_EQ(back.footfall_version, kFootfallVersion);
  EXPECT_EQ(back.unit_style, "si");
}

TEST(Messages, GeometryComesBackAsItWas) {
  const Geometry sent = sample_geometry();
  const Geometry back = round_trip(sent);
  ASSERT_EQ(back.bodies.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const ModalBoundary &a = sent.bodies[i].boundary, &b = back.bodies[i].boundary;
    EXPECT_EQ(a.name(), b.name());
    EXPECT_EQ(a.rho0(), b.rho0());
    EXPECT_EQ(a.triangles(), b.triangles());
    ASSERT_EQ(a.segments().size(), b.segments().size());
    EXPECT_EQ(a.segments()[2].end, b.segments()[2].end);
    EXPECT_EQ(a.segments()[2].radius, b.segments()[2].radius);
    EXPECT_EQ(a.Phi(), b.Phi());
    EXPECT_EQ(a.Psi(), b.Psi());
    expect_equal(sent.bodies[i].initial, back.bodies[i].initial);
  }
}

TEST(Messages, StartAndAcceptComeBackAsTheyWere) {
  Start start;
  start.dt = 1e-4;
  start.n = 5;
  start.step = 1234567890123;
  start.bodies = {"pad_1", "", "pad_2"};
  const Start start_back = round_trip(start);
  EXPECT_EQ(start_back.dt, 1e-4);
  EXPECT_EQ(start_back.n, 5);
  EXPECT_EQ(start_back.step, 1234567890123);
  EXPECT_EQ(start_back.bodies, start.bodies);
  Accept accept;
  accept.scheme = "css";
  accept.t_end = 1.0;
  accept.t_start = 0.25;
  accept.n_max = 50;
  const Accept accept_back = round_trip(accept);
  EXPECT_EQ(accept_back.scheme, "css");
  EXPECT_EQ(accept_back.t_end, 1.0);
  EXPECT_EQ(accept_back.t_start, 0.25);
  EXPECT_EQ(accept_back.n_max, 50);
}

TEST(Messages, MotionComesBackAsItWas) {
  const Motion sent = sample_motion();
  const Motion back = round_trip(sent);
  EXPECT_EQ(back.window, sent.window);
  EXPECT_EQ(back.time, sent.time);
  EXPECT_EQ(back.n, 7);
  EXPECT_TRUE(back.last_window);
  ASSERT_EQ(back.bodies.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) expect_equal(back.bodies[i], sent.bodies[i]);
}

TEST(Messages, LoadComesBackAsItWas) {
  const Load sent = sample_load();
  const Load back = round_trip(sent);
  EXPECT_EQ(back.window, 9);
  EXPECT_EQ(back.particles, 40000);
  EXPECT_EQ(back.wall_seconds, 0.25);
  ASSERT_EQ(back.bodies.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyLoad &a = sent.bodies[i], &b = back.bodies[i];
    EXPECT_EQ(a.mean.F_W, b.mean.F_W);
    EXPECT_EQ(a.mean.T_B, b.mean.T_B);
    EXPECT_EQ(a.mean.Q_a, b.mean.Q_a);
    EXPECT_EQ(a.mean.work, b.mean.work);
    EXPECT_EQ(a.mean.jump_work, b.mean.jump_work);
    EXPECT_EQ(a.mean.impulse_W, b.mean.impulse_W);
    EXPECT_EQ(a.contacts, b.contacts);
    EXPECT_EQ(a.contact_stiffness, b.contact_stiffness);
    EXPECT_EQ(a.max_overlap_over_radius, b.max_overlap_over_radius);
    ASSERT_EQ(a.tangent.size(), b.tangent.size());
  }
  EXPECT_EQ(back.bodies[1].tangent[0].K, sent.bodies[1].tangent[0].K);
  EXPECT_EQ(back.bodies[1].tangent[0].C, sent.bodies[1].tangent[0].C);
}

TEST(Messages, CloseCarriesStatusAndReason) {
  const Close back = round_trip(Close{Status::kInterrupted, "stopped by hand"});
  EXPECT_EQ(back.status, Status::kInterrupted);
  EXPECT_EQ(back.reason, "stopped by hand");
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
