// Files that are not usable scenes: each is refused with one line that names the file, the node and the
// property.
#include <gtest/gtest.h>

#include "tests/scene/scene_document.h"

namespace hrt {
namespace {

Json good() {
  return document({plate(), real(), virtual_on_the_left()});
}

// good() with one change.
Json with(const char* pointer, Json value) {
  Json file = good();
  file[Json::json_pointer(pointer)] = std::move(value);
  return file;
}

std::string refusal_with(const char* pointer, Json value) {
  return refusal(with(pointer, std::move(value)));
}

TEST(SceneRefusal, GoodFileIsNotRefused) {
  EXPECT_EQ(refusal(good()), "");
}

TEST(SceneRefusal, NotGltf) {
  for (const char* text : {"", "hello", "{", "[]", "1", "null", "\"glTF\"", "{}", "{\"asset\":{}}",
                           "{\"asset\":{\"version\":2.0}}", "\x89PNG\r\n\x1a\n",
                           "{\"asset\":{\"version\":\"2.0\"}}NaN", "{\"asset\":{\"version\":\"\xff\"}}"}) {
    SCOPED_TRACE(text);
    EXPECT_TRUE(refusal(text).starts_with("test.gltf: not a glTF file: ")) << refusal(text);
  }
  EXPECT_EQ(refusal_with("/asset/version", "1.0"), "test.gltf: asset.version is \"1.0\"; glTF 2 is read");
  EXPECT_EQ(refusal_with("/nodes", Json::object()), "test.gltf: nodes is not an array of objects");
  EXPECT_EQ(refusal_with("/nodes/0", 7), "test.gltf: nodes is not an array of objects");
  EXPECT_EQ(refusal_with("/scenes", Json::array({7})), "test.gltf: scenes is not an array of objects");
  EXPECT_EQ(refusal_with("/scene", 1), "test.gltf: scene is \"1\", and there are 1 scenes");
  EXPECT_EQ(refusal_with("/scene", -1), "test.gltf: scene is \"-1\", and there are 1 scenes");
  EXPECT_EQ(refusal_with("/scene", "0"), "test.gltf: scene is \"\"0\"\", and there are 1 scenes");
}

TEST(SceneRefusal, CutShortAtEveryByte) {
  const std::string text = good().dump();
  for (std::size_t size = 0; size < text.size(); ++size) {
    ASSERT_NE(refusal(text.substr(0, size)), "") << "at byte " << size;
  }
  const std::string binary = glb(good(), "abcd");
  ASSERT_EQ(refusal(binary), "");
  for (std::size_t size = 0; size < binary.size(); ++size) {
    ASSERT_NE(refusal(binary.substr(0, size)), "") << "at byte " << size;
  }
}

TEST(SceneRefusal, BinaryHeader) {
  const std::string binary = glb(good());
  const auto with_word = [&](std::size_t at, std::size_t value) {
    return refusal(std::string(binary).replace(at, 4, little_endian(value)));
  };
  const std::string size = std::to_string(binary.size());
  EXPECT_EQ(with_word(4, 1), "test.gltf: the binary glTF header has version 1; glTF 2 is read");
  EXPECT_EQ(with_word(8, 0x80000000u),
            "test.gltf: the binary glTF header claims 2147483648 bytes, and there are " + size);
  EXPECT_EQ(with_word(12, 0x7fffffffu), "test.gltf: the JSON chunk claims 2147483647 bytes, and " +
                                            std::to_string(binary.size() - 20) + " are left");
  EXPECT_EQ(with_word(16, 0), "test.gltf: the first chunk of a binary glTF must be JSON");
  EXPECT_EQ(refusal("glTF"), "test.gltf: the binary glTF header is cut short");
}

TEST(SceneRefusal, NodeGraph) {
  EXPECT_EQ(refusal_with("/nodes/0/children", {1, 2}),
            "test.gltf: scenes[0].nodes holds 1, which is not a root but "
            "the child of another node");
  EXPECT_EQ(refusal_with("/nodes/0/children", {3}),
            "test.gltf: node \"Plate\": children holds 3, and there are 3 nodes");
  EXPECT_EQ(refusal_with("/nodes/0/children", {-1}),
            "test.gltf: node \"Plate\": children holds \"-1\", which is not an index");
  EXPECT_EQ(refusal_with("/nodes/0/children", {1.0}),
            "test.gltf: node \"Plate\": children holds \"1.0\", which is not an index");
  EXPECT_EQ(refusal_with("/nodes/0/children", 1), "test.gltf: node \"Plate\": children is not an array");
  EXPECT_EQ(refusal_with("/scenes/0/nodes", {0, 3}),
            "test.gltf: scenes[0].nodes holds 3, and there are 3 nodes");
  EXPECT_EQ(refusal_with("/scenes/0/nodes", {0, 0}), "test.gltf: scenes[0].nodes holds 0 twice");

  Json two_parents = good();
  two_parents["nodes"][0]["children"] = {2};
  two_parents["nodes"][1]["children"] = {2};
  EXPECT_EQ(refusal(two_parents),
            "test.gltf: node \"Left\": children of both node \"Plate\" and node \"Real\" name it; "
            "a node has one parent");
  two_parents["nodes"][1]["children"] = Json::array();
  two_parents["nodes"][0]["children"] = {2, 2};
  EXPECT_EQ(refusal(two_parents),
            "test.gltf: node \"Left\": children of both node \"Plate\" and node \"Plate\" name "
            "it; a node has one parent");

  EXPECT_EQ(refusal_with("/nodes/2/children", {2}),
            "test.gltf: node \"Left\": children of the nodes below it lead back to it: a cycle");
  Json cycle = good();
  cycle["nodes"][1]["children"] = {2};
  cycle["nodes"][2]["children"] = {1};
  EXPECT_EQ(refusal(cycle),
            "test.gltf: node \"Real\": children of the nodes below it lead back to it: a cycle");
}

TEST(SceneRefusal, Transforms) {
  EXPECT_EQ(refusal_with("/nodes/1/translation", {0, 0}),
            "test.gltf: node \"Real\": translation is not an array of 3 numbers");
  EXPECT_EQ(refusal_with("/nodes/1/translation", {0, 0, "NaN"}),
            "test.gltf: node \"Real\": translation is not an array of 3 numbers");
  EXPECT_EQ(refusal_with("/nodes/1/translation", {0, 0, 1e300}),
            "test.gltf: node \"Real\": its place in the world is further than 1e6 m from the origin");
  EXPECT_EQ(refusal_with("/nodes/1/rotation", {0, 0, 0, 0}),
            "test.gltf: node \"Real\": rotation is not a quaternion of unit length");
  EXPECT_EQ(refusal_with("/nodes/1/rotation", {1e200, 0, 0, 0}),
            "test.gltf: node \"Real\": rotation is not a quaternion of unit length");
  EXPECT_EQ(refusal_with("/nodes/1/scale", 2),
            "test.gltf: node \"Real\": scale is not an array of 3 numbers");
  EXPECT_EQ(refusal_with("/nodes/1/matrix", Json::array({1, 0, 0})),
            "test.gltf: node \"Real\": matrix is not an array of 16 numbers");
  const Json identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_EQ(refusal_with("/nodes/1/matrix", identity),
            "test.gltf: node \"Real\": matrix is given beside translation, rotation or scale; glTF allows "
            "one form");
  Json projective = identity;
  projective[3] = 0.5;
  EXPECT_EQ(refusal_with("/nodes/0/matrix", projective),
            "test.gltf: node \"Plate\": matrix has a fourth row other than 0 0 0 1");

  EXPECT_EQ(refusal_with("/nodes/0/scale", {1, 0, 1}),
            "test.gltf: node \"Plate\": its scale has a zero-length axis or flattens space");
  Json flat = identity;
  flat[8] = 1;  // +Z is made the same as +X
  flat[10] = 0;
  EXPECT_EQ(refusal_with("/nodes/0/matrix", flat),
            "test.gltf: node \"Plate\": its matrix has a zero-length axis or flattens space");
  EXPECT_EQ(
      refusal(document({node("Group", {}, {{"scale", {0, 0, 0}}, {"children", {1}}}), plate()})),
      "test.gltf: node \"Group\": its scale has a zero-length axis or flattens space, and \"Group/Plate\" is "
      "below it");

  // JSON has no NaN and no infinity; a number that overflows would be one.
  for (const char* number : {"NaN", "-Infinity", "1e999", "-1e999"}) {
    std::string text = good().dump();
    text.replace(text.find("-0.05"), 5, number);
    EXPECT_TRUE(refusal(text).starts_with("test.gltf: not a glTF file: ")) << refusal(text);
  }
}

TEST(SceneRefusal, Roles) {
  EXPECT_EQ(refusal(document({node("Cube", {}), node("Light", {{"haptics", 1}})})),
            "test.gltf: no node has a haptic role (extras.haptic.role, or extras.haptic_role)");
  EXPECT_EQ(refusal(document({real(), virtual_on_the_left()})),
            "test.gltf: no node has extras.haptic.role \"plate\"");
  EXPECT_EQ(refusal(document({plate(), node("Second", haptic("plate", {{"radius_m", 1}}))})),
            "test.gltf: node \"Second\": extras.haptic.role is the same as that of \"Plate\", and there may "
            "be one only");
  EXPECT_EQ(
      refusal(document({plate(), node("A", haptic("start")), node("B", haptic("start"))})),
      "test.gltf: node \"B\": extras.haptic.role is the same as that of \"A\", and there may be one only");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/role", "Real"),
            "test.gltf: node \"Real\": extras.haptic.role is \"Real\"; allowed are \"plate\", \"real\", "
            "\"virtual\" and "
            "\"start\"");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/role", 3),
            "test.gltf: node \"Real\": extras.haptic.role is not a string");
  EXPECT_EQ(refusal_with("/nodes/1/extras", {{"haptic_role", Json()}}),
            "test.gltf: node \"Real\": extras.haptic_role is not a string");
  EXPECT_EQ(refusal_with("/nodes/1/extras", {{"haptic_name", "brass"}}),
            "test.gltf: node \"Real\": extras.haptic_role is missing, beside extras.haptic_name");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic", {{"name", "brass"}}),
            "test.gltf: node \"Real\": extras.haptic.role is missing, beside extras.haptic.name");
  for (const Json& not_an_object : {Json(), Json::object(), Json("real"), Json::array({"role", "real"})}) {
    EXPECT_EQ(refusal_with("/nodes/1/extras/haptic", not_an_object),
              "test.gltf: node \"Real\": extras.haptic is not an object with a role");
  }
  EXPECT_EQ(
      refusal_with("/nodes/1/extras/haptic_radius_m", 1),
      "test.gltf: node \"Real\": both extras.haptic and extras.haptic_radius_m are given; keep one form");
}

