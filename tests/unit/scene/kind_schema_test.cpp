#include "mbd_solver/scene/kind_schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mbd_solver/scene/scene_schema.h"

namespace footfall {
namespace {

using Names = std::set<std::string>;

// Keys of an entry of [[family]] as the reader knows them, without those in other units.
Names keys_of_schema(const std::string& family) {
  const Json schema = Json::parse(scene_schema());
  const Json& place = schema["properties"][family];
  const Json& entry = place.contains("items") ? place["items"] : place["additionalProperties"];
  Names keys;
  for (const auto& [key, value] : entry["properties"].items())
    if (!value.contains("x-unit-of") && key != "without") keys.insert(key);
  return keys;
}

Names keys_of_kinds(const std::string& family) {
  Names keys;
  const Json schema = kind_schema();
  for (const auto& [kind, uses] : schema[family].items())
    for (const char* use : {"required", "optional"})
      for (const Json& key : uses[use]) keys.insert(key.get<std::string>());
  return keys;
}

TEST(KindSchema, EveryKeyOfAJointBelongsToAKindOrToAll) {
  Names expected = keys_of_schema("joints");
  for (const char* of_all : {"name", "type", "bodies", "point", "point_a", "point_b"})
    EXPECT_EQ(expected.erase(of_all), 1U);
  EXPECT_EQ(keys_of_kinds("joints"), expected);
}

TEST(KindSchema, NamesOnlyKeysThatTheReaderKnows) {
  const Json schema = kind_schema();
  for (const auto& [family, kinds] : schema.items()) {
    const Names known = keys_of_schema(family);
    EXPECT_GT(kinds.size(), 2U) << family;
    for (const std::string& key : keys_of_kinds(family)) EXPECT_EQ(known.count(key), 1U) << family << ": " << key;
  }
}

TEST(KindSchema, IsPartOfTheSchema) { EXPECT_EQ(Json::parse(scene_schema())["x-kinds"], kind_schema()); }

}  // namespace
}  // namespace footfall
