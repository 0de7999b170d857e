package nephele.app.play;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.host.named.LevelName;
import nephele.host.named.LevelSummary;

/** Reads the levels of a list one after another on a thread of its own, so that the menu never waits for them. */
final class LevelReader {
    /** Bounds the memory of pictures, which are those of strangers in the user's folder. */
    private static final int MOST_PICTURES = 100;

    private static final int MOST_PIXELS = 1 << 18;

    private final List<LevelName> levels;
    private final Function<LevelName, LevelSummary> summary;
    private final Map<LevelName, LevelSummary> read = new ConcurrentHashMap<>();
    private volatile boolean isEnded;

    private LevelReader(List<LevelName> levels, Function<LevelName, LevelSummary> summary) {
        this.levels = List.copyOf(levels);
        this.summary = summary;
    }

    /** Starts to read. */
    static LevelReader begin(List<LevelName> levels, Function<LevelName, LevelSummary> summary) {
        LevelReader reader = new LevelReader(levels, summary);
        Thread thread = new Thread(reader::readAll, "list of levels");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
        return reader;
    }

    private void readAll() {
        int pictures = 0;
        for (int i = 0; i < levels.size() && !isEnded; i++) {
            LevelName level = levels.get(i);
            Optional<Picture> picture = pictures < MOST_PICTURES
                    ? level.picture().filter(shown -> shown.width() * shown.height() <= MOST_PIXELS)
                    : Optional.empty();
            pictures += picture.isPresent() ? 1 : 0;
            read.put(level, summary.apply(level).with(picture.orElse(null)));
        }
    }

    /** Reads no further level: the list is shown no more. */
    void end() {
        isEnded = true;
    }

    /** Returns the levels in the order in which they are read. */
    List<LevelName> levels() {
        return levels;
    }

    /** Returns the number of levels that were read so far. */
    int done() {
        return read.size();
    }

    boolean isDone() {
        return done() == levels.size();
    }

    /** Returns a level of the list; empty until it was read. */
    Optional<LevelSummary> of(LevelName level) {
        return Optional.ofNullable(read.get(level));
    }
}
