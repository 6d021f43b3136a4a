import { useText } from '../text/text';
import { Icon } from '../ui/icons';
import { type CommandName, carryOut, commandOf } from './commands';

interface Props {
  name: CommandName;
  icon: string;
  words?: string;
  enabled?: boolean;
}

/** A command as a picture, with its keys in the hint. Whether it can be carried out is asked of the command unless
 *  `enabled` says so. */
export function CommandButton({ name, icon, words, enabled }: Props) {
  const text = useText();
  const command = commandOf(name);
  const keys = command.keys ? ` (${command.keys[0]})` : '';
  const label = words ?? text.commands[name];
  return (
    <button
      type="button"
      aria-label={label}
      title={label + keys}
      disabled={!(enabled ?? command.enabled?.() ?? true)}
      onClick={() => void carryOut(command)}
    >
      <Icon name={icon} />
    </button>
  );
}
