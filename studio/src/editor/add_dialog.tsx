import { useEffect, useState } from 'react';
import type { ComponentClass } from '../api/types';
import { useModel } from '../state/document';
import { useKinds } from '../state/kinds';
import { closeDialog, complain } from '../state/workbench';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { Modal } from '../ui/dialog';
import { ClassMark } from '../ui/icons';
import { PickList } from '../ui/pick_list';
import { add, fitting, type Offered, offered } from './adding';
import { middle } from './canvas_handle';
import type { Point } from './placing';

type Fit = { one: Offered; port?: string };

/** Type to add. With a wire in the hand only what it fits is offered, and the wire is drawn too. */
export function AddDialog({ from, at }: { from?: string; at?: Point }) {
  const text = useText();
  const model = useModel();
  const kinds = useKinds((state) => state.list);
  const language = useSettings((settings) => settings.language);
  const [fits, setFits] = useState<Fit[] | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: asked once, when the dialog opens
  useEffect(() => {
    const all = offered(kinds, model, language);
    if (!from) setFits(all.map((one) => ({ one })));
    else fitting(all, from).then(setFits, complain);
  }, []);
  const pick = ({ one, port }: Fit) => {
    closeDialog();
    add(one, at ?? middle(), from, port).catch(complain);
  };
  return (
    <Modal title={from ? `${text.palette.fits}: ${from}` : text.commands.add}>
      <PickList
        label={text.palette.search}
        empty={fits === null ? `${text.shell.busy}…` : text.palette.nothing}
        items={(fits ?? []).map((fit) => ({
          key: `${fit.one.class} ${fit.one.label}`,
          words: `${fit.one.label} ${fit.one.paper} ${text.classes[fit.one.class as ComponentClass]}`,
          show: (
            <>
              <ClassMark of={fit.one.class as ComponentClass} /> {fit.one.label} {fit.one.paper && `(${fit.one.paper})`}
              {fit.port && ` · ${fit.port}`}
            </>
          ),
          note: fit.one.help,
          pick: () => pick(fit),
        }))}
      />
    </Modal>
  );
}
