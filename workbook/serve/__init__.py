"""motionbook in the browser: a folder of machines on this computer, by the same commands as on the terminal."""
