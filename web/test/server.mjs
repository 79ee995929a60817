// A static server of one folder under a sub-path, as a site has it.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const types = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.gz': 'application/gzip' };

/// { url, close() }
export function serve(folder, path = '/some/place/') {
  const server = createServer((request, response) => {
    let name = decodeURIComponent(new URL(request.url, 'http://x').pathname);
    name = name.startsWith(path) ? normalize(name.slice(path.length) || 'index.html') : null;
    const file = name && !name.startsWith('..') ? join(folder, name) : null;
    try {
      if (!file || !statSync(file).isFile()) throw new Error();
      response.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream' });
      createReadStream(file).pipe(response);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve({ url: `http://127.0.0.1:${server.address().port}${path}`, close: () => server.close() })));
}
