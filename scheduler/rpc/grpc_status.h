/// The error ladder's codes as gRPC's.
#pragma once
#include <grpcpp/support/status.h>

#include "vocab/result.h"

namespace regolab {

inline grpc::Status to_grpc(const Error& error) {
  grpc::StatusCode code = grpc::StatusCode::INTERNAL;
  switch (error.code) {
    case Code::kInvalidArgument: code = grpc::StatusCode::INVALID_ARGUMENT; break;
    case Code::kNotFound: code = grpc::StatusCode::NOT_FOUND; break;
    case Code::kAlreadyExists: code = grpc::StatusCode::ALREADY_EXISTS; break;
    case Code::kFailedPrecondition: code = grpc::StatusCode::FAILED_PRECONDITION; break;
    case Code::kResourceExhausted: code = grpc::StatusCode::RESOURCE_EXHAUSTED; break;
    case Code::kAborted: code = grpc::StatusCode::ABORTED; break;
    case Code::kUnavailable: code = grpc::StatusCode::UNAVAILABLE; break;
    case Code::kDataLoss: code = grpc::StatusCode::DATA_LOSS; break;
    case Code::kCancelled: code = grpc::StatusCode::CANCELLED; break;
    case Code::kInternal: code = grpc::StatusCode::INTERNAL; break;
  }
  return {code, error.text};
}

inline grpc::Status to_grpc(const Result<void>& result) { return result.ok() ? grpc::Status::OK : to_grpc(result.error()); }

}  // namespace regolab
