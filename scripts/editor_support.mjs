// Talks to the YAML language server as an editor does, and prints what the editor would show.
// Usage: node editor_support.mjs SERVER REPOSITORY     (see show_editor_support.sh)
import {spawn} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const PATIENCE_MS = 20000;
const CURSOR = '‸';
const [program, root] = process.argv.slice(2);

// The language server on its standard streams: JSON messages with a header (LSP 3.17).
class Server {
  constructor(path) {
    this.child = spawn(process.execPath, [path, '--stdio'], {stdio: ['pipe', 'pipe', 'inherit']});
    this.child.on('exit', status => this.failed(new Error(`the server ended: ${status}`)));
    this.child.stdout.on('data', data => this.receive(data));
    this.unread = Buffer.alloc(0);
    this.answers = new Map();      // id -> {resolve, reject}
    this.diagnostics = new Map();  // uri -> resolve
    this.versions = new Map();     // uri -> number of its last text
    this.lastId = 0;
  }

  failed(error) {
    for (const {reject} of this.answers.values()) reject(error);
  }

  receive(data) {
    this.unread = Buffer.concat([this.unread, data]);
    for (;;) {
      const head = this.unread.indexOf('\r\n\r\n');
      if (head < 0) return;
      const header = this.unread.toString('ascii', 0, head);
      const length = Number(/Content-Length: (\d+)/i.exec(header)[1]);
      const begin = head + 4;
      if (this.unread.length < begin + length) return;
      const text = this.unread.toString('utf8', begin, begin + length);
      this.unread = this.unread.subarray(begin + length);
      this.take(JSON.parse(text));
    }
  }

  take(message) {
    if (message.method !== undefined && message.id !== undefined) {
      // The server asks for settings; it gets none, as from an editor that was not configured.
      const isSettings = message.method === 'workspace/configuration';
      const result = isSettings ? message.params.items.map(() => ({})) : null;
      this.send({id: message.id, result});
    } else if (message.id !== undefined) {
      this.answers.get(message.id)?.resolve(message);
      this.answers.delete(message.id);
    } else if (message.method === 'textDocument/publishDiagnostics') {
      this.diagnostics.get(message.params.uri)?.(message.params.diagnostics);
    }
  }

  send(message) {
    const text = JSON.stringify({jsonrpc: '2.0', ...message});
    this.child.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
  }

  ask(method, params) {
    const id = ++this.lastId;
    return new Promise((resolve, reject) => {
      this.answers.set(id, {resolve, reject});
      this.send({id, method, params});
    });
  }

  async start() {
    const textDocument = {
      completion: {completionItem: {snippetSupport: true, documentationFormat: ['markdown']}},
      hover: {contentFormat: ['markdown']},
      publishDiagnostics: {},
    };
    const capabilities = {textDocument, workspace: {configuration: true}};
    await this.ask('initialize', {processId: process.pid, rootUri: null, capabilities});
    this.send({method: 'initialized', params: {}});
  }

  // Opens a file with this text, whatever is on the disk, or changes it as typing would; answers
  // its address, and its diagnostics if it has just been opened.
  show(path, text) {
    const uri = pathToFileURL(path).href;
    const version = (this.versions.get(uri) ?? 0) + 1;
    this.versions.set(uri, version);
    const diagnostics = new Promise(resolve => this.diagnostics.set(uri, resolve));
    if (version === 1) {
      const textDocument = {uri, languageId: 'yaml', version, text};
      this.send({method: 'textDocument/didOpen', params: {textDocument}});
    } else {
      const params = {textDocument: {uri, version}, contentChanges: [{text}]};
      this.send({method: 'textDocument/didChange', params});
    }
    return {uri, diagnostics};
  }

  stop() {
    this.child.removeAllListeners('exit');
    this.child.kill();
  }
}

const server = new Server(program);
const missing = [];
const timer = setTimeout(() => server.failed(new Error('the server does not answer')), PATIENCE_MS);

function demand(isThere, what) {
  if (!isThere) {
    missing.push(what);
    console.log(`  MISSING: ${what}`);
  }
}

// The line around the cursor, with what the editor offers below it.
function heading(title, text) {
  const line = text.slice(0, text.indexOf(CURSOR)).split('\n').length - 1;
  const around = text.split('\n').slice(Math.max(0, line - 2), line + 1).join('\n');
  console.log(`\n${title}\n\n${around}\n`);
}

// `text` holds the cursor.
async function at_cursor(method, file, text) {
  const before = text.slice(0, text.indexOf(CURSOR)).split('\n');
  const {uri} = server.show(join(root, file), text.replace(CURSOR, ''));
  const position = {line: before.length - 1, character: before.at(-1).length};
  const answer = await server.ask(method, {textDocument: {uri}, position});
  if (answer.error) throw new Error(answer.error.message);
  return answer.result;
}

const plain = text => (typeof text === 'string' ? text : text?.value ?? '').replaceAll('\\', '');

async function show_completion(title, file, text, wanted, unwanted = []) {
  heading(`Completion: ${title}`, text);
  const items = (await at_cursor('textDocument/completion', file, text)).items;
  for (const item of items) {
    const [first] = plain(item.documentation).split('\n');
    console.log(`  ${item.label.padEnd(16)} ${first}`);
  }
  for (const label of wanted) {
    const item = items.find(one => one.label === label);
    demand(item !== undefined, `'${label}' is offered`);
    demand(item === undefined || plain(item.documentation) !== '', `'${label}' is explained`);
  }
  for (const label of unwanted) {
    demand(!items.some(one => one.label === label), `'${label}' is not offered`);
  }
}

