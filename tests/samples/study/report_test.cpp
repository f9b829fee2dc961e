#include <gtest/gtest.h>

#include <fstream>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

const std::vector<std::string> all_files{"fig1c.svg", "fig4.svg", "fig5.svg",    "fig6.svg",
                                         "fig7.svg",  "fig8.svg", "report.html", "table1.svg"};

TEST(StudyReport, WritesAllFiguresAndAPage) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2"}) {
    const StudyRun run =
        expect_exit(0, run_study({"report", "--out", folder / threads, "--trials", "40", "--threads", threads}));
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(entries(folder / threads), all_files);
  }
  const std::string page = read_file(folder / "1/report.html");
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_TRUE(has(page, {"There was no human trial.", "NOT reproducible"}));
  for (const std::string& file : all_files) {
    const std::string content = read_file(folder / ("1/" + file));
    EXPECT_EQ(content, read_file(folder / ("2/" + file))) << file;
    if (!file.ends_with(".svg")) continue;
    EXPECT_TRUE(has(page, "<img src=\"" + file + "\"")) << file;
    EXPECT_TRUE(has(content, "</svg>")) << file;
    EXPECT_TRUE(has(content, file == "fig1c.svg" ? ", mm" : ", °")) << file << ": an axis has no unit";
    EXPECT_FALSE(has(content, " deg")) << file << ": the unit is written °";
  }
}

TEST(StudyReport, AFailedDrawingKeepsThePreviousReport) {
  const TemporaryFolder folder;
  std::ofstream(folder / "matplotlib.py") << "def use(_): raise SystemExit('out of ink')";
  std::filesystem::create_directory(folder / "report");
  std::ofstream(folder / "report/report.html") << "the last one";
  const StudyRun run =
      expect_exit(1, run_study({"report", "--out", folder / "report", "--trials", "10"}, folder.path.string()));
  EXPECT_EQ(run.err, "hrt-study: figures.py failed: out of ink\n");
  EXPECT_EQ(entries(folder / "report"), std::vector<std::string>{"report.html"});
  EXPECT_EQ(read_file(folder / "report/report.html"), "the last one");
}

}  // namespace
}  // namespace hrt::study
