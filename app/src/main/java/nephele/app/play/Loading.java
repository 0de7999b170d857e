package nephele.app.play;

import java.util.concurrent.atomic.AtomicInteger;
import nephele.app.settings.Phrase;
import nephele.host.draw.Preparation;
import nephele.engine.level.Language;

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

    /** Returns the prepared level, or throws its problems. */
    Preparation.Prepared prepared() {
        return preparation.get();
    }
}
