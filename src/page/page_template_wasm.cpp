// The page that the program runs in holds the template, and puts it into this file.
#include "page/page.hpp"

#include "os/read_file.hpp"

namespace terp {

std::string_view page_template()
{
  static const std::string page = read_file("/terp/page.html");
  return page;
}

bool has_page() { return true; }

}  // namespace terp
