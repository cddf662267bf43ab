#include "tests/cli/pages.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

// The name that a heading has in links: lower case, hyphens for blanks, without other punctuation.
std::string name_of_heading(const std::string& heading) {
  std::string name;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ') {
      name += '-';
    }
  }
  return name;
}

void add_links(std::vector<std::string>& links, const std::string& line) {
  static const std::regex code("`[^`]*`");
  static const std::regex link(R"(\]\(([^)]*)\))");
  const std::string text = std::regex_replace(line, code, "");
  for (std::sregex_iterator found(text.begin(), text.end(), link); found != std::sregex_iterator(); ++found) {
    links.push_back((*found)[1]);
  }
}

Document read_page(const fs::path& file) {
  Document page;
  std::ifstream stream(file);
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) page.code.push_back({line.substr(3), ""});
    } else if (inside) {
      page.code.back().text += line + "\n";
    } else if (line.starts_with("#")) {
      page.headings.push_back(name_of_heading(line.substr(std::min(line.find(' '), line.size() - 1) + 1)));
    } else {
      add_links(page.links, line);
    }
  }
  return page;
}

bool leads_somewhere(const std::vector<Document>& pages, const fs::path& folder, const fs::path& from,
                     const std::string& link) {
  const std::size_t mark = link.find('#');
  const std::string target = link.substr(0, mark);
  const fs::path file = target.empty() ? from : (from.parent_path() / target).lexically_normal();
  if (file.begin()->string() == ".." || !fs::exists(folder / file)) return false;
  if (mark == std::string::npos) return true;
  const auto page = std::find_if(pages.begin(), pages.end(), [&](const Document& p) { return p.file == file; });
  return page != pages.end() &&
         std::find(page->headings.begin(), page->headings.end(), link.substr(mark + 1)) != page->headings.end();
}

}  // namespace

std::vector<Document> pages_below(const fs::path& folder) {
  std::vector<Document> pages;
  for (fs::recursive_directory_iterator entry(folder); entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry.depth() == 0 && (name.starts_with(".") || name == "build" || name == "out")) {
      entry.disable_recursion_pending();
    } else if (entry->path().extension() == ".md") {
      pages.push_back(read_page(entry->path()));
      pages.back().file = entry->path().lexically_relative(folder);
    }
  }
  std::sort(pages.begin(), pages.end(), [](const Document& a, const Document& b) { return a.file < b.file; });
  return pages;
}

std::vector<std::string> dead_links(const fs::path& folder) {
  const std::vector<Document> pages = pages_below(folder);
  std::vector<std::string> dead;
  for (const Document& page : pages) {
    for (const std::string& link : page.links) {
      if (!leads_somewhere(pages, folder, page.file, link)) dead.push_back(page.file.string() + ": " + link);
    }
  }
  return dead;
}

}  // namespace airlight::test
