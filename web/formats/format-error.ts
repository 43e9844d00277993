/** What can be wrong with a file. One value a fault, stable, so that a program can act on it. */
export type FormatFault =
  | 'empty_file' // no bytes at all
  | 'not_a_mesh' // no format that is known here, or by name
  | 'unsupported_format' // a format that is known, but not read
  | 'unsupported_feature' // the format is read, this part of it is not
  | 'bad_header' // the head of the file contradicts its format
  | 'bad_xml' // not well-formed, or with entities of its own
  | 'bad_encoding' // a name is not UTF-8
  | 'truncated' // the file ends before what it declares
  | 'corrupt' // base64 or compressed data that cannot be decoded
  | 'bad_number' // a word where a number belongs
  | 'count_mismatch' // an array has fewer or more values than its points or cells need
  | 'no_points'
  | 'no_triangles'
  | 'bad_polygon' // fewer than three corners, or a list length that cannot be
  | 'bad_index' // a face names a point that does not exist
  | 'empty_name'
  | 'duplicate_name'
  | 'bad_name' // a name that the format cannot write
  | 'not_finite' // NaN, infinity, or beyond single precision, which the format cannot write
  | 'too_coarse' // the format's precision takes more of a bound than may be
  | 'too_large'; // beyond memory, or beyond what an honest file would expand to

/**
 * A file that cannot be read, or a mesh that cannot be written. The message is a sentence for people that says what is
 * wrong and where; `where` names the place alone ("vertex 7", "header line 3", "array “pressure”"), where there is one.
 */
export class FormatError extends Error {
  readonly code: FormatFault;
  readonly where: string | undefined;

  constructor(code: FormatFault, message: string, where?: string) {
    super(message);
    this.name = 'FormatError';
    this.code = code;
    this.where = where;
  }
}
