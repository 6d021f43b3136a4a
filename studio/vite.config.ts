import react from '@vitejs/plugin-react';
import { defineConfig } from 'vite';

// The server refuses data: addresses and inline scripts, so that nothing may be inlined.
export default defineConfig({
  base: '/',
  plugins: [react()],
  build: { target: 'es2022', assetsInlineLimit: 0, modulePreload: { polyfill: false }, chunkSizeWarningLimit: 900 },
});
