/// A bed from its bytes.
#pragma once
#include <string_view>

#include "vocab/result.h"
#include "worker/dem/archive.h"
#include "worker/protocol/bed.h"
#include "worker/stage/envelope.h"

namespace regolab {

inline Result<protocol::Bed> open_bed(std::string_view bytes, std::string_view settle_text) {
  const auto payload = unseal(Content::kBed, settle_text, bytes);
  if (!payload) return payload.error();
  protocol::Bed bed;
  dem::Loader loader(*payload);
  bed.archive(loader);
  if (!loader.finished()) return Error{Code::kDataLoss, "unusable bed (its length is wrong) run the settle stage again"};
  return bed;
}

}  // namespace regolab
