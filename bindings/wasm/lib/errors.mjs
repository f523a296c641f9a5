export class PeltError extends Error {
  constructor(code, message, cause = undefined) {
    super(message);
    this.name = 'PeltError';
    this.code = code;
    if (cause !== undefined) this.cause = cause;
  }
}

export function invalid(message) {
  return new PeltError('invalid_argument', message);
}
