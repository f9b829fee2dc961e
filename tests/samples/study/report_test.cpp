#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

const std::vector<std::string> figures{"authority", "fig4", "fig5",     "fig6",
                                       "fig7",      "fig8", "frontier", "table1"};

std::vector<std::string> all_files() {
  std::vector<std::string> files{"report.html"};
  for (const std::string& figure : figures) files.insert(files.end(), {figure + ".png", figure + ".svg"});
  std::sort(files.begin(), files.end());
  return files;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

// Big-endian width and height of a PNG's header.
std::pair<unsigned, unsigned> png_size(const std::string& png) {
  const auto word = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png.at(at + i));
    return value;
  };
  return {word(16), word(20)};
}

TEST(StudyReport, MakesEveryFileAndAPageThatNeedsNothingElse) {
  const TemporaryFolder folder;
  const StudyRun run = run_study({"report", "--out", folder / "new/report", "--trials", "100"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto out = folder.path / "new/report";
  EXPECT_EQ(entries(out), all_files());
  const std::string page = read_file(out / "report.html");
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_TRUE(has(page, "There was no human trial."));
  EXPECT_TRUE(has(page, "NOT reproducible"));
  EXPECT_EQ(count(page, "<svg"), figures.size());
  EXPECT_EQ(count(page, "</svg>"), figures.size());
  EXPECT_EQ(count(page, " src="), 0U);
  EXPECT_EQ(count(page, "href="), count(page, "href='#")) << "a link that leaves the page";
  EXPECT_EQ(count(page, "Simulation.</figcaption>"), figures.size());
  for (const std::string& figure : figures) {
    const std::string svg = read_file(out / (figure + ".svg"));
    EXPECT_TRUE(has(svg, "<svg")) << figure;
    EXPECT_TRUE(svg.ends_with("</svg>\n\n") || svg.ends_with("</svg>\n")) << figure;
    EXPECT_TRUE(has(svg, ", °")) << figure << ": an axis without its unit";
    const std::string png = read_file(out / (figure + ".png"));
    EXPECT_TRUE(png.starts_with("\x89PNG\r\n")) << figure;
    EXPECT_EQ(png_size(png).first, 560U) << figure << ": text is readable at 500 px";
    EXPECT_GE(png_size(png).second, 500U) << figure;
    EXPECT_FALSE(has(svg, " deg")) << figure << ": ° is the symbol";
  }
}

TEST(StudyReport, IdsOfThePageAreUnique) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_study({"report", "--out", folder.path.string(), "--trials", "20"}).exit_code, 0);
  const std::string page = read_file(folder.path / "report.html");
  std::set<std::string> seen;
  for (std::size_t at = page.find(" id="); at != std::string::npos; at = page.find(" id=", at + 1)) {
    const std::size_t end = page.find(page[at + 4], at + 5);
    EXPECT_TRUE(seen.insert(page.substr(at + 5, end - at - 5)).second) << page.substr(at, end - at);
  }
  EXPECT_GT(seen.size(), figures.size());
}

TEST(StudyReport, EveryByteIsTheSameForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(
        run_study({"report", "--out", folder / threads, "--trials", "40", "--threads", threads}).exit_code,
        0);
  for (const std::string& file : all_files())
    EXPECT_EQ(read_file(folder.path / "1" / file), read_file(folder.path / "2" / file)) << file;
}

TEST(StudyReport, AFailingGnuplotLeavesTheLastReportAsItWas) {
  const TemporaryFolder folder;
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\nif read line; then echo 'out of ink' >&2; exit 3; fi\n";
  chmod((folder / "gnuplot").c_str(), 0700);
  std::filesystem::create_directory(folder / "report");
  std::ofstream(folder / "report/report.html") << "the last one";
  const StudyRun run =
      run_study({"report", "--out", folder / "report", "--trials", "10"}, folder.path.string());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "hrt-study: gnuplot failed: out of ink\n");
  EXPECT_EQ(entries(folder / "report"), std::vector<std::string>{"report.html"});
  EXPECT_EQ(read_file(folder / "report/report.html"), "the last one");
}

}  // namespace
}  // namespace hrt::study
