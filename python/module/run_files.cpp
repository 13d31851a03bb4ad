#include "run_files.hpp"

#include "run/measure/followers.hpp"
#include "io/case/case_record.hpp"

namespace terp {
namespace {

std::unique_ptr<RunWriter> begin_folder(
    const CaseFile& file, const Simulation& run, const std::string& folder, bool force)
{
  return RunWriter::start({.folder = folder,
                              .case_text = {file.values.name, file.text},
                              .checkpoint_keep = file.values.output.checkpoint_keep,
                              .case_record = record_text(make_case_record(file, *run.model.mesh)),
                              .inputs = file.inputs,
                              .tables = all_tables()},
      force);
}

}  // namespace

RunFiles::RunFiles(const CaseFile& file, const Simulation& run, const std::string& folder, bool force)
    : run_(run),
      writer_(begin_folder(file, run, folder, force)),
      mesh_(folder, writer_->frames_of_mesh(), run.model, run.state),
      keeper_(run.model, run.state, *writer_)
{
  writer_->summary(summarise(run.model, run.state), false);  // also names the case for `terp resume`
}

void RunFiles::finish(bool has_ended)
{
  writer_->summary(summarise(run_.model, run_.state), has_ended);
  writer_->finish();
}

}  // namespace terp
