#include "ganglion/studio/api/reply.h"

namespace ganglion::studio {

Reply failure(std::string_view code, const Sentence& what, Language language, unsigned status, const Json& arguments) {
  Reply reply = json_reply({{"error", {{"code", code}, {"message", what.in(language)}, {"arguments", arguments}}}});
  reply.status = status;
  return reply;
}

Reply failure(const Error& error, Language language, const Json& arguments) {
  unsigned status = 400;
  if (error.code == ErrorCode::NotFound) status = 404;
  if (error.code == ErrorCode::TooLarge) status = 413;
  if (error.code == ErrorCode::Unreadable) status = 422;  // there, but no file: a folder, a pipe
  if (error.code == ErrorCode::Unwritable) status = 507;  // the disk is full, or not ours to write
  return failure(name_of(error.code), error.what, language, status, arguments);
}

Sentence nothing_there() { return say({"there is nothing at this path", "aquí no hay nada"}); }
Sentence takes_only(std::string_view method) { return say({"this path takes {}", "esta ruta admite {}"}, method); }

}  // namespace ganglion::studio
