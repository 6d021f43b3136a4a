import { api, type StartRun } from '../api/client';
import { current, useDocument } from '../state/document';
import { useRun } from '../state/run';

/** What is drawn, saved or not, as it is configured. */
function wantedRun(): StartRun {
  const { configuration } = useRun.getState();
  const step = current();
  return {
    experiment: configuration.experiment,
    pace: configuration.pace,
    record: configuration.record,
    paused: configuration.paused,
    ...(step ? { controller: { path: useDocument.getState().path, text: step.text } } : {}),
    ...(configuration.world ? { world: configuration.world } : {}),
    ...(configuration.robot ? { robot: configuration.robot } : {}),
    ...(configuration.seed !== null ? { seed: configuration.seed } : {}),
    ...(configuration.duration_s !== null ? { duration_s: configuration.duration_s } : {}),
    ...(configuration.application === 'simulation' ? { address: '' } : {}),
    ...(configuration.application === 'address' ? { address: configuration.address.trim() } : {}),
    ...(configuration.application === 'program' ? { program: configuration.program } : {}),
  };
}

export async function start(): Promise<void> {
  useRun.setState({ runText: current()?.text ?? '' });
  await api.start(wantedRun());
}

/** Has the server look at the robot; what it finds comes as events. */
export async function testLink(): Promise<void> {
  useRun.setState({ linkTest: null });
  const { test } = await api.testLink(wantedRun());
  useRun.setState((run) => (run.linkTest?.test === test.test ? {} : { linkTest: test }));
}