TEST(SceneRefusal, Properties) {
  Json file = good();
  file["nodes"][0]["extras"]["haptic"].erase("radius_m");
  EXPECT_EQ(
      refusal(file),
      "test.gltf: node \"Plate\": extras.haptic.radius_m is missing: a plate needs its radius in metres");
  EXPECT_EQ(refusal_with("/nodes/0/extras/haptic/radius_m", 0),
            "test.gltf: node \"Plate\": extras.haptic.radius_m is 0; allowed is more than 0, up to 10");
  EXPECT_EQ(refusal_with("/nodes/0/extras/haptic/radius_m", -0.075),
            "test.gltf: node \"Plate\": extras.haptic.radius_m is -0.075; allowed is more than 0, up to 10");
  // 2^32 + 1, of which 32 bits are 1.
  EXPECT_EQ(
      refusal_with("/nodes/0/extras/haptic/radius_m", 4294967297),
      "test.gltf: node \"Plate\": extras.haptic.radius_m is 4.29497e+09; allowed is more than 0, up to 10");
  EXPECT_EQ(refusal_with("/nodes/0/extras/haptic/radius_m", "0.075"),
            "test.gltf: node \"Plate\": extras.haptic.radius_m is not a number");
  EXPECT_EQ(refusal_with("/nodes/0/extras/haptic/radius_m", true),
            "test.gltf: node \"Plate\": extras.haptic.radius_m is not a number");
  EXPECT_EQ(refusal_with("/nodes/0/extras/haptic/max_speed_deg_s", 1e6),
            "test.gltf: node \"Plate\": extras.haptic.max_speed_deg_s is 1e+06; allowed is more than 0, up "
            "to 100000");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/radius", 0.01),
            "test.gltf: node \"Real\": extras.haptic.radius is not a property of this role; allowed are "
            "role, name, "
            "radius_m");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/served_by", "Left"),
            "test.gltf: node \"Real\": extras.haptic.served_by is not a property of this role; allowed are "
            "role, name, "
            "radius_m");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/ra\rdius", 0.01),
            "test.gltf: node \"Real\": extras.haptic.ra?dius is not a property of this role; allowed are "
            "role, name, "
            "radius_m");
  EXPECT_EQ(refusal_with(("/nodes/1/extras/haptic/" + std::string(3000, 'r')).c_str(), 0.01),
            "test.gltf: node \"Real\": extras.haptic." + std::string(80, 'r') +
                "... is not a property of this role; allowed are role, name, radius_m");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/name", ""),
            "test.gltf: node \"Real\": extras.haptic.name has 0 bytes; allowed are 1 to 255");
  EXPECT_EQ(refusal_with("/nodes/1/name", 5),
            "test.gltf: node [1]: name is not a string of at most 255 bytes");
  EXPECT_EQ(refusal_with("/nodes/1/name", std::string(256, 'x')),
            "test.gltf: node \"" + std::string(80, 'x') + "...\": name is not a string of at most 255 bytes");
}

