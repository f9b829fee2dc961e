#include <gtest/gtest.h>

#include "tests/scene/scene_document.h"

namespace hrt {
namespace {

Json good() { return document({plate(), real(), virtual_on_the_left(), node("Lamp", {})}); }

std::string with(const std::string& pointer, const std::string& json) {
  Json file = good();
  file[Json::json_pointer(pointer)] = Json::parse(json);
  return file.dump();
}

void expect_refused(const std::string& file, const std::string& part) {
  const std::string message = refusal(file);
  EXPECT_TRUE(message.starts_with("test.gltf: ") && message.find(part) != message.npos)
      << message << "\nwithout " << part;
  EXPECT_LT(message.size(), 600u) << message;
}

struct Change {
  const char* pointer;
  const char* json;
  const char* part_of_error = "";
};

constexpr Change refused[] = {
    {"/asset", "{}", "not a glTF file"},
    {"/asset/version", R"("1.0")", "asset.version is \"1.0\""},
    {"/asset/minVersion", R"("2.1")", "asset.minVersion is \"2.1\""},
    {"/nodes/0", "7", "not a glTF file"},
    {"/scenes/0", "7", "not a glTF file"},
    {"/scene", "1", "scene is 1; allowed: below 1"},
    {"/scenes", "[]", "the file has no scene"},
    {"/extensionsRequired", R"(["KHR_materials_unlit","AGI_articulations"])", "\"AGI_articulations\""},
    {"/extensionsRequired", "[1]", "extensionsRequired has \"\""},

    {"/scenes/0/nodes", "[0,4]", "node 4"},
    {"/scenes/0/nodes", "[0,0]", "node \"Plate\": "},
    {"/nodes/0/children", "[4]", "node 4"},
    {"/nodes/0/children", "[-1]", "node -1"},
    {"/nodes/0/children", "[2]", "node \"Left\": "},
    {"/nodes/2/children", "[2]", "node \"Left/Left\": "},

    {"/nodes/1/translation", "[0,0]", "node \"Real\": translation"},
    {"/nodes/1/translation", "[0,0,\"1\"]", "node \"Real\": translation"},
    {"/nodes/1/translation", "[0,0,1e300]", "node \"Real\": "},
    {"/nodes/1/rotation", "[0,0,0]", "node \"Real\": rotation"},
    {"/nodes/1/rotation", "[0,0,0,0]", "node \"Real\": rotation"},
    {"/nodes/1/rotation", "[1e200,0,0,0]", "node \"Real\": rotation"},
    {"/nodes/1/scale", "[1,1]", "node \"Real\": scale"},
    {"/nodes/1/scale", "[1,0,1]", "node \"Real\": scale"},
    {"/nodes/1/matrix", "[1,0,0]", "node \"Real\": matrix"},
    {"/nodes/1/matrix", "[1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1]", "node \"Real\": matrix"},
    {"/nodes/1/matrix", "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,0.9999999]", "node \"Real\": matrix"},
    {"/nodes/1/matrix", "[1,0,0,0,0,1,0,0,1,0,0,0,0,0,0,1]", "node \"Real\": matrix"},

    {"/nodes/0/extras", "{}", "role \"plate\""},
    {"/nodes/1/extras/haptic", R"({"role":"plate","radius_m":1})", "node \"Real\": the haptic role is"},
    {"/nodes/1/extras/haptic/role", R"("Real")", "node \"Real\": extras.haptic.role is \"Real\""},
    {"/nodes/1/extras/haptic/role", "3", "node \"Real\": extras.haptic.role"},
    {"/nodes/1/extras", R"({"haptic_role":[1]})", "node \"Real\": extras.haptic_role"},
    {"/nodes/1/extras", R"({"haptic_name":"brass"})", "node \"Real\": extras.haptic_role"},
    {"/nodes/1/extras/haptic", R"({"name":"brass"})", "node \"Real\": extras.haptic.role"},
    {"/nodes/1/extras/haptic", R"("real")", "node \"Real\": extras.haptic"},
    {"/nodes/1/extras/haptic_radius_m", "1", "node \"Real\": both extras.haptic and extras.haptic_radius_m"},
    {"/nodes/0/extras/haptic", R"({"role":"plate"})", "node \"Plate\": extras.haptic.radius_m"},
    {"/nodes/0/extras/haptic/radius_m", "0", "node \"Plate\": extras.haptic.radius_m is 0"},
    {"/nodes/0/extras/haptic/radius_m", "-0.075", "node \"Plate\": extras.haptic.radius_m is -0.075"},
    {"/nodes/0/extras/haptic/radius_m", "1e300", "node \"Plate\": extras.haptic.radius_m is 1e+300"},
    {"/nodes/0/extras/haptic/radius_m", R"("0.075")", "node \"Plate\": extras.haptic.radius_m"},
    {"/nodes/0/extras/haptic/radius_m", "true", "node \"Plate\": extras.haptic.radius_m"},
    {"/nodes/0/extras/haptic/max_speed_deg_s", "1e6", "node \"Plate\": extras.haptic.max_speed_deg_s is 1e+06"},
    {"/nodes/1/extras/haptic/radius", "0.01", "node \"Real\": extras.haptic.radius"},
    {"/nodes/1/extras/haptic/served_by", R"("Left")", "node \"Real\": extras.haptic.served_by"},
    {"/nodes/1/extras/haptic/ra\rdius", "0.01", "node \"Real\": extras.haptic.ra?dius"},
    {"/nodes/1/extras/haptic/name", R"("")", "node \"Real\": extras.haptic.name"},
    {"/nodes/1/extras/haptic/name", R"("a\u0000b")", "node \"Real\": extras.haptic.name is \"a?b\""},
    {"/nodes/1/extras/haptic/name", R"("Left")", "node \"Left\": "},
    {"/nodes/2/extras/haptic/served_by", R"("Lamp")", "node \"Left\": the haptic property served_by is \"Lamp\""},
    {"/nodes/2/extras/haptic/served_by", R"("Left")", "node \"Left\": the haptic property served_by is \"Left\""},
    {"/nodes/1/extras/haptic/role", R"("virtual")", "node \"Real\": "},
    {"/nodes/1/translation", "[0,0.1,0.05]", "node \"Real\": "},
    {"/nodes/2/extras/haptic/role", R"("start")", "node \"Left\": "},
};

// Changes of a node without a role, of the plate's radius, of skipped sections, and of the required extensions.
constexpr Change accepted[] = {
    {"/nodes/3/rotation", "[0,0,0,2]"},
    {"/nodes/3/scale", "[0,0,0]"},
    {"/nodes/3/translation", "[1e9,0,0]"},
    {"/nodes/3/matrix", "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,0.9999999]"},
    {"/nodes/3/matrix", "[1,2,3]"},
    {"/nodes/3/extras", R"([{"haptic":1},null,1e9,"text"])"},
    {"/nodes/3/extras", R"({"haptics":1,"id":12345678901234567890})"},
    {"/nodes/0/extras/haptic/radius_m", "0.001"},
    {"/buffers",
     R"([{"uri":"../elsewhere.bin","byteLength":1000},{"uri":"data:,%%%","byteLength":5},{"byteLength":0}])"},
    {"/bufferViews", R"([{"buffer":7,"byteOffset":4000000000,"byteLength":1}])"},
    {"/images", R"([{},{"bufferView":9},{"uri":"data:image/png;base64,AAAA"},{"uri":"https://example.com/a.png"}])"},
    {"/meshes", R"([7])"},
    {"/extensionsUsed", R"(["AGI_articulations"])"},
    {"/extensionsRequired", R"(["KHR_materials_unlit","KHR_draco_mesh_compression","KHR_mesh_quantization"])"},
    {"/extensionsRequired", R"(["KHR_meshopt_compression","EXT_meshopt_compression","MSFT_texture_dds"])"},
    {"/extensionsRequired", R"(["EXT_mesh_features","EXT_structural_metadata","EXT_mesh_gpu_instancing"])"},
    {"/extensionsRequired", R"(["KHR_node_visibility","KHR_animation_pointer"])"},
};

TEST(SceneRefusal, NamesTheNodeAndTheField) {
  for (const Change& change : refused) {
    SCOPED_TRACE(change.pointer + std::string(" ") + change.json);
    expect_refused(with(change.pointer, change.json), change.part_of_error);
  }
}

TEST(SceneRefusal, NodesWithoutARoleMayHaveAnyTransform) {
  EXPECT_EQ(refusal(good()), "");
  for (const Change& change : accepted) EXPECT_EQ(refusal(with(change.pointer, change.json)), "") << change.pointer;
  expect_refused(document({node("Group", {}, {{"rotation", {0, 0, 0, 2}}, {"children", {1}}}), plate()}).dump(),
                 "node \"Group\": rotation");
  expect_refused(document({node("Group", {}, {{"scale", {0, 0, 0}}, {"children", {1}}}), plate()}).dump(),
                 "node \"Group\": scale");
}

TEST(SceneRefusal, SkippedSectionsMayBeginOnTheNextLine) {
  std::string text = good().dump();
  EXPECT_EQ(refusal(text.insert(1, "\"meshes\":\n[\n7],")), "");
}

TEST(SceneRefusal, RejectsInstancingOfAHapticNode) {
  const std::string instances = R"({"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}})";
  Json file = Json::parse(with("/nodes/3/extensions", instances));
  file["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  EXPECT_EQ(refusal(file), "");
  file = Json::parse(with("/nodes/1/extensions", instances));
  EXPECT_EQ(refusal(file), "") << "the extension is not required";
  file["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  expect_refused(file.dump(), "node \"Real\": EXT_mesh_gpu_instancing");
}

TEST(SceneRefusal, RejectsTextsThatAreNotGltf) {
  for (const char* text : {"",
                           "hello",
                           "{",
                           "[]",
                           "1",
                           "null",
                           "\"glTF\"",
                           "{}",
                           "\"",
                           "\"\\",
                           "{\"a\":",
                           "{\"a\":,}",
                           "]}",
                           ":,:,",
                           "{\"asset\":{\"version\":2.0}}",
                           "\x89PNG\r\n\x1a\n",
                           "{\"asset\":{\"version\":\"2.0\"}}NaN",
                           "{\"asset\":{\"version\":\"\xff\"}}",
                           "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[}",
                           "{\"meshes\":,\"a\":1}"})
    expect_refused(text, "not a glTF file: ");
  // JSON has no NaN and no infinity, and numbers that overflow are rejected.
  for (const char* number : {"NaN", "-Infinity", "1e999", "-1e999"}) {
    std::string text = good().dump();
    expect_refused(text.replace(text.find("-0.05"), 5, number), "not a glTF file: ");
  }
  // The parser quotes the last text that it read, here the whole file.
  expect_refused(std::string(5000, '\n') + "'", "line 5001");
}

TEST(SceneRefusal, RejectsFilesTruncatedAtAnyByte) {
  for (const std::string& bytes : {good().dump(), glb(good(), "abcd")}) {
    ASSERT_EQ(refusal(bytes), "");
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_NE(refusal(bytes.substr(0, size)), "") << "at byte " << size;
  }
}

TEST(SceneRefusal, RejectsInvalidBinaryHeaders) {
  const std::string binary = glb(good());
  const auto with_word = [&](std::size_t at, std::size_t value) {
    return std::string(binary).replace(at, 4, little_endian(value));
  };
  expect_refused(with_word(4, 1), "version 1");
  expect_refused(with_word(8, 0x80000000u), "2147483648");
  expect_refused(with_word(12, 0x7fffffffu), "2147483647");
  expect_refused(with_word(16, 0), "JSON");
  expect_refused("glTF", "header");
}

TEST(SceneRefusal, RejectsMissingAndRepeatedRoles) {
  expect_refused(document(Json::array({node("Cube", {})})).dump(), "extras.haptic.role");
  expect_refused(document({plate(), node("A", haptic("start")), node("B", haptic("start"))}).dump(),
                 "node \"B\": the haptic role is the same as that of \"A\"");
  expect_refused(document({plate({{"translation", {900, 0, 0}}}), real({{"translation", {-900, 0, 0}}})}).dump(),
                 "node \"Real\": ");
}

// If a key is repeated, parsers differ in which of the values they use.
TEST(SceneRefusal, RejectsRepeatedKeys) {
  const auto with_member = [](const std::string& before, const std::string& member) {
    std::string text = good().dump();
    return text.insert(text.find(before), member + ",");
  };
  expect_refused(with_member("\"nodes\":[{", "\"nodes\":[]"), "\"nodes\"");
  expect_refused(with_member("\"radius_m\"", "\"radius_m\":1"), "\"radius_m\"");
  expect_refused(with_member("\"translation\"", "\"translation\":7"), "\"translation\"");
  EXPECT_EQ(refusal(with_member("\"asset\"", R"("meshes":[{"b":{"b":1}},{"b":1}])")), "");
}

TEST(SceneRefusal, RejectsPathsThatAreNotRegularFiles) {
  const auto refusal_of_path = [](const std::filesystem::path& path) -> std::string {
    try {
      load_scene(path);
      return "";
    } catch (const SceneError& error) {
      return error.what();
    }
  };
  EXPECT_TRUE(refusal_of_path("no/such.gltf").starts_with("no/such.gltf: "));
  EXPECT_TRUE(refusal_of_path(testing::TempDir()).starts_with(testing::TempDir() + ": "));
#ifdef __linux__
  EXPECT_TRUE(refusal_of_path("/dev/zero").starts_with("/dev/zero: "));
#endif
}

TEST(SceneRefusal, RejectsTooDeepNodesAndJson) {
  Json nodes = Json::array();
  for (int i = 0; i < 99'999; ++i) nodes.push_back({{"children", Json::array({i + 1})}});
  nodes.push_back(plate());
  expect_refused(document(nodes).dump(), "up to 256");
  nodes.push_back(Json::object());
  expect_refused(document(nodes).dump(), "up to 100000");

  const std::string nested = std::string(100'000, '[') + std::string(100'000, ']');
  for (const char* member : {"nodes", "extras", "images", "unknown"})
    expect_refused(R"({"asset":{"version":"2.0"},")" + std::string(member) + "\":" + nested + "}", "up to 64");
  expect_refused(std::string(100'000, '['), "up to 64");
  expect_refused("{\"a\":" + std::string(100'000, '{'), "up to 64");
}

TEST(SceneRefusal, RejectsFilesBeyondEachLimit) {
  std::string zeros = "[0";
  for (int i = 0; i < 1'000'000; ++i) zeros += ",0";
  const auto file = [&](const std::string& section) {
    return R"({"asset":{"version":"2.0"},")" + section + "\":" + zeros + "]}";
  };
  expect_refused(file("nodes"), "up to 1000000");
  expect_refused(file("accessors"), "the file has no scene");
  expect_refused(std::string((std::size_t{64} << 20) + 1, ' '), "up to 67108864");

  Json nodes = Json::array({plate()});
  for (int i = 0; i < 1000; ++i) nodes.push_back(real());
  for (std::size_t i = 1; i <= 1000; ++i) nodes[i]["name"] = std::to_string(i);
  expect_refused(document(nodes).dump(), "up to 1000");
}

TEST(SceneRefusal, RejectsLongAndUnprintableNames) {
  const std::string long_name = "\"" + std::string(256, 'x') + "\"";
  expect_refused(with("/nodes/1/extras/haptic/name", long_name), "extras.haptic.name");
  expect_refused(with("/nodes/1/name", long_name), "name is too long; allowed: up to 255");
  EXPECT_EQ(refusal(with("/nodes/3/name", long_name)), "");
  expect_refused(with("/nodes/1/extras/haptic/" + std::string(3000, 'r'), "1"), std::string(80, 'r') + "... is not");
  expect_refused(with("/nodes/1/extras/haptic/role", R"("a\nb\u001b[31m\u007f")"), "\"a?b?[31m?\"");
  // Blender allows any name of a node.
  const Scene scene = load(with("/nodes/1/name", R"("a\nb")"));
  EXPECT_EQ(scene.targets[0].name, "a?b");
  EXPECT_EQ(scene.targets[0].node_path, "a?b");
}

TEST(SceneRefusal, LongTextIsTruncatedBetweenCharacters) {
  std::string text;
  for (int i = 0; i < 80; ++i) text += "\u00fc";
  EXPECT_EQ(in_quotes(text), '"' + text + '"');
  EXPECT_EQ(in_quotes(text + "\u00fc"), '"' + text + "...\"");
  EXPECT_EQ(in_quotes("a" + text), "\"a" + text.substr(0, 158) + "...\"");
}

}  // namespace
}  // namespace hrt
