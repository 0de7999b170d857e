package nephele.app.play;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import nephele.app.settings.Phrase;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Language;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.render.gl.GlUnavailableException;
import nephele.engine.render.gl.shader.GlException;
import nephele.host.draw.Preparation;

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
                fraction -> bakedPercent.accumulateAndGet((int) (100 * fraction), Math::max),
                System.err::println);
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

    /** Returns one line for failures after which the game continues; empty for a bug. */
    static Optional<String> problemLine(RuntimeException failure) {
        boolean goesOn = failure instanceof LevelFormatException
                || failure instanceof AssetException
                || failure instanceof GlUnavailableException
                || failure instanceof GlException;
        return goesOn
                ? Optional.of(failure.getMessage().lines().findFirst().orElse("the level can't be loaded"))
                : Optional.empty();
    }
}
