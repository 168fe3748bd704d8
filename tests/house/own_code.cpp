// SPDX-License-Identifier: GPL-3.0-or-later
// A plugin of clang-tidy: its checks look at the declarations of this project only. Without it they walk
// through all that the headers of Eigen, CGAL and OpenVDB declare, once for every source, to report nothing
// of it.
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
