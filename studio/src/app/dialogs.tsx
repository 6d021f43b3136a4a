import { CommandPalette, KeysDialog } from '../commands/command_palette';
import { NewDialog } from '../document/new_dialog';
import { AddDialog } from '../editor/add_dialog';
import { ConnectFrom, ConnectTo } from '../editor/connect_dialog';
import { RenameDialog, SearchDialog } from '../editor/small_dialogs';
import { ConfigureDialog } from '../run/configure';
import { useWorkbench } from '../state/workbench';
import { GoalDialog, ObstacleDialog } from '../world/reach_dialogs';

/** The one that is open, if any. */
export function Dialogs() {
  const dialog = useWorkbench((state) => state.dialog);
  switch (dialog?.kind) {
    case 'new':
      return <NewDialog />;
    case 'commands':
      return <CommandPalette />;
    case 'keys':
      return <KeysDialog />;
    case 'search':
      return <SearchDialog />;
    case 'configure':
      return <ConfigureDialog />;
    case 'set_goal':
      return <GoalDialog />;
    case 'put_obstacle':
      return <ObstacleDialog />;
    case 'rename':
      return <RenameDialog id={dialog.id} />;
    case 'add':
      return <AddDialog from={dialog.from} at={dialog.at} />;
    case 'connect_to':
      return <ConnectTo id={dialog.id} from={dialog.from} />;
    case 'connect_from':
      return <ConnectFrom id={dialog.id} port={dialog.port} />;
    default:
      return null;
  }
}
