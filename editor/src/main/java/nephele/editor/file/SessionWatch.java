package nephele.editor.file;

import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.Executor;
import nephele.editor.document.Registration;
import nephele.editor.save.DocumentFile.Outside;
import nephele.editor.save.FileWatch;
import nephele.editor.save.NamedAssets;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionChange;
import nephele.engine.level.Level;

/** Watches the files of the open level, and passes their changes on to the session's thread. */
public final class SessionWatch implements AutoCloseable {
    private final EditorSession session;
    private final OutsideChanges changes;
    private final Executor onSession;
    private final Executor background;
    private final FileWatch watch;
    private final Registration registration;
    private volatile Watched current = new Watched(null, null);
    /** Owned by the background thread, as the next one is. */
    private Path watchedFile;

    private Set<String> watchedAssets = Set.of();

    private record Watched(Path file, Level level) {}

    /**
     * Begins to watch.
     *
     * @param onSession runs what touches the session
     * @param background runs what reads files, in order
     */
    public SessionWatch(EditorSession session, OutsideChanges changes, Executor onSession, Executor background) {
        this.session = session;
        this.changes = changes;
        this.onSession = onSession;
        this.background = background;
        watch = FileWatch.start(paths -> onSession.execute(() -> changes.changed(paths)));
        registration = session.listen(this::follow);
        watchFiles();
    }

    private void follow(SessionChange change) {
        boolean isOther = change == SessionChange.DOCUMENT || change == SessionChange.FILE;
        if (isOther && !session.document().isDragging()) {
            watchFiles();
            onSession.execute(changes::settle);
        }
    }

    private void watchFiles() {
        Level level = session.document().level();
        Path file = session.file().path().orElse(null);
        boolean isOtherFile = !Objects.equals(file, current.file());
        if (level == current.level() && !isOtherFile) {
            return;
        }
        Watched now = new Watched(file, level);
        current = now;
        background.execute(() -> {
            if (isOtherFile || now == current) {
                watch(now);
            }
            if (isOtherFile && file != null) {
                onSession.execute(() -> lookAgain(file));
            }
        });
    }

    /** Only what names assets is compared: most edits change none. */
    private void watch(Watched now) {
        Set<String> assets = NamedAssets.of(now.level());
        if (!Objects.equals(now.file(), watchedFile) || !assets.equals(watchedAssets)) {
            watchedFile = now.file();
            watchedAssets = assets;
            watch.watch(now.file() == null ? List.of() : FileWatch.filesOf(now.file(), now.level()));
        }
    }

    /** Finds by its content what changed before the watch knew the file. */
    private void lookAgain(Path file) {
        boolean isCurrent = session.file().path().filter(file::equals).isPresent();
        if (isCurrent && session.file().outside() != Outside.SAME) {
            changes.changed(Set.of(file));
        }
    }

    @Override
    public void close() {
        registration.close();
        watch.close();
    }
}
