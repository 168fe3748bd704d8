// SPDX-License-Identifier: GPL-3.0-or-later
// Plugin of clang-tidy that limits its checks to the declarations of this project. Without it they traverse
// all declarations in the headers of Eigen, CGAL and OpenVDB, once for every source, and report none of them.
#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendPluginRegistry.h>

#include <memory>
#include <string>
#include <vector>

namespace {

class OwnCode : public clang::ASTConsumer {
  public:
    bool HandleTopLevelDecl(clang::DeclGroupRef group) override {
        for (clang::Decl* declaration : group)
            if (!declaration->getASTContext().getSourceManager().isInSystemHeader(declaration->getLocation()))
                own.push_back(declaration);
        return true;
    }

    void HandleTranslationUnit(clang::ASTContext& context) override { context.setTraversalScope(own); }

  private:
    std::vector<clang::Decl*> own;
};

class OwnCodeFirst : public clang::PluginASTAction {
  protected:
    std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance&,
                                                          llvm::StringRef) override {
        return std::make_unique<OwnCode>();
    }
    bool ParseArgs(const clang::CompilerInstance&, const std::vector<std::string>&) override { return true; }
    ActionType getActionType() override { return AddBeforeMainAction; }
};

const clang::FrontendPluginRegistry::Add<OwnCodeFirst> plugin("own-code",
                                                              "checks see this project's declarations only");

}  // namespace
