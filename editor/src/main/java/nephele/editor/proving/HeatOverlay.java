package nephele.editor.proving;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import nephele.editor.pane.Mark;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;

/** The placement heat map over the perspective panes; after an edit only what is near it is computed again. */
public final class HeatOverlay {
    private static final long PROGRESS_NANOS = 200_000_000;
    private final ProvingSubject subject;
    private final Supplier<ProvingThreads> threads;
    private boolean isVisible;
    private Level computedOf;
    private AssetSource computedWith;
    private HeatMap memory;
    private List<Mark> marks = List.of();
    private Map<HeatText, Integer> counts = Map.of();
    private Words reported = Words.NONE;

    /** The number of the last computation; an older one ends when it has changed. */
    private volatile int running;

    /** When the progress was reported last. */
    private volatile long reportedNanos;

    HeatOverlay(ProvingSubject subject, Supplier<ProvingThreads> threads) {
        this.subject = subject;
        this.threads = threads;
    }

    public boolean isVisible() {
        return isVisible;
    }

    /** Shows the map or takes it away. */
    public void show(boolean visible) {
        isVisible = visible;
        if (isVisible) {
            follow();
        } else {
            running = running + 1;
            computedOf = null;
        }
        subject.redraw();
    }

    /** Computes the map again if the level has changed; waits for the end of a drag. */
    void follow() {
        boolean isSame = subject.level() == computedOf && subject.assets() == computedWith;
        if (!isVisible || isSame || !subject.isSettled()) {
            return;
        }
        int run = running + 1;
        running = run;
        Level level = subject.level();
        AssetSource assets = subject.assets();
        HeatMap before = assets == computedWith ? memory : null;
        computedOf = level;
        computedWith = assets;
        reportedNanos = System.nanoTime();
        threads.get().work().execute(() -> compute(run, level, assets, before));
    }

    private void compute(int run, Level level, AssetSource assets, HeatMap before) {
        try {
            PlacedLevel placed = before == null
                    ? PlacedLevel.of(level, assets)
                    : before.placed().edited(level);
            PlacementHeatMap map = new PlacementHeatMap(placed, before);
            boolean isDone = map.compute(() -> run != running, () -> progress(run, map.done()));
            if (isDone) {
                HeatMap result = map.map();
                List<Mark> drawn = HeatRegions.of(result);
                threads.get().session().execute(() -> done(run, result, drawn));
            }
        } catch (AssetException | IllegalArgumentException unusable) {
            threads.get().session().execute(() -> failed(run, unusable.getMessage()));
        }
    }

    private void progress(int run, double fraction) {
        long now = System.nanoTime();
        if (now - reportedNanos > PROGRESS_NANOS) {
            reportedNanos = now;
            Words words = ProvingText.HEAT_PROGRESS.with(Math.round(100 * fraction));
            threads.get().session().execute(() -> {
                if (run == running) {
                    subject.status(words);
                }
            });
        }
    }

    private void done(int run, HeatMap result, List<Mark> drawn) {
        if (run != running) {
            return;
        }
        memory = result;
        marks = drawn;
        Map<HeatText, Integer> number = new EnumMap<>(HeatText.class);
        result.all().forEach(cell -> number.merge(cell.text(), 1, Integer::sum));
        counts = Collections.unmodifiableMap(number);
        int fit = number.getOrDefault(HeatText.FITS, 0);
        int slide = number.getOrDefault(HeatText.SLIDES, 0);
        int refused = number.values().stream().mapToInt(Integer::intValue).sum() - fit - slide;
        subject.status(ProvingText.HEAT_DONE.with(fit, slide, refused));
        subject.redraw();
    }

    private void failed(int run, String message) {
        if (run == running) {
            marks = List.of();
            counts = Map.of();
            memory = null;
            subject.status(Words.same(message));
            subject.redraw();
        }
    }

    /** Returns the number of cells with each result that occurs. */
    public Map<HeatText, Integer> counts() {
        return counts;
    }

    /** Returns the marks for perspective panes: the same list until the map changes. */
    public List<Mark> marks() {
        return isVisible ? marks : List.of();
    }

    void pointed(Vec3 place) {
        if (!isVisible || memory == null) {
            return;
        }
        HeatCell cell = memory.at(place);
        Words words = cell == null ? Words.NONE : cell.text().words(cell.metres());
        if (!words.equals(reported)) {
            reported = words;
            subject.status(words);
        }
    }
}
