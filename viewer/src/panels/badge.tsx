import { cssColour, bodyColour, inkOn } from '../draw/colours';

/** An instance's number in its colour, as keys and the command's tables have it. */
export function Badge({ instance }: { instance: number }) {
  const colour = bodyColour(instance);
  return (
    <b class="badge" style={{ background: cssColour(colour), color: inkOn(colour) }}>
      {instance}
    </b>
  );
}
