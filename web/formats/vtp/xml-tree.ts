import { SaxesParser, type SaxesTagPlain } from 'saxes';
import { FormatError } from '../format-error.ts';
import { foreign, quoted } from '../text/wording.ts';

export interface XmlNode {
  tag: string;
  attributes: Record<string, string>;
  children: XmlNode[];
  /** The text directly inside. */
  text: string;
}

/** Trees of mesh files are flat and small; these only stop files that are made to exhaust memory. */
const deepest = 32;
const mostNodes = 250_000;
const chunkSize = 1 << 20;

/**
 * The tree of an XML document. With `open`, the document goes on after these bytes (with what is not XML), so elements may
 * be left open. Documents with a DOCTYPE are refused: mesh files have none, and entities are a known way to exhaust memory.
 */
export function parseXml(bytes: Uint8Array, open: boolean): XmlNode {
  const parser = new SaxesParser({ xmlns: false });
  const stack: XmlNode[] = [{ tag: '', attributes: {}, children: [], text: '' }];
  let nodes = 0;
  const fail = (message: string) => {
    throw new FormatError(
      'bad_xml',
      `The XML is not well-formed: ${message} (line ${parser.line}).`,
      `line ${parser.line}`,
    );
  };
  parser.on('doctype', () => fail('a DOCTYPE is not allowed in a VTK file'));
  parser.on('opentag', (tag: SaxesTagPlain) => {
    if (++nodes > mostNodes || stack.length > deepest) fail('too many or too deeply nested elements');
    const node = { tag: tag.name, attributes: tag.attributes, children: [], text: '' };
    stack[stack.length - 1].children.push(node);
    stack.push(node);
  });
  parser.on('closetag', () => stack.pop());
  parser.on('text', (text) => {
    stack[stack.length - 1].text += text;
  });
  parser.on('error', (error) => fail(foreign(error.message.replace(/^\d+:\d+: /, ''))));
  feed(parser, bytes);
  if (!open) close(parser);
  return stack[0].children[0] ?? fail('there is no element');
}

/** Room for the XML declaration, which is the first thing in a file. */
const declarationSize = 1 << 10;

/** The encoding that a document declares, in lower case. */
function declaredEncoding(bytes: Uint8Array): string {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, declarationSize));
  return /^\s*<\?xml[^>]*?\bencoding\s*=\s*["']([^"']*)["']/.exec(head)?.[1].toLowerCase() ?? 'utf-8';
}

function decoderOf(encoding: string): TextDecoder {
  try {
    return new TextDecoder(encoding, { fatal: true });
  } catch {
    const message = `The file declares the encoding ${quoted(encoding)}, which is not read here. Save it in UTF-8.`;
    throw new FormatError('unsupported_feature', message);
  }
}

function feed(parser: SaxesParser<{ xmlns: false }>, bytes: Uint8Array): void {
  const encoding = declaredEncoding(bytes);
  const decoder = decoderOf(encoding);
  for (let at = 0; at < bytes.length; at += chunkSize) {
    parser.write(decodeChunk(decoder, bytes.subarray(at, at + chunkSize), parser, encoding));
  }
}

function decodeChunk(
  decoder: TextDecoder,
  chunk: Uint8Array,
  parser: SaxesParser<{ xmlns: false }>,
  encoding: string,
): string {
  try {
    return decoder.decode(chunk, { stream: true });
  } catch {
    const where = `after line ${parser.line}`;
    throw new FormatError('bad_encoding', `The text is not ${encoding.toUpperCase()} (somewhere ${where}).`, where);
  }
}

/** All text is in and was well-formed so far; what is wrong now is that it ends too early. */
function close(parser: SaxesParser<{ xmlns: false }>): void {
  parser.on('error', () => {
    throw new FormatError(
      'truncated',
      `The file ends in the middle of its XML (line ${parser.line}).`,
      `line ${parser.line}`,
    );
  });
  parser.close();
}

export function childrenOf(node: XmlNode, tag: string): XmlNode[] {
  return node.children.filter((child) => child.tag === tag);
}