TEST(SceneRefusal, Targets) {
  EXPECT_EQ(
      refusal_with("/nodes/2/name", "Real"),
      "test.gltf: node \"Real\": its name \"Real\" is also that of \"Real\"; targets need names of their own "
      "(extras.haptic.name)");
  EXPECT_EQ(refusal_with("/nodes/1/translation", {0.0, 0.3, 0.05}),
            "test.gltf: node \"Real\": the target lies at the start point, so it has no direction");
  EXPECT_EQ(refusal_with("/nodes/2/extras/haptic/served_by", "Brass"),
            "test.gltf: node \"Left\": extras.haptic.served_by is \"Brass\", which is not the name of a real "
            "target");
  EXPECT_EQ(refusal_with("/nodes/2/extras/haptic/served_by", "Left"),
            "test.gltf: node \"Left\": extras.haptic.served_by is \"Left\", which is not the name of a real "
            "target");
  EXPECT_EQ(refusal(document({plate(), virtual_on_the_left()})),
            "test.gltf: node \"Left\": the file has no real target that could serve this virtual one");
  const Json second = node("Second", haptic("real"));
  EXPECT_EQ(refusal(document({plate(), real(), second, virtual_on_the_left()})),
            "test.gltf: node \"Left\": extras.haptic.served_by is missing, and the file has more than one "
            "real target");
  const Json start = node("Start", haptic("start"), {{"translation", {0.0, 0.0, 0.08}}});
  EXPECT_EQ(refusal(document({plate(), start, real()})),
            "test.gltf: node \"Start\": the start lies off the plate, 0.08 m from its centre; the plate's "
            "radius_m is "
            "0.075");
}

