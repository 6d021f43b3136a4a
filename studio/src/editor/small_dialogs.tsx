import { type FormEvent, useState } from 'react';
import { edit, select, useModel } from '../state/document';
import { closeDialog, complain, useWorkbench } from '../state/workbench';
import { useText } from '../text/text';
import { Modal } from '../ui/dialog';
import { ClassMark } from '../ui/icons';
import { PickList } from '../ui/pick_list';
import { reveal } from './canvas_handle';

export function RenameDialog({ id }: { id: string }) {
  const text = useText();
  const [to, setTo] = useState(id);
  const submit = (event: FormEvent) => {
    event.preventDefault();
    closeDialog();
    if (to === id) return;
    edit([{ op: 'rename', id, to }], { selectMade: true }).catch(complain);
  };
  return (
    <Modal title={text.shell.rename_title(id)}>
      <form onSubmit={submit}>
        <label className="field">
          <span>{text.shell.rename_to}</span>
          <input
            data-first
            value={to}
            onChange={(event) => setTo(event.target.value)}
            onFocus={(event) => event.target.select()}
          />
        </label>
        <div className="dialog-ends">
          <button type="submit" className="primary">
            {text.configure.ok}
          </button>
        </div>
      </form>
    </Modal>
  );
}

export function SearchDialog() {
  const text = useText();
  const model = useModel();
  const pick = (id: string) => {
    closeDialog();
    select([id]);
    if (useWorkbench.getState().centre === 'drawing') reveal(id);
  };
  return (
    <Modal title={text.shell.search_title}>
      <PickList
        label={text.connect.search}
        empty={text.palette.nothing}
        items={(model?.components ?? []).map((one) => ({
          key: one.id,
          words: `${one.id} ${one.kind} ${one.channel} ${text.classes[one.class]}`,
          show: (
            <>
              <ClassMark of={one.class} /> {one.id}
            </>
          ),
          note: one.channel || one.kind,
          pick: () => pick(one.id),
        }))}
      />
    </Modal>
  );
}
