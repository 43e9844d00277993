import { LitElement, type PropertyDeclaration } from 'lit';
import {
  type Attribute,
  attributeName,
  attributes,
  isOwn,
  type Properties,
  type Property,
  properties,
} from './attributes.ts';

const types = { text: String, choice: String, flag: Boolean, number: Number };

function declarationOf(property: Property): PropertyDeclaration {
  const { kind, counts }: Attribute<unknown> = attributes[property];
  return {
    attribute: attributeName(property),
    type: types[kind],
    ...(counts ? { hasChanged: () => true } : {}),
    ...(isOwn(property) ? { noAccessor: true } : {}),
  };
}

export interface ViewerProperties extends Properties {}

/** An element with the properties and attributes of a viewer; those that are the viewer's own it has to write. */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: Lit makes the properties of the table, and the constructor sets them.
export class ViewerProperties extends LitElement {
  static override properties = Object.fromEntries(properties.map((property) => [property, declarationOf(property)]));

  constructor() {
    super();
    const plain = properties.filter((property) => !isOwn(property));
    Object.assign(this, Object.fromEntries(plain.map((property) => [property, attributes[property].initial])));
  }
}
