package nephele.app.play;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import nephele.app.window.Input;
import nephele.engine.draw.Preparation;
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
                request.quality(),
                share -> bakedPercent.accumulateAndGet((int) (100 * share), Math::max));
    }

    static Loading begin(PlayRequest request) {
        return new Loading(request);
    }

    boolean isDone() {
        return preparation.isDone();
    }

    /** Returns the progress of a long part in words; empty while there is none. */
    Optional<String> progress() {
        int percent = bakedPercent.get();
        return percent > 0 ? Optional.of("baking the light: " + percent + " %") : Optional.empty();
    }

    /** Returns the session of the prepared level; its problems are thrown before anything is allocated. */
    Session session(GlContext gl, Input input) {
        return Session.load(gl, request, preparation, input);
    }
}
