import { closeDialog } from '../state/workbench';
import { useText } from '../text/text';
import { Modal } from '../ui/dialog';
import { PickList } from '../ui/pick_list';
import { carryOut, kCommands } from './commands';

export function CommandPalette() {
  const text = useText();
  return (
    <Modal title={text.commands.palette}>
      <PickList
        label={text.shell.command_search}
        empty={text.palette.nothing}
        items={kCommands
          .filter((command) => command.enabled?.() ?? true)
          .map((command) => ({
            key: command.name,
            words: `${text.commands[command.name]} ${text.menus[command.menu]}`,
            show: text.commands[command.name],
            note: command.keys?.join(', '),
            pick: () => {
              closeDialog();
              void carryOut(command);
            },
          }))}
      />
    </Modal>
  );
}

/** Every key, from the one table. */
export function KeysDialog() {
  const text = useText();
  return (
    <Modal title={text.shell.keys_title}>
      <table className="keys">
        <tbody>
          {kCommands
            .filter((command) => command.keys)
            .map((command) => (
              <tr key={command.name}>
                <th scope="row">
                  {command.keys?.map((key) => (
                    <kbd key={key}>{key}</kbd>
                  ))}
                </th>
                <td>{text.commands[command.name]}</td>
              </tr>
            ))}
          <tr>
            <th scope="row">
              <kbd>{text.shell.arrows}</kbd>
            </th>
            <td>{text.shell.arrows_help}</td>
          </tr>
          <tr>
            <th scope="row">
              <kbd>{text.shell.alt_arrows}</kbd>
            </th>
            <td>{text.shell.alt_arrows_help}</td>
          </tr>
        </tbody>
      </table>
    </Modal>
  );
}
