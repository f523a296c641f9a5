interface NumberFieldProps {
  label: string;
  unit?: string;
  step: number;
  value: number;
  onChange: (value: number) => void;
}

/** What is no number is not taken. */
export function NumberField({ label, unit, step, value, onChange }: NumberFieldProps) {
  return (
    <label>
      {label}
      {unit && <small> {unit}</small>}
      <input
        type="number"
        step={step}
        value={Number(value.toFixed(4))}
        onInput={({ currentTarget }) => {
          const given = currentTarget.valueAsNumber;
          if (Number.isFinite(given)) onChange(given);
        }}
      />
    </label>
  );
}
