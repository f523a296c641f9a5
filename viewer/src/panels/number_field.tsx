import { useRef } from 'preact/hooks';

interface NumberFieldProps {
  label: string;
  unit?: string;
  title?: string;
  step: number;
  value: number;
  least?: number;
  most?: number;
  /** Values with this difference are the same. */
  period?: number;
  onChange: (value: number) => void;
  /** Called when the user has finished typing. */
  onEnd: () => void;
}

/** Range of numbers that the engine accepts. */
const MOST = 1e6;

/** More than what is shown leaves out of a number. */
const TOLERANCE = 1e-3;

/**
 * Does not change a text while it is typed, as long as it represents the value. Ignores texts that
 * are not numbers or are out of range.
 */
export function NumberField(props: NumberFieldProps) {
  const { label, unit, title, step, value, least = -MOST, most = MOST, onChange } = props;
  const typed = useRef<{ text: string; value: number } | null>(null);
  const isTyped = typed.current && isSame(typed.current.value - value, props.period);
  return (
    <label title={title}>
      {label}
      {unit && <small> {unit}</small>}
      <input
        type="number"
        step={step}
        value={isTyped ? typed.current!.text : format(value)}
        onInput={({ currentTarget }) => {
          const { value: text, valueAsNumber: given } = currentTarget;
          const isTaken = given >= least && given <= most;
          typed.current = { text, value: isTaken ? given : value };
          if (isTaken) onChange(given);
        }}
        onBlur={({ currentTarget }) => {
          typed.current = null;
          currentTarget.value = format(value);
          props.onEnd();
        }}
      />
    </label>
  );
}

function isSame(difference: number, period = Infinity): boolean {
  const away = Math.abs(difference) % period;
  return Math.min(away, period - away) < TOLERANCE;
}

function format(value: number): string {
  return String(Number(value.toFixed(3)));
}
