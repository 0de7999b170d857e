package nephele.editor.file;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;
import nephele.editor.document.Document;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;

/**
 * Decides what becomes of a session when other programs change its files. Whatever is chosen, no version is lost: what
 * gives way stays in the history, among the backups, or on disk. It is used by the session's thread.
 */
public final class OutsideChanges {
    private final EditorSession session;
    private final Predicate<Words> isMineKept;
    private final Consumer<Words> tell;
    private final Set<Path> pending = new TreeSet<>();
    private boolean isAsking;
    private boolean isGone;
    /** The level whose file was deleted while it had no changes; {@code null} for none. */
    private Level deleted;

    /**
     * Creates the changes of a session's files, none yet.
     *
     * @param isMineKept asks whether the user's version stays; false to load the other one
     * @param tell tells of something that the user must know before going on
     */
    public OutsideChanges(EditorSession session, Predicate<Words> isMineKept, Consumer<Words> tell) {
        this.session = session;
        this.isMineKept = isMineKept;
        this.tell = tell;
    }

    /** Takes changes of files in; they wait while something is dragged or asked. */
    public void changed(Set<Path> paths) {
        pending.addAll(paths);
        settle();
    }

    /** Reacts to the changes that have waited, if nothing hinders it any more. */
    public void settle() {
        if (isAsking || pending.isEmpty() || session.document().isDragging()) {
            return;
        }
        Set<Path> paths = new TreeSet<>(pending);
        pending.clear();
        Optional<Path> own = session.file().path();
        if (own.isEmpty()) {
            return;
        }
        boolean isLevel = paths.remove(own.get());
        if (!paths.isEmpty()) {
            session.reloadAssets(LevelAssets.beside(own.get()));
            session.status(FileText.ASSETS_RELOADED.with(
                    paths.iterator().next().getFileName() + (paths.size() > 1 ? " …" : "")));
        }
        if (isLevel) {
            isAsking = true;
            try {
                look(own.get());
            } finally {
                isAsking = false;
            }
            settle();
        }
    }

    private void look(Path path) {
        session.drag().cancel();
        switch (session.file().outside()) {
            case SAME -> isBack();
            case DELETED -> isDeleted(path);
            case CHANGED -> isOther(path);
        }
    }

    private void isBack() {
        if (session.document().level() == deleted) {
            session.saved(session.file());
        }
        deleted = null;
        isGone = false;
    }

    private void isDeleted(Path path) {
        Document document = session.document();
        if (isGone) {
            return;
        }
        isGone = true;
        deleted = document.isModified() ? null : document.level();
        keepMine(path);
        document.markUnsaved();
        session.status(FileText.DELETED.with(path.getFileName()));
        tell.accept(FileText.DELETED.with(path));
    }

    private void isOther(Path path) {
        DocumentFile file = session.file().asOfNow();
        Document document = session.document();
        boolean isModified = document.isModified() && document.level() != deleted;
        deleted = null;
        isGone = false;
        Level theirs;
        try {
            theirs = session.background().get(() -> LevelFile.read(path));
        } catch (LevelFormatException noLevel) {
            String reason = noLevel.getMessage().lines().findFirst().orElse("");
            session.status(FileText.NOT_RELOADED.with(path.getFileName(), reason));
            return;
        }
        if (theirs.equals(document.level())) {
            session.saved(file);
        } else if (!isModified) {
            load(theirs, file);
        } else if (isMineKept.test(FileText.CHANGED_QUESTION.with(path))) {
            // Saving makes theirs a backup; the user has seen that there is another version and is not asked again.
            session.known(file);
        } else {
            keepMine(path);
            load(theirs, file);
        }
    }

    private void keepMine(Path path) {
        byte[] mine = LevelJson.write(session.document().level()).getBytes(StandardCharsets.UTF_8);
        session.fileServices().backups().keep(path, mine).ifPresent(session::status);
    }

    private void load(Level theirs, DocumentFile file) {
        Document document = session.document();
        session.tool().cancel();
        document.edit(FileText.RELOAD.words(), mine -> theirs);
        session.saved(file);
        session.status(FileText.RELOADED.with(file.path().orElseThrow().getFileName()));
    }
}
