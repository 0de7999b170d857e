package nephele.editor.panel;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.SwingWorker;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;

/** Searches the problems of a level on another thread, one search at a time; a new one cancels the one before. */
final class ProblemWork {
    private final Consumer<List<LevelProblem>> shown;
    private AssetSource assets;
    private ProblemSearch search;
    private Level searched;
    private SwingWorker<Optional<List<LevelProblem>>, Void> running;

    /** @param shown receives what was found, on the event dispatch thread */
    ProblemWork(AssetSource assets, Consumer<List<LevelProblem>> shown) {
        this.assets = assets;
        this.shown = shown;
        search = new ProblemSearch(assets);
    }

    /** Returns true if the last search was of another level or other files. */
    boolean isNew(Level level, AssetSource files) {
        return level != searched || files != assets;
    }

    void search(Level level, AssetSource files) {
        if (running != null) {
            running.cancel(false);
        }
        if (files != assets) {
            assets = files;
            search = new ProblemSearch(files);
        }
        searched = level;
        ProblemSearch used = search;
        running = new SwingWorker<>() {
            @Override
            protected Optional<List<LevelProblem>> doInBackground() {
                // The search keeps what it has found, so that two at a time would meet in it.
                synchronized (used) {
                    return used.find(level, this::isCancelled);
                }
            }

            @Override
            protected void done() {
                try {
                    if (!isCancelled()) {
                        get().ifPresent(shown);
                    }
                } catch (CancellationException | InterruptedException cancelled) {
                    // The next search tells the result.
                } catch (ExecutionException failed) {
                    throw new IllegalStateException("the search for problems failed", failed.getCause());
                }
            }
        };
        running.execute();
    }
}