TEST(SceneRefusal, RequiredExtensions) {
  EXPECT_EQ(
      refusal_with("/extensionsRequired", {"EXT_mesh_gpu_instancing"}),
      "test.gltf: extensionsRequired names \"EXT_mesh_gpu_instancing\", which may move nodes and is not "
      "understood here");
  EXPECT_EQ(refusal_with("/extensionsRequired", {"KHR_materials_unlit", "AGI_articulations"}),
            "test.gltf: extensionsRequired names \"AGI_articulations\", which may move nodes and is not "
            "understood here");
  EXPECT_EQ(refusal_with("/extensionsRequired", {"KHR_materials_unlit", "KHR_draco_mesh_compression"}), "");
  EXPECT_EQ(refusal_with("/extensionsUsed", {"EXT_mesh_gpu_instancing"}), "");
  EXPECT_EQ(refusal_with("/extensionsRequired", Json::array({1})),
            "test.gltf: extensionsRequired holds something that is not a string");
}

TEST(SceneRefusal, BufferAddresses) {
  const auto refusal_of_uri = [](const std::string& uri) {
    return refusal_with("/buffers", Json::array({Json::object(), {{"byteLength", 4}, {"uri", uri}}}));
  };
  for (const char* uri : {"mesh.bin", "meshes/desk.bin", "data:application/octet-stream;base64,AAAA", "..bin",
                          "console.bin", "a%20b.bin"}) {
    EXPECT_EQ(refusal_of_uri(uri), "") << uri;
  }
  const std::vector<std::pair<const char*, const char*>> refused{
      {"../secret.bin", "climbs out of the file's folder"},
      {"meshes/../../secret.bin", "climbs out of the file's folder"},
      {"%2e%2e/secret.bin", "climbs out of the file's folder"},
      {"..%5Csecret.bin", "climbs out of the file's folder"},
      {"..\\secret.bin", "climbs out of the file's folder"},
      {"meshes/..", "climbs out of the file's folder"},
      {"/dev/zero", "is an absolute path"},
      {"%2Fdev%2Fzero", "is an absolute path"},
      {"\\\\host\\share", "is an absolute path"},
      {"file:///etc/passwd", "is an address or a drive, not a file beside this one"},
      {"https://example.com/a.bin", "is an address or a drive, not a file beside this one"},
      {"C:secret.bin", "is an address or a drive, not a file beside this one"},
      {"NUL", "names a device"},
      {"meshes/con.bin", "names a device"},
      {"com1", "names a device"},
      {"", "is not a file name"},
      {"a%00b", "is not a file name"}};
  for (const auto& [uri, reason] : refused) {
    EXPECT_EQ(refusal_of_uri(uri),
              "test.gltf: buffers[1].uri is \"" + std::string(uri) + "\", which " + reason);
  }
  EXPECT_EQ(refusal_with("/buffers", Json::array({{{"uri", 7}}})),
            "test.gltf: buffers[0].uri is not a string");
}

