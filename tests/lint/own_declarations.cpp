// A clang-tidy check that finds nothing and makes the others two to three times as fast: they search what is
// declared outside system headers, which is where findings are shown. Without it they search every system
// header in each source.
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchFinder.h>

namespace {

namespace matchers = clang::ast_matchers;
namespace tidy = clang::tidy;

class OwnDeclarations : public tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;
  void registerMatchers(matchers::MatchFinder* finder) override {
    // The unit is matched before what it contains, so the scope holds for all that follows.
    finder->addMatcher(matchers::translationUnitDecl().bind("unit"), this);
  }
  void check(const matchers::MatchFinder::MatchResult& result) override {
    std::vector<clang::Decl*> own;
    for (clang::Decl* declaration : result.Nodes.getNodeAs<clang::TranslationUnitDecl>("unit")->decls())
      if (!result.SourceManager->isInSystemHeader(result.SourceManager->getExpansionLoc(declaration->getLocation())))
        own.push_back(declaration);
    result.Context->setTraversalScope(own);
  }
};

class Module : public tidy::ClangTidyModule {
 public:
  void addCheckFactories(tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<OwnDeclarations>("hrt-own-declarations");
  }
};

tidy::ClangTidyModuleRegistry::Add<Module> module("hrt-module", "Own declarations only.");

}  // namespace