async function show_hover(title, file, text, wanted) {
  heading(`Hover: ${title}`, text);
  const shown = plain((await at_cursor('textDocument/hover', file, text))?.contents);
  console.log(shown.replace(/\n*Source: .*/, '').trim().replace(/^(?=.)/gm, '  '));
  for (const pattern of wanted) demand(pattern.test(shown), `the text says ${pattern}`);
}

async function show_diagnostics(title, file, text, wanted) {
  console.log(`\nMistakes: ${title}\n`);
  const {uri, diagnostics} = server.show(join(root, file), text);
  const lines = text.split('\n');
  const found = await Promise.race([diagnostics, new Promise(resolve => {
    setTimeout(resolve, PATIENCE_MS / 2, null);
  })]);
  demand(found !== null, 'the server says whether there are mistakes');
  found?.sort((a, b) => a.range.start.line - b.range.start.line);
  for (const {range, message} of found ?? []) {
    const width = Math.max(1, range.end.character - range.start.character);
    const number = `${range.start.line + 1}`.padStart(5);
    console.log(`${number} | ${lines[range.start.line]}`);
    console.log(`      | ${' '.repeat(range.start.character)}${'~'.repeat(width)} ${message}`);
  }
  if (wanted.length === 0) {
    demand(found?.length === 0, 'nothing is underlined');
    console.log(found?.length === 0 ? '  none' : '');
  }
  for (const pattern of wanted) {
    demand(found?.some(one => pattern.test(one.message)), `a message says ${pattern}`);
  }
}

async function show() {
  const bar = 'mechanisms/planar/four_bar.yaml';
  const box = 'mechanisms/transmissions/ravigneaux.yaml';
  const good = readFileSync(join(root, bar), 'utf8');
  const gears = readFileSync(join(root, box), 'utf8');
  const crank = '{type: revolute, bodies: [frame, crank], at: [0, 0]}';
  const behind = (text, mark, addition) => text.replace(mark, `${mark}${addition}`);
  if (!good.includes(crank)) throw new Error(`${bar} has no coupling ${crank} any more`);

  await show_diagnostics('four_bar.yaml as it is', bar, good, []);

  await show_completion('the type of a coupling', bar, good.replace(crank, `{type: ${CURSOR}}`),
    ['revolute', 'prismatic', 'gear', 'cable', 'screws']);
  await show_completion('the keys of a gear', bar,
    behind(good, 'couplings:\n', `  e:\n    type: gear\n    ${CURSOR}\n`),
    ['bodies', 'at', 'tangent', 'pressure_angle', 'line_of_action'], ['pitch', 'freedoms']);
  await show_completion('the keys of a helical coupling, within braces', bar,
    good.replace(crank, `{type: helical, bodies: [frame, crank], p${CURSOR}}`),
    ['pitch', 'lead', 'axis'], ['pressure_angle']);
  await show_completion('a new coupling', bar, behind(good, 'couplings:\n', `  ${CURSOR}\n`),
    ['revolute', 'gear']);
  await show_completion('a direction', bar,
    good.replace(crank, `{type: prismatic, axis: ${CURSOR}}`),
    ['y', '-x', 'a vector']);
  await show_completion('the keys of a case', bar,
    behind(good, 'cases:\n', `  another:\n    ${CURSOR}\n`),
    ['motion', 'action', 'input', 'output']);
  await show_completion('the sections of a file', bar, `${good}${CURSOR}\n`,
    ['parameters', 'gears', 'shift', 'sweep', 'synthesis'], ['cases']);

  await show_hover('actuators', bar, good.replace('actuators:', `act${CURSOR}uators:`),
    [/where motions and actions/, /coupling: a/]);
  await show_hover('pressure_angle', box,
    gears.replace('pressure_angle:', `press${CURSOR}ure_angle:`),
    [/Pressure angle of the teeth/, /20 deg/]);
  await show_hover('type', bar, good.replace('type: revolute', `ty${CURSOR}pe: revolute`),
    [/type of the coupling/, /turns about an axis/]);
  await show_hover('the motions of a case', bar,
    good.replace('    motion:', `    mot${CURSOR}ion:`),
    [/head relative to the tail/]);

  await show_diagnostics('a file with some', 'mechanisms/planar/with_mistakes.yaml',
    good.replace(crank, '{type: revolut, bodies: [frame, crank], at: [0, 0]}')
      .replace('at: [1, 3]}', 'at: [1, 3], pitch: 2}')
      .replace('bodies: [coupler, rocker], at: [6, 5]', 'bodies: [coupler], at: {x: 6, y: 5}')
      .replace('at: [7, 0]', 'at: [7, 0, 0]')
      .replace('actuators:', 'actuator:'),
    [/Valid values: "revolute"/, /Property pitch is not allowed/, /too few items/,
      /Write a point as/, /too many items/, /Property actuator is not allowed/]);
}

try {
  await server.start();
  await show();
} catch (error) {
  missing.push(error.message);
  console.log(`MISSING: ${error.message}`);
}
clearTimeout(timer);
server.stop();
console.log(missing.length === 0 ? '\nAll of it is there.' : `\n${missing.length} missing.`);
process.exitCode = missing.length === 0 ? 0 : 1;