TEST(SceneRefusal, PathsThatAreNoFile) {
  const auto refusal_of_path = [](const std::filesystem::path& path) -> std::string {
    try {
      load_scene(path);
      return "";
    } catch (const SceneError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal_of_path("no/such.gltf"), "no/such.gltf: no such file");
  EXPECT_EQ(refusal_of_path(testing::TempDir()), testing::TempDir() + ": not a regular file");
#ifdef __linux__
  EXPECT_EQ(refusal_of_path("/dev/zero"), "/dev/zero: not a regular file");
#endif
}

// A line of 100,000 nodes, each the child of the one before; the roles lie at its end.
TEST(SceneRefusal, DeepNodeTree) {
  Json nodes = Json::array();
  for (int i = 0; i < 99'999; ++i) {
    nodes.push_back({{"children", Json::array({i + 1})}});
  }
  nodes.push_back(plate());
  const std::string message = refusal(document(nodes));
  EXPECT_TRUE(message.ends_with("lies deeper than 256 nodes")) << message;
  EXPECT_LT(message.size(), 300u);
  nodes.push_back(Json::object());
  EXPECT_EQ(refusal(document(nodes)), "test.gltf: has more than 100000 nodes");
}

// JSON within JSON, where glTF has no place for it and where it has.
TEST(SceneRefusal, DeepJson) {
  const std::string nested = std::string(100'000, '[') + std::string(100'000, ']');
  for (const char* member : {"nodes", "extras", "images", "unknown"}) {
    EXPECT_EQ(refusal(R"({"asset":{"version":"2.0"},")" + std::string(member) + "\":" + nested + "}"),
              "test.gltf: its JSON is nested deeper than 64 levels");
  }
  EXPECT_EQ(refusal(std::string(100'000, '[')), "test.gltf: its JSON is nested deeper than 64 levels");
  EXPECT_EQ(refusal("{\"a\":" + std::string(100'000, '{')).find("test.gltf: "), 0u);
}

TEST(SceneRefusal, TooMuchOfEverything) {
  std::string zeros = "[0";
  for (int i = 0; i < 1'000'000; ++i) {
    zeros += ",0";
  }
  EXPECT_EQ(refusal(R"({"asset":{"version":"2.0"},"nodes":)" + zeros + "]}"),
            "test.gltf: its JSON has more than 1000000 values");
  EXPECT_EQ(refusal(std::string((std::size_t{64} << 20) + 1, ' ')),
            "test.gltf: its JSON is larger than 67108864 bytes");

  Json nodes = Json::array({plate()});
  for (int i = 0; i < 1000; ++i) {
    nodes.push_back(real());
  }
  EXPECT_EQ(refusal(document(nodes)), "test.gltf: more than 1000 nodes have a haptic role");
}

TEST(SceneRefusal, NamesThatAreNoText) {
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/name", std::string(256, 'x')),
            "test.gltf: node \"Real\": extras.haptic.name has 256 bytes; allowed are 1 to 255");
  EXPECT_EQ(refusal_with("/nodes/1/extras/haptic/name", std::string("a\0b", 3)),
            "test.gltf: node \"Real\": extras.haptic.name is \"a?b\", with a control character in it");
  // Blender lets a node have any name.
  const Scene scene = load(with("/nodes/1/name", "a\nb"));
  EXPECT_EQ(scene.targets[0].name, "a?b");
  EXPECT_EQ(scene.targets[0].node_path, "a?b");
}

// 80 of two bytes each.
TEST(SceneRefusal, LongTextIsCutBetweenCharacters) {
  std::string text;
  for (int i = 0; i < 80; ++i) text += "\u00fc";
  EXPECT_EQ(in_quotes(text), '"' + text + '"');
  EXPECT_EQ(in_quotes(text + "\u00fc"), '"' + text + "...\"");
  EXPECT_EQ(in_quotes("a" + text), "\"a" + text.substr(0, 158) + "...\"");
}

TEST(SceneRefusal, MessagesHoldNoControlCharacters) {
  const std::string message = refusal_with("/nodes/1/extras/haptic/role", "a\nb\x1b[31m\x7f");
  EXPECT_NE(message.find("\"a?b?[31m?\""), std::string::npos) << message;
}

}  // namespace
}  // namespace hrt
