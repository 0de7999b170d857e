package nephele.app.play;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import nephele.app.window.Input;
import nephele.engine.draw.Preparation;
import nephele.engine.render.gl.GlContext;

/** A level on its way to be played: prepared on a thread of its own, then made a session where OpenGL is. */
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

    /** What takes long, in words; empty while nothing does. */
    Optional<String> progress() {
        int percent = bakedPercent.get();
        return percent > 0 ? Optional.of("baking the light: " + percent + " %") : Optional.empty();
    }

    /** The level ready to be played; its problems are thrown before anything is kept. */
    Session session(GlContext gl, Input input) {
        return Session.load(gl, request, preparation, input);
    }
}
