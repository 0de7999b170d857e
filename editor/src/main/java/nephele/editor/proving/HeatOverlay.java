package nephele.editor.proving;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
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
    /** One computation, which ends when a newer one begins. */
    private static final class Run {
        private volatile boolean isCancelled;
        private volatile long toldNanos;
    }

    private final ProvingSubject subject;
    private ProvingThreads threads = ProvingThreads.DIRECT;
    private boolean isShown;
    private Level computedOf;
    private AssetSource computedWith;
    private HeatMemory memory;
    private List<Mark> marks = List.of();
    private Map<HeatText, Integer> counts = Map.of();
    private Words told = Words.NONE;
    private Run running = new Run();

    HeatOverlay(ProvingSubject subject) {
        this.subject = subject;
    }

    void runOn(ProvingThreads other) {
        threads = other;
    }

    public boolean isShown() {
        return isShown;
    }

    /** Shows the map or takes it away. */
    public void show(boolean shown) {
        isShown = shown;
        if (isShown) {
            follow();
        } else {
            running.isCancelled = true;
            computedOf = null;
        }
        subject.redraw();
    }

    /** Computes the map again if the level has changed; waits for the end of a drag. */
    void follow() {
        boolean isSame = subject.level() == computedOf && subject.assets() == computedWith;
        if (!isShown || isSame || !subject.isSettled()) {
            return;
        }
        running.isCancelled = true;
        Run run = new Run();
        running = run;
        Level level = subject.level();
        AssetSource assets = subject.assets();
        HeatMemory before = assets == computedWith ? memory : null;
        computedOf = level;
        computedWith = assets;
        run.toldNanos = System.nanoTime();
        threads.work().execute(() -> compute(run, level, assets, before));
    }

    private void compute(Run run, Level level, AssetSource assets, HeatMemory before) {
        try {
            PlacedLevel placed = before == null
                    ? PlacedLevel.of(level, assets)
                    : before.placed().edited(level);
            PlacementHeatMap map = new PlacementHeatMap(placed, PlacementHeatMap.Settings.DEFAULT, before);
            boolean isDone = map.compute(() -> run.isCancelled, part -> progress(run, map.done()));
            if (isDone) {
                HeatMemory result = map.memory();
                List<Mark> drawn = HeatRegions.of(result);
                threads.session().execute(() -> done(run, result, drawn));
            }
        } catch (AssetException | IllegalArgumentException unusable) {
            threads.session().execute(() -> failed(run, unusable.getMessage()));
        }
    }

    private void progress(Run run, double share) {
        long now = System.nanoTime();
        if (now - run.toldNanos > PROGRESS_NANOS) {
            run.toldNanos = now;
            Words words = ProvingText.HEAT_PROGRESS.words().with(Math.round(100 * share));
            threads.session().execute(() -> {
                if (run == running && !run.isCancelled) {
                    subject.status(words);
                }
            });
        }
    }

    private void done(Run run, HeatMemory result, List<Mark> drawn) {
        if (run != running || run.isCancelled) {
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
        subject.status(ProvingText.HEAT_DONE.words().with(fit, slide, refused));
        subject.redraw();
    }

    private void failed(Run run, String message) {
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
        return isShown ? marks : List.of();
    }

    void pointed(Vec3 place) {
        if (!isShown || memory == null) {
            return;
        }
        HeatCell cell = memory.at(place);
        Words words = cell == null ? Words.NONE : cell.text().words(cell.metres());
        if (!words.equals(told)) {
            told = words;
            subject.status(words);
        }
    }
}
