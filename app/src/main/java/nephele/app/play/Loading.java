package nephele.app.play;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import nephele.app.text.Phrase;
import nephele.app.window.Input;
import nephele.engine.draw.Preparation;
import nephele.engine.level.Language;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;

/** A level being loaded: prepared on a separate thread, then made a session on the thread of the OpenGL context. */
final class Loading {
    private final PlayRequest request;
    private final AtomicInteger bakedPercent = new AtomicInteger();
    private final Preparation preparation;

    private Loading(PlayRequest request) {
        this.request = request;
        preparation = Preparation.begin(
                request.level(),
                request.chosenQuality(),
                share -> bakedPercent.accumulateAndGet((int) (100 * share), Math::max));
    }

    static Loading begin(PlayRequest request) {
        return new Loading(request);
    }

    boolean isDone() {
        return preparation.isDone();
    }

    /** Returns what is being done, in words. */
    String progress(Language language) {
        int percent = bakedPercent.get();
        if (isDone()) {
            return Phrase.PREPARING.in(language);
        }
        return percent > 0 ? Phrase.BAKING.in(language, percent) : Phrase.READING.in(language);
    }

    PlayRequest request() {
        return request;
    }

    /** Returns the session of the prepared level; its problems are thrown before anything is allocated. */
    Session session(GlContext gl, Input input, Optional<Quality> automatic) {
        return Session.load(gl, request, preparation, input, automatic);
    }
}
