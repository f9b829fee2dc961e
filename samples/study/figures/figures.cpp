#include "samples/study/figures/figures.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"
#include "samples/study/figures_script.h"

namespace hrt::study {
namespace {

namespace fs = std::filesystem;

std::string quoted(std::string path) {
  for (std::size_t at = 0; (at = path.find('\'', at)) != std::string::npos; at += 4) path.replace(at, 1, "'\\''");
  return "'" + path + "'";
}

}  // namespace

StagingFolder::StagingFolder(const std::string& argument, const std::string& out)
    : out_(out), was_made_(!fs::exists(out)) {
  if (std::system("/usr/bin/python3 -c 'import matplotlib' >/dev/null 2>&1") != 0)
    throw std::runtime_error(
        "/usr/bin/python3 has no matplotlib, which draws the figures; on Debian: apt-get install python3-matplotlib");
  std::error_code error;
  fs::create_directories(out_, error);
  folder_ = out_ / fmt::format(".hrt-study.{}.tmp", getpid());
  if (!error) fs::create_directory(folder_, error);
  if (error) throw UsageError(not_allowed(argument, out, "a folder that can be written (" + error.message() + ")"));
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  if (was_made_) fs::remove(out_, ignored);  // fails if the folder is not empty
}

void StagingFolder::draw(const std::vector<Figure>& figures) {
  Row list = Row::array();
  for (const Figure& figure : figures)
    list.push_back({{"name", figure.name}, {"title", figure.title}, {"data", figure.data}});
  replace_file(folder_ / "figures.json", list.dump());
  replace_file(folder_ / "figures.py", figures_script);
  if (std::system(("cd " + quoted(folder_) + " && /usr/bin/python3 figures.py >errors 2>&1").c_str()) != 0) {
    std::string line = "figures.py failed:";
    std::istringstream words(read("errors"));
    for (std::string word; words >> word;) line += " " + word;
    throw std::runtime_error(line);
  }
  for (const Figure& figure : figures) files_.push_back(figure.name + ".svg");
}

void StagingFolder::write(const std::string& name, std::string_view content) {
  replace_file(folder_ / name, content);
  files_.push_back(name);
}

std::string StagingFolder::read(const std::string& name) const {
  std::ifstream file(folder_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void StagingFolder::publish() const {
  for (const std::string& name : files_) fs::rename(folder_ / name, out_ / name);
}

std::string draw_beside(const std::string& argument, const std::string& path, const Figure& figure) {
  StagingFolder staged(argument, fs::absolute(path).parent_path().string());
  staged.draw({figure});
  return staged.read(figure.name + ".svg");
}

std::string html_page(const std::string& text, const std::vector<Figure>& figures) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<title>Haptic retargeting by touch: the paper and the model</title>\n<style>\n"
      "body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem; "
      "color: #111; }\npre { overflow-x: auto; font-size: .8rem; line-height: 1.3; }\n"
      "img { max-width: 100%; height: auto; }\nfigure { margin: 1.5rem 0; border-top: 1px solid #ccc; }\n"
      "</style>\n</head>\n<body>\n<h1>Haptic retargeting by touch: the paper and the model</h1>\n"
      "<p><b>Everything on this page is simulation, the paper's numbers too. There was no human trial.</b> "
      "Directions are in degrees from the plate's mid-line, counter-clockwise positive seen from "
      "above.</p>\n<pre>" +
      escaped(text) + "</pre>\n";
  for (const Figure& figure : figures)
    page += "<figure><img src=\"" + figure.name + ".svg\" alt=\"" + escaped(figure.title) + "\"><figcaption><b>" +
            escaped(figure.title) + ".</b> " + escaped(figure.caption) + " Simulation.</figcaption></figure>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace hrt::study
