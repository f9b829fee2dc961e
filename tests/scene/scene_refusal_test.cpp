// Files that are not usable scenes: each is refused with one line that names the file, the node and the
// property.
#include <gtest/gtest.h>

#include "tests/scene/scene_document.h"

namespace hrt {
namespace {

Json good() { return document({plate(), real(), virtual_on_the_left()}); }

// good() with one change.
Json with(const char* pointer, Json value) {
  Json file = good();
  file[Json::json_pointer(pointer)] = std::move(value);
  return file;
}

std::string refusal_with(const char* pointer, Json value) { return refusal(with(pointer, std::move(value))); }

// `message` follows the file's name.
void refused(const auto& file, const std::string& message) { EXPECT_EQ(refusal(file), "test.gltf: " + message); }

void refused(const char* pointer, Json value, const std::string& message) {
  refused(with(pointer, std::move(value)), message);
}

TEST(SceneRefusal, GoodFileIsNotRefused) { EXPECT_EQ(refusal(good()), ""); }

TEST(SceneRefusal, NotGltf) {
  for (const char* text :
       {"", "hello", "{", "[]", "1", "null", "\"glTF\"", "{}", "{\"asset\":{}}", "{\"asset\":{\"version\":2.0}}",
        "\x89PNG\r\n\x1a\n", "{\"asset\":{\"version\":\"2.0\"}}NaN", "{\"asset\":{\"version\":\"\xff\"}}"}) {
    SCOPED_TRACE(text);
    EXPECT_TRUE(refusal(text).starts_with("test.gltf: not a glTF file: ")) << refusal(text);
  }
  refused("/asset/version", "1.0", R"(asset.version is "1.0"; glTF 2 is read)");
  refused("/asset/minVersion", "2.1", R"(asset.minVersion is "2.1"; glTF 2.0 is read)");
  refused("/nodes", Json::object(), "nodes is not an array of objects");
  refused("/nodes/0", 7, "nodes is not an array of objects");
  refused("/scenes", Json::array({7}), "scenes is not an array of objects");
  refused("/scene", 1, R"(scene is "1", and there are 1 scenes)");
  refused("/scene", -1, R"(scene is "-1", and there are 1 scenes)");
  refused("/scene", "0", R"(scene is ""0"", and there are 1 scenes)");
}

TEST(SceneRefusal, CutShortAtEveryByte) {
  for (const std::string& bytes : {good().dump(), glb(good(), "abcd")}) {
    ASSERT_EQ(refusal(bytes), "");
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_NE(refusal(bytes.substr(0, size)), "") << "at byte " << size;
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
  refused("glTF", "the binary glTF header is cut short");
}

TEST(SceneRefusal, NodeGraph) {
  refused("/nodes/0/children", {1, 2}, "scenes[0].nodes holds 1, which is not a root but the child of another node");
  refused("/nodes/0/children", {3}, R"(node "Plate": children holds 3, and there are 3 nodes)");
  refused("/nodes/0/children", {-1}, R"(node "Plate": children holds "-1", which is not an index)");
  refused("/nodes/0/children", {1.0}, R"(node "Plate": children holds "1.0", which is not an index)");
  refused("/nodes/0/children", 1, R"(node "Plate": children is not an array)");
  refused("/scenes/0/nodes", {0, 3}, "scenes[0].nodes holds 3, and there are 3 nodes");
  refused("/scenes/0/nodes", {0, 0}, "scenes[0].nodes holds 0 twice");

  Json two_parents = good();
  two_parents["nodes"][0]["children"] = {2};
  two_parents["nodes"][1]["children"] = {2};
  refused(two_parents, R"(node "Left": children of both node "Plate" and node "Real" name it; a node has one parent)");
  two_parents["nodes"][1]["children"] = Json::array();
  two_parents["nodes"][0]["children"] = {2, 2};
  refused(two_parents, R"(node "Left": children of both node "Plate" and node "Plate" name it; a node has one parent)");

  refused("/nodes/2/children", {2}, R"(node "Left": children of the nodes below it lead back to it: a cycle)");
  Json cycle = good();
  cycle["nodes"][1]["children"] = {2};
  cycle["nodes"][2]["children"] = {1};
  refused(cycle, R"(node "Real": children of the nodes below it lead back to it: a cycle)");
}

TEST(SceneRefusal, Transforms) {
  refused("/nodes/1/translation", {0, 0}, R"(node "Real": translation is not an array of 3 numbers)");
  refused("/nodes/1/translation", {0, 0, "NaN"}, R"(node "Real": translation is not an array of 3 numbers)");
  refused("/nodes/1/translation", {0, 0, 1e300}, R"(node "Real": it is further than 1000 m from the world's origin)");
  refused(document({plate({{"translation", {900.0, 0.0, 0.0}}}), real({{"translation", {-900.0, 0.0, 0.0}}})}),
          R"(node "Real": it is further than 1000 m from the plate)");
  refused("/nodes/1/rotation", {0, 0, 0, 0}, R"(node "Real": rotation is not a quaternion of unit length)");
  refused("/nodes/1/rotation", {1e200, 0, 0, 0}, R"(node "Real": rotation is not a quaternion of unit length)");
  refused("/nodes/1/scale", 2, R"(node "Real": scale is not an array of 3 numbers)");
  refused("/nodes/1/matrix", Json::array({1, 0, 0}), R"(node "Real": matrix is not an array of 16 numbers)");
  const Json identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  refused("/nodes/1/matrix", identity,
          R"(node "Real": matrix is given beside translation, rotation or scale; glTF allows one form)");
  Json projective = identity;
  projective[3] = 0.5;
  refused("/nodes/0/matrix", projective, R"(node "Plate": matrix has a fourth row other than 0 0 0 1)");

  refused("/nodes/0/scale", {1, 0, 1}, R"(node "Plate": its scale has a zero-length axis or flattens space)");
  Json flat = identity;
  flat[8] = 1;  // +Z is made the same as +X
  flat[10] = 0;
  refused("/nodes/0/matrix", flat, R"(node "Plate": its matrix has a zero-length axis or flattens space)");
  refused(document({node("Group", {}, {{"scale", {0, 0, 0}}, {"children", {1}}}), plate()}),
          R"(node "Group": its scale has a zero-length axis or flattens space, and "Group/Plate" is below it)");

  // JSON has no NaN and no infinity; a number that overflows would be one.
  for (const char* number : {"NaN", "-Infinity", "1e999", "-1e999"}) {
    std::string text = good().dump();
    text.replace(text.find("-0.05"), 5, number);
    EXPECT_TRUE(refusal(text).starts_with("test.gltf: not a glTF file: ")) << refusal(text);
  }
}

TEST(SceneRefusal, Roles) {
  refused(document({node("Cube", {}), node("Light", {{"haptics", 1}})}),
          "no node has a haptic role (extras.haptic.role, or extras.haptic_role)");
  refused(document({real(), virtual_on_the_left()}), R"(no node has extras.haptic.role "plate")");
  refused(document({plate(), node("Second", haptic("plate", {{"radius_m", 1}}))}),
          R"(node "Second": extras.haptic.role is the same as that of "Plate", and there may be one only)");
  refused(document({plate(), node("A", haptic("start")), node("B", haptic("start"))}),
          R"(node "B": extras.haptic.role is the same as that of "A", and there may be one only)");
  refused("/nodes/1/extras/haptic/role", "Real",
          R"(node "Real": extras.haptic.role is "Real"; allowed are "plate", "real", "virtual" and "start")");
  refused("/nodes/1/extras/haptic/role", 3, R"(node "Real": extras.haptic.role is not a string)");
  refused("/nodes/1/extras", {{"haptic_role", Json()}}, R"(node "Real": extras.haptic_role is not a string)");
  refused("/nodes/1/extras", {{"haptic_name", "brass"}},
          R"(node "Real": extras.haptic_role is missing, beside extras.haptic_name)");
  refused("/nodes/1/extras/haptic", {{"name", "brass"}},
          R"(node "Real": extras.haptic.role is missing, beside extras.haptic.name)");
  for (const Json& not_an_object : {Json(), Json::object(), Json("real"), Json::array({"role", "real"})}) {
    refused("/nodes/1/extras/haptic", not_an_object, R"(node "Real": extras.haptic is not an object with a role)");
  }
  refused("/nodes/1/extras/haptic_radius_m", 1,
          R"(node "Real": both extras.haptic and extras.haptic_radius_m are given; keep one form)");
}

TEST(SceneRefusal, Properties) {
  Json file = good();
  file["nodes"][0]["extras"]["haptic"].erase("radius_m");
  refused(file, R"(node "Plate": extras.haptic.radius_m is missing: a plate needs its radius in metres)");
  refused("/nodes/0/extras/haptic/radius_m", 0, R"(node "Plate": extras.haptic.radius_m is 0; allowed is 0.001 to 10)");
  refused("/nodes/0/extras/haptic/radius_m", -0.075,
          R"(node "Plate": extras.haptic.radius_m is -0.075; allowed is 0.001 to 10)");
  // 2^32 + 1, of which 32 bits are 1.
  refused("/nodes/0/extras/haptic/radius_m", 4294967297,
          R"(node "Plate": extras.haptic.radius_m is 4.29497e+09; allowed is 0.001 to 10)");
  refused("/nodes/0/extras/haptic/radius_m", 1e-300,
          R"(node "Plate": extras.haptic.radius_m is 1e-300; allowed is 0.001 to 10)");
  EXPECT_EQ(refusal_with("/nodes/0/extras/haptic/radius_m", 0.001), "");
  refused("/nodes/0/extras/haptic/radius_m", "0.075", R"(node "Plate": extras.haptic.radius_m is not a number)");
  refused("/nodes/0/extras/haptic/radius_m", true, R"(node "Plate": extras.haptic.radius_m is not a number)");
  refused("/nodes/0/extras/haptic/max_speed_deg_s", 1e6,
          R"(node "Plate": extras.haptic.max_speed_deg_s is 1e+06; allowed is 0.001 to 100000)");
  refused("/nodes/1/extras/haptic/radius", 0.01,
          R"(node "Real": extras.haptic.radius is not a property of this role; allowed are role, name, radius_m)");
  refused("/nodes/1/extras/haptic/served_by", "Left",
          R"(node "Real": extras.haptic.served_by is not a property of this role; allowed are role, name, radius_m)");
  refused("/nodes/1/extras/haptic/ra\rdius", 0.01,
          R"(node "Real": extras.haptic.ra?dius is not a property of this role; allowed are role, name, radius_m)");
  EXPECT_EQ(refusal_with(("/nodes/1/extras/haptic/" + std::string(3000, 'r')).c_str(), 0.01),
            "test.gltf: node \"Real\": extras.haptic." + std::string(80, 'r') +
                "... is not a property of this role; allowed are role, name, radius_m");
  refused("/nodes/1/extras/haptic/name", "", R"(node "Real": extras.haptic.name has 0 bytes; allowed are 1 to 255)");
  refused("/nodes/1/name", 5, "node [1]: name is not a string of at most 255 bytes");
  EXPECT_EQ(refusal_with("/nodes/1/name", std::string(256, 'x')),
            "test.gltf: node \"" + std::string(80, 'x') + "...\": name is not a string of at most 255 bytes");
}

TEST(SceneRefusal, Targets) {
  refused(
      "/nodes/2/name", "Real",
      R"(node "Real": its name "Real" is also that of "Real"; targets need names of their own (extras.haptic.name))");
  refused("/nodes/1/translation", {0.0, 0.3, 0.05},
          R"(node "Real": the target lies at the start point, so it has no direction)");
  refused("/nodes/2/extras/haptic/served_by", "Brass",
          R"(node "Left": extras.haptic.served_by is "Brass", which is not the name of a real target)");
  refused("/nodes/2/extras/haptic/served_by", "Left",
          R"(node "Left": extras.haptic.served_by is "Left", which is not the name of a real target)");
  refused(document({plate(), virtual_on_the_left()}),
          R"(node "Left": the file has no real target that could serve this virtual one)");
  const Json start = node("Start", haptic("start"), {{"translation", {0.0, 0.0, 0.08}}});
  refused(document({plate(), start, real()}),
          R"(node "Start": the start lies off the plate, 0.08 m from its centre; the plate's radius_m is 0.075)");
}

TEST(SceneRefusal, RequiredExtensions) {
  refused("/extensionsRequired", {"EXT_mesh_gpu_instancing"},
          R"(extensionsRequired names "EXT_mesh_gpu_instancing", which may move nodes and is not understood here)");
  refused("/extensionsRequired", {"KHR_materials_unlit", "AGI_articulations"},
          R"(extensionsRequired names "AGI_articulations", which may move nodes and is not understood here)");
  EXPECT_EQ(refusal_with("/extensionsRequired", {"KHR_materials_unlit", "KHR_draco_mesh_compression"}), "");
  EXPECT_EQ(refusal_with("/extensionsUsed", {"EXT_mesh_gpu_instancing"}), "");
  refused("/extensionsRequired", Json::array({1}), "extensionsRequired holds something that is not a string");
}

class Addresses : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(SceneRefusal, Addresses, testing::Values("buffers", "images"));

TEST_P(Addresses, OutsideTheFolderAreRefused) {
  const auto refusal_of_uri = [](const std::string& uri) {
    return refusal_with(("/" + GetParam()).c_str(), Json::array({Json::object(), {{"uri", uri}}}));
  };
  for (const char* uri : {"mesh.bin", "meshes/desk.bin", "data:application/octet-stream;base64,AAAA", "..bin",
                          "console.bin", "a%20b.bin"}) {
    EXPECT_EQ(refusal_of_uri(uri), "") << uri;
  }
  const std::vector<std::pair<const char*, const char*>> bad{
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
  for (const auto& [uri, reason] : bad) {
    EXPECT_EQ(refusal_of_uri(uri),
              "test.gltf: " + GetParam() + "[1].uri is \"" + std::string(uri) + "\", which " + reason);
  }
  refused(("/" + GetParam()).c_str(), Json::array({{{"uri", 7}}}), GetParam() + "[0].uri is not a string");
}

// Of two values for one key, readers take one or the other.
TEST(SceneRefusal, KeysThatAreThereTwice) {
  const auto with_member = [](const std::string& before, const std::string& member) {
    std::string text = good().dump();
    return text.insert(text.find(before), member + ",");
  };
  refused(with_member("\"nodes\":[{", "\"nodes\":[]"), R"(its JSON has the key "nodes" twice)");
  refused(with_member("\"radius_m\"", "\"radius_m\":1"), R"("nodes[0].extras.haptic" has the key "radius_m" twice)");
  refused(with_member("\"translation\"", "\"translation\":7"), R"("nodes[1]" has the key "translation" twice)");
  refused(with_member("\"asset\"", R"("meshes":[{"a":[[{"b":1,"a\u0000":{},"\u0062":2}]]}])"),
          R"("meshes[0].a[0][0]" has the key "b" twice)");
  EXPECT_EQ(refusal(with_member("\"asset\"", R"("meshes":[{"b":{"b":1}},{"b":1}])")), "");
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
  refused(document(nodes), "has more than 100000 nodes");
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
  refused(R"({"asset":{"version":"2.0"},"nodes":)" + zeros + "]}", "its JSON has more than 1000000 values");
  refused(std::string((std::size_t{64} << 20) + 1, ' '), "its JSON is larger than 67108864 bytes");

  Json nodes = Json::array({plate()});
  for (int i = 0; i < 1000; ++i) {
    nodes.push_back(real());
  }
  refused(document(nodes), "more than 1000 nodes have a haptic role");
}

TEST(SceneRefusal, NamesThatAreNoText) {
  refused("/nodes/1/extras/haptic/name", std::string(256, 'x'),
          R"(node "Real": extras.haptic.name has 256 bytes; allowed are 1 to 255)");
  refused("/nodes/1/extras/haptic/name", std::string("a\0b", 3),
          R"(node "Real": extras.haptic.name is "a?b", with a control character in it)");
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

// The parser quotes what it read last: here, all of the file.
TEST(SceneRefusal, AnErrorAfterManyLinesIsOneShortLine) {
  const std::string message = refusal(std::string(5000, '\n') + "'");
  EXPECT_LT(message.size(), 200u) << message;
  EXPECT_NE(message.find("line 5001"), message.npos) << message;
}

}  // namespace
}  // namespace hrt
