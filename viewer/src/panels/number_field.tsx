interface NumberFieldProps {
  label: string;
  unit?: string;
  step: number;
  value: number;
  onChange: (value: number) => void;
}

/** What the engine can surely pose with. */
const MOST = 1e6;

/** What is no number, or too large a one, is not taken. */
export function NumberField({ label, unit, step, value, onChange }: NumberFieldProps) {
  return (
    <label>
      {label}
      {unit && <small> {unit}</small>}
      <input
        type="number"
        step={step}
        value={Number(value.toFixed(3))}
        onInput={({ currentTarget }) => {
          const given = currentTarget.valueAsNumber;
          if (Math.abs(given) <= MOST) onChange(given);
        }}
      />
    </label>
  );
}
