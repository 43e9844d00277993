import { firstMethod, type Method } from '../../session/constraints/method.ts';
import { type Attribute, attributes, type Property, properties } from './attributes.ts';

type ViewProperty = Exclude<Property, 'src' | 'bounds'>;

/** What a state says beside address and bounds. */
export const viewProperties = properties.filter(
  (property): property is ViewProperty => property !== 'src' && property !== 'bounds' && attributes[property].isState,
);

/** Places between levels are said to two decimals. */
export function asAttribute(value: string | boolean | number | null): string | null {
  if (typeof value === 'number') return String(Number(value.toFixed(2)));
  return typeof value === 'boolean' ? (value ? '' : null) : value;
}

/** The value of a property whose attribute is this text; null: there is none. */
export function fromAttribute(property: Property, text: string | null): string | boolean | number | null {
  const { kind }: Attribute<unknown> = attributes[property];
  if (kind === 'flag') return text !== null;
  return kind === 'number' && text !== null ? Number(text) : text;
}

/** What a Method is made from. */
export const methodAttributes = Object.keys(firstMethod) as (keyof Method)[];

/** Of the two that are words, what is not known is as at first. */
type WantedMethod = { [Name in keyof Method]: Method[Name] extends boolean ? boolean : Method[Name] | null };

export function methodFrom(wanted: WantedMethod): Method {
  const { refusePiercing, limitToFeatureSize, dropSmallComponents } = wanted;
  return {
    errors: wanted.errors === 'propagated' ? wanted.errors : 'tracked',
    cost: wanted.cost === 'maximum' ? wanted.cost : 'introduced',
    refusePiercing,
    limitToFeatureSize,
    dropSmallComponents,
  };
}
