#include "model/case/case.hpp"

#include "os/files.hpp"

namespace terp {

std::string path_of(const std::string& folder, const std::string& file)
{
  return is_absolute(file) || folder.empty() ? file : folder + '/' + file;
}

}  // namespace terp
