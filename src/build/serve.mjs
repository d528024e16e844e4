// Serves dist/ for `npm start`: prints the address, and says what to do if the port is taken.
import { preview } from "vite";

const port = process.env.PORT ?? "4173";

if (!/^\d{1,5}$/.test(port) || Number(port) > 65535)
  fail(`PORT=${port} is no port; take a number up to 65535`);

try {
  const server = await preview();
  server.printUrls();
} catch (error) {
  if (!(error instanceof Error && /already in use/.test(error.message))) throw error;
  fail(
    `The port ${port} is taken. Close what uses it, or take another one: PORT=${Number(port) + 1} npm start`,
  );
}

function fail(message) {
  console.error(message);
  process.exit(1);
}
