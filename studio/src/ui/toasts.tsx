import { dismiss, useWorkbench } from '../state/workbench';
import { useText } from '../text/text';
import { Icon } from './icons';

export function Toasts() {
  const text = useText();
  const toasts = useWorkbench((state) => state.toasts);
  return (
    <div className="toasts">
      {toasts.map((one) => (
        <div key={one.id} className={`toast ${one.tone}`}>
          <div>
            <b>{one.title}</b>
            {one.lines.map((line) => (
              <p key={line}>{line}</p>
            ))}
          </div>
          <button type="button" aria-label={text.shell.close} onClick={() => dismiss(one.id)}>
            <Icon name="close" />
          </button>
        </div>
      ))}
    </div>
  );
}
