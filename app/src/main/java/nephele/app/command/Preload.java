package nephele.app.command;

import nephele.engine.render.gl.GlContext;

/** Loads native libraries on a separate thread while the main one reads options and levels. */
final class Preload {
    private final Thread thread;

    private Preload(Thread thread) {
        this.thread = thread;
    }

    static Preload nothing() {
        return new Preload(null);
    }

    static Preload offscreenGraphics() {
        var thread = new Thread(GlContext::preloadOffscreen, "graphics preload");
        thread.setDaemon(true);
        thread.start();
        return new Preload(thread);
    }

    /** Waits for the end of loading: the process must not exit while a driver is being loaded. */
    void finish() {
        boolean interrupted = false;
        while (thread != null && thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException waitOn) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
