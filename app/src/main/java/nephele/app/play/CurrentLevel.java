package nephele.app.play;

import nephele.engine.render.gl.GlContext;
import nephele.engine.sim.SimSettings;
import nephele.engine.terminal.CommandFailure;

/** The level being played, if there is one yet, with its figures and what is recorded of it. */
final class CurrentLevel implements AutoCloseable {
    private final FiguresControl figures;
    private final Recordings recordings;
    private final Message message;
    private Session session;

    CurrentLevel(GlContext gl, Recordings recordings, Message message) {
        figures = new FiguresControl(gl);
        this.recordings = recordings;
        this.message = message;
    }

    /** Null before the first level. */
    Session session() {
        return session;
    }

    FiguresControl figures() {
        return figures;
    }

    void toggleFigures() {
        if (session != null) {
            figures.toggle(session.renderer());
        }
    }

    /** Keeps what was recorded of the level before and takes its place. */
    void become(Session loaded) {
        keepRecordingOrSay();
        closeSession();
        session = loaded;
        session.notice().ifPresent(message::say);
    }

    /** The same level from its beginning; what was played so far is a recording of its own. */
    void restart(SimSettings settings) {
        keepRecordingOrSay();
        session.restart(settings);
    }

    private void keepRecordingOrSay() {
        try {
            keepRecording();
        } catch (CommandFailure problem) {
            message.say(problem.getMessage());
        }
    }

    private void keepRecording() {
        if (session != null) {
            recordings.keep(session::recording).ifPresent(file -> message.say("Recorded " + file));
        }
    }

    private void closeSession() {
        figures.close();
        if (session != null) {
            session.close();
            session = null;
        }
    }

    /** Keeps the recording, whatever becomes of the rest. */
    @Override
    public void close() {
        try {
            keepRecording();
        } finally {
            closeSession();
        }
    }
}
