// What makes a page hard to read or to use: poor contrast, small targets, chatty live regions.

/** The texts whose contrast with what is behind them is below 4.5, with this contrast. */
export function poorContrasts(page) {
  return page.evaluate(() => {
    const numbers = (colour) => {
      const [r, g, b, a = 1] = colour.match(/[\d.]+/g).map(Number);
      return { rgb: [r, g, b], a };
    };
    const over = (front, back) =>
      front.rgb.map((value, i) => front.a * value + (1 - front.a) * back[i]);
    const luminance = (rgb) => {
      const [r, g, b] = rgb.map((value) => {
        const share = value / 255;
        return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
      });
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const contrast = (one, other) => {
      const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
      return (high + 0.05) / (low + 0.05);
    };
    const ancestors = (element) => {
      const all = [];
      for (let one = element; one; one = one.parentElement) all.unshift(one);
      return all;
    };
    /** The page is behind everything, in the colours of its gradient. */
    const pages = getComputedStyle(document.body).backgroundImage.match(/rgb\([^)]*\)/g);
    const worstOf = (element) => {
      const styles = ancestors(element).map((one) => getComputedStyle(one));
      const opacity = styles.reduce((product, style) => product * Number(style.opacity), 1);
      const ink = numbers(styles.at(-1).color);
      return Math.min(
        ...pages.map((page) => {
          const backs = styles.map(({ backgroundColor }) => numbers(backgroundColor));
          const back = backs.reduce((under, one) => over(one, under), numbers(page).rgb);
          return contrast(over({ ...ink, a: ink.a * opacity }, back), back);
        }),
      );
    };
    const hasText = (element) =>
      [...element.childNodes].some(
        (node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim() !== '',
      ) || element.matches('input[type=number]');
    return [...document.querySelectorAll('#panels *')]
      .filter((element) => hasText(element) && element.checkVisibility())
      .filter((element) => !element.matches(':disabled, option, :disabled *'))
      .map((element) => ({ text: element.textContent || element.value, is: worstOf(element) }))
      .filter(({ is }) => is < 4.5)
      .map(({ text, is }) => `${text}: ${is.toFixed(2)}`);
  });
}

/** The controls that are less than 24 pixels high or wide. */
export function smallTargets(page) {
  return page.evaluate(() =>
    [...document.querySelectorAll('#panels :is(button, select, summary, .switch, [type=range])')]
      .filter((element) => element.checkVisibility())
      .map((element) => ({ element, box: element.getBoundingClientRect() }))
      .filter(({ box }) => box.height < 23.9 || box.width < 23.9)
      .map(({ element, box }) => {
        const name = element.ariaLabel ?? element.textContent;
        return `${name}: ${box.width.toFixed(0)} x ${box.height.toFixed(0)}`;
      }),
  );
}

/** Number of changes, within some time, of regions that screen readers read out. */
export function announcements(page, milliseconds = 500) {
  return page.evaluate(async (wait) => {
    let changes = 0;
    const observer = new MutationObserver((all) => (changes += all.length));
    for (const region of document.querySelectorAll('output, [role=status], [aria-live]')) {
      observer.observe(region, { childList: true, characterData: true, subtree: true });
    }
    await new Promise((done) => setTimeout(done, wait));
    observer.disconnect();
    return changes;
  }, milliseconds);
}
