package nephele.app.play;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import nephele.app.play.hud.HudContent;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.Scene;
import nephele.host.terminal.CommandFailure;

/** The level being played, if any, with its figures and its recording. */
final class CurrentLevel implements AutoCloseable {
    private final GlContext gl;
    private final FrameStatistics figures;
    private final Recordings recordings;
    private final Message message;
    private final AutoQuality auto;
    private Session session;
    private boolean isBehindTitle;

    CurrentLevel(GlContext gl, Recordings recordings, Message message, AutoQuality auto) {
        this.gl = gl;
        this.auto = auto;
        figures = new FrameStatistics(gl);
        this.recordings = recordings;
        this.message = message;
    }

    /** Returns the session; null before the first level. */
    Session session() {
        return session;
    }

    FrameStatistics figures() {
        return figures;
    }

    void toggleFigures() {
        if (session != null) {
            figures.toggle(session.renderer());
        }
    }

    /** Saves the recording of the previous level and replaces it. */
    void become(Session loaded) {
        keepRecordingOrSay();
        closeSession();
        session = loaded;
        isBehindTitle = false;
        session.notice().ifPresent(message::say);
    }

    /** Draws the level as it lies behind the title from the next frame on. */
    void liesBehindTitle() {
        isBehindTitle = true;
        redraw(auto.ofTitle(session.request()));
    }

    /**
     * Draws the level for play from the next frame on, with the quality that fits.
     *
     * @param firstViewMillis measures the first view; called only where the level's cost is not known
     */
    void isPlayed(ToDoubleFunction<Session> firstViewMillis) {
        if (isBehindTitle) {
            isBehindTitle = false;
            redraw();
        }
        var request = session.request();
        if (auto.wantsMeasurement(request) && auto.firstViewCosts(request, firstViewMillis.applyAsDouble(session))) {
            redraw();
        }
    }

    /** Frees what the level takes; its recording is not saved. */
    void leave() {
        auto.levelEnds();
        closeSession();
    }

    /** Draws the level with the chosen quality; behind the title with the title's. */
    void redraw() {
        redraw(isBehindTitle ? auto.ofTitle(session.request()) : auto.of(session.request()));
    }

    private void redraw(Optional<Quality> automatic) {
        boolean showsFigures = figures.isOpen();
        figures.close();
        session.redraw(gl, automatic);
        if (showsFigures) {
            toggleFigures();
        }
    }

    /** Draws the level with other light from the next frame on. */
    void relight(Scene scene) {
        boolean showsFigures = figures.isOpen();
        figures.close();
        session.relight(scene);
        if (showsFigures) {
            toggleFigures();
        }
    }

    /** Returns what the player could do about the quality if it is too slow. */
    SlowAdvice.QualityNow quality() {
        return auto.now(session.request());
    }

    /** Draws with another quality from the next frame on if the frame rate asks for it. */
    void frameCost(double millis, long pixels) {
        if (auto.frame(session.request(), millis, pixels)) {
            redraw();
        }
    }

    /** Returns the lines of the panel of figures; empty if it is closed. */
    List<HudContent.Figure> figureLines(Language language) {
        if (figures.lines().isEmpty()) {
            return List.of();
        }
        return Stream.concat(auto.figures(session.request(), language).stream(), figures.lines().stream())
                .toList();
    }

    /** Restarts the level; the part played so far is saved as a recording of its own. */
    void restart() {
        keepRecordingOrSay();
        session.restart();
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
            recordings.keep(session::recording).ifPresent(file -> message.say(Phrase.RECORDED, file));
        }
    }

    private void closeSession() {
        figures.close();
        if (session != null) {
            session.close();
            session = null;
        }
    }

    /** Saves the recording, also if the rest fails. */
    @Override
    public void close() {
        try {
            keepRecording();
        } finally {
            leave();
        }
    }
}
