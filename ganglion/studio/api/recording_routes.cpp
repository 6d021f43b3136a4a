#include "ganglion/studio/api/recording_routes.h"

#include <algorithm>
#include <limits>

#include "ganglion/plot/from_run_file.h"
#include "ganglion/report/report.h"
#include "ganglion/studio/api/query.h"

namespace ganglion::studio {

RecordingRoutes::RecordingRoutes(Router& router, const Folder& folder, Listing& listing)
    : folder_(folder), listing_(listing) {
  router.post("/api/recording/open", [this](const Ask& ask) { return open(ask); });
  router.post("/api/recording/samples", [this](const Ask& ask) { return samples(ask); });
  router.get("/api/recording/report", [this](const Ask& ask) { return report(ask); });
  router.post("/api/recording/controller", [this](const Ask& ask) { return controller(ask); });
}

/// Through no link that is put in the way, and with bounds: one file must not take the memory of all who are served.
Result<RunFile> RecordingRoutes::recording_of(const std::string& name) const {
  const auto path = folder_.resolve(name);
  if (!path) return tl::unexpected<Error>(path.error());
  const auto bytes = folder_.bytes_of(*path, kMostRunBytes);
  auto file = bytes ? RunFile::parse(*bytes, name, Recover::Yes, kMostRunBytes) : tl::unexpected<Error>(bytes.error());
  if (!file) return fail(file.error().code, {"\"{}\" {}", "\"{}\": {}"}, name, file.error().what);
  return file;
}

/// The run, read whole; the last one stays in memory, for people scrub through it.
Result<std::shared_ptr<const RecordingView>> RecordingRoutes::view_of(const std::string& name) {
  const auto path = folder_.resolve(name);
  if (!path) return tl::unexpected<Error>(path.error());
  std::error_code error;
  const auto changed = std::filesystem::last_write_time(*path, error);
  if (view_ != nullptr && viewed_ == name && viewed_changed_ == changed) return view_;
  auto file = recording_of(name);
  if (!file) return tl::unexpected<Error>(file.error());
  view_ = std::make_shared<const RecordingView>(std::move(*file));
  viewed_ = name;
  viewed_changed_ = changed;
  return view_;
}

Reply RecordingRoutes::open(const Ask& ask) {
  const std::string name = ask.text("path");
  const auto view = view_of(name);
  if (!view) return failure(view.error(), ask.language);
  Json json = (*view)->head(ask.language);
  json["run"] = listing_.run(*folder_.resolve(name));
  return json_reply(json);
}

Reply RecordingRoutes::samples(const Ask& ask) {
  const auto view = view_of(ask.text("path"));
  if (!view) return failure(view.error(), ask.language);
  constexpr double kEver = std::numeric_limits<double>::max();
  const double every = std::max(1.0, ask.number("every", 1));
  return {200, "application/octet-stream",
          (*view)->samples(ask.number("from_s", -kEver), ask.number("to_s", kEver),
                           static_cast<std::size_t>(std::min(every, 1e9)))};
}

Reply RecordingRoutes::report(const Ask& ask) const {
  const std::string name = query_value(ask.call.target, "path").value_or("");
  const bool spanish = query_value(ask.call.target, "language") == "es";
  const Language language = spanish ? Language::Spanish : Language::English;
  const auto file = recording_of(name);
  if (!file) return failure(file.error(), language);
  const auto page = ganglion::report::report_page(plot::from_run_file(*file), {language});
  if (!page) return failure(page.error(), language);
  return {200, "text/html; charset=utf-8", *page, true};
}

Reply RecordingRoutes::controller(const Ask& ask) {
  const auto view = view_of(ask.text("path"));
  if (!view) return failure(view.error(), ask.language);
  return json_reply({{"text", (*view)->controller()}});
}

}  // namespace ganglion::studio
