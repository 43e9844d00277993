/**
 * What can be wrong, one code a fault. All but the last three are the core's (core/include/meshbound/status.hpp):
 *
 * - `internal`: an error of this library, not of its caller;
 * - `worker_failed`: the worker could not be started or died;
 * - `disposed`: the engine that was asked has been disposed of.
 */
export type ErrorCode =
  | 'no_triangles'
  | 'bad_coordinates'
  | 'bad_index'
  | 'non_finite_position'
  | 'bad_components'
  | 'wrong_value_count'
  | 'non_finite_value'
  | 'empty_name'
  | 'duplicate_name'
  | 'unknown_variable'
  | 'bad_bound'
  | 'bound_too_fine'
  | 'bad_option'
  | 'bad_levels'
  | 'bad_checkpoint'
  | 'bad_map'
  | 'too_large'
  | 'out_of_memory'
  | 'internal'
  | 'worker_failed'
  | 'disposed';

/** A fault with its place, as it crosses from the worker. */
export interface Failure {
  code: ErrorCode;
  /** For people: says what is wrong and where. */
  message: string;
  /** The variable at fault, where one is. */
  variable?: string;
  /** The triangle, vertex or value at fault, where one is. */
  index?: number;
}

/** What calls reject with when a mesh, a bound, an option, a checkpoint or a map is at fault. */
export class MeshboundError extends Error implements Failure {
  readonly code: ErrorCode;
  readonly variable?: string;
  readonly index?: number;

  constructor({ code, message, variable, index }: Failure) {
    super(message);
    this.name = 'MeshboundError';
    this.code = code;
    this.variable = variable;
    this.index = index;
  }
}

/** What a call rejects with after its signal was aborted, as everywhere on the web platform. */
export function abortError(): DOMException {
  return new DOMException('The reduction was aborted.', 'AbortError');
}
