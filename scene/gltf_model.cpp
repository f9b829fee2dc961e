#include "scene/gltf_model.h"

#include <algorithm>

#include "scene/gltf_json.h"
#include "scene/gltf_shape.h"
#include "scene/scene_error.h"

namespace hrt {
namespace {

using nlohmann::json;

constexpr int no_parent = -1;

// What tinygltf gets of a node: what places it, and what it says of itself.
json placed(const json& node) {
  json kept = json::object();
  for (const char* key : {"name", "matrix", "translation", "rotation", "scale", "children", "extras"})
    if (const auto found = node.find(key); found != node.end()) kept[key] = *found;
  return kept;
}

// Of buffers, images, meshes and the like there is nothing to open, to decode or to hold.
std::string what_places_nodes(json document) {
  json kept = json::object();
  for (const char* key : {"asset", "scene", "scenes"})
    if (const auto found = document.find(key); found != document.end()) kept[key] = std::move(*found);
  json& nodes = kept["nodes"] = json::array();
  if (const auto found = document.find("nodes"); found != document.end())
    for (const json& node : *found) nodes.push_back(placed(node));
  return kept.dump(-1, ' ', false, json::error_handler_t::replace);
}

tinygltf::Model model_of(const std::string& text, const std::string& file) {
  tinygltf::TinyGLTF loader;
  // Its own values of extras cut numbers off at 32 bits.
  loader.SetStoreOriginalJSONForExtrasAndExtensions(true);
  tinygltf::Model model;
  std::string error, warning;
  if (!loader.LoadASCIIFromString(&model, &error, &warning, text.c_str(), static_cast<unsigned>(text.size()), "",
                                  tinygltf::REQUIRE_VERSION))
    refuse(file, "not a glTF file: {}", printable(error.substr(0, error.find('\n'))));
  return model;
}

// The parent of each node, or no_parent.
std::vector<int> parents_of(const tinygltf::Model& model, const std::string& file) {
  const auto label = [&](int i) {
    const auto index = static_cast<std::size_t>(i);
    return node_label(model.nodes[index].name, index);
  };
  std::vector<int> parents(model.nodes.size(), no_parent);
  for (int i = 0; i < static_cast<int>(parents.size()); ++i) {
    for (const int child : model.nodes[static_cast<std::size_t>(i)].children) {
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent != no_parent) {
        refuse(file, "{}: children of both {} and {} name it; a node has one parent", label(child), label(parent),
               label(i));
      }
      parent = i;
    }
  }
  return parents;
}

// Every node has at most one parent, so a node not reached from a root is on a cycle or below one.
void check_for_cycles(const tinygltf::Model& model, const std::vector<int>& parents, const std::string& file) {
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < parents.size(); ++i)
    if (parents[i] == no_parent) reached.push_back(i);
  std::vector<bool> is_reached(parents.size(), false);
  for (std::size_t next = 0; next < reached.size(); ++next) {
    is_reached[reached[next]] = true;
    for (const int child : model.nodes[reached[next]].children) reached.push_back(static_cast<std::size_t>(child));
  }
  const auto missed = std::find(is_reached.begin(), is_reached.end(), false);
  if (missed == is_reached.end()) return;
  const auto index = static_cast<std::size_t>(missed - is_reached.begin());
  refuse(file, "{}: children of the nodes below it lead back to it: a cycle",
         node_label(model.nodes[index].name, index));
}

void check_roots(const tinygltf::Scene& scene, std::size_t number, const std::vector<int>& parents,
                 const std::string& file) {
  std::vector<bool> is_root(parents.size(), false);
  for (const int root : scene.nodes) {
    const auto index = static_cast<std::size_t>(root);
    if (parents[index] != no_parent)
      refuse(file, "scenes[{}].nodes holds {}, which is not a root but the child of another node", number, root);
    if (is_root[index]) refuse(file, "scenes[{}].nodes holds {} twice", number, root);
    is_root[index] = true;
  }
}

}  // namespace

GltfModel read_model(std::string_view text, const std::string& file) {
  json document = read_json(text, file);
  check_shape(document, file);
  tinygltf::Model model = model_of(what_places_nodes(std::move(document)), file);
  const std::vector<int> parents = parents_of(model, file);
  check_for_cycles(model, parents, file);
  for (std::size_t i = 0; i < model.scenes.size(); ++i) check_roots(model.scenes[i], i, parents, file);
  std::vector<int> roots = model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
  return {std::move(model), std::move(roots)};
}

}  // namespace hrt
