package nephele.editor.file;

import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.save.journal.RecoverableWork;
import nephele.editor.text.Words;
import nephele.engine.level.Language;

/** The lost work that a user is offered, the newest first. */
public final class RecoveryList {
    private final SessionJournal journal;
    private final List<RecoverableWork> works;
    private final Instant now;
    private final ZoneId zone;

    public RecoveryList(SessionJournal journal, List<RecoverableWork> works, Instant now, ZoneId zone) {
        this.journal = journal;
        this.works = new ArrayList<>(works);
        this.now = now;
        this.zone = zone;
    }

    public List<RecoverableWork> works() {
        return List.copyOf(works);
    }

    /** Returns a line for each lost session. */
    public List<FileRow> rows() {
        return works.stream().map(this::row).toList();
    }

    private FileRow row(RecoverableWork work) {
        String name = work.level().name();
        Words title = work.file()
                .path()
                .map(path -> Words.same(path.getFileName().toString()))
                .orElseGet(() -> name.isEmpty() ? FileText.UNTITLED.words() : Words.same(name));
        Words edits = work.edits() == 1 ? FileText.ONE_EDIT.words() : FileText.EDITS.with(work.edits());
        Words time = FileText.time(work.lastEdit(), now, zone);
        Words last = work.lastLabel().isEmpty() ? Words.NONE : FileText.LAST_EDIT.with(work.lastLabel());
        Words place = work.file().path().map(Path::toString).map(Words::same).orElse(FileText.UNTITLED.words());
        return new FileRow(title, joined(time, edits, last), place);
    }

    private static Words joined(Words... parts) {
        return Words.of(joined(Language.EN, parts), joined(Language.PT_BR, parts), joined(Language.PT_PT, parts));
    }

    private static String joined(Language language, Words... parts) {
        List<String> said = new ArrayList<>();
        for (Words part : parts) {
            if (!part.in(language).isEmpty()) {
                said.add(part.in(language));
            }
        }
        return String.join(" · ", said);
    }

    /** Opens a line's work as a modified document; it leaves the list. */
    public void recover(int index) {
        journal.recover(works.remove(index));
    }

    /** Deletes a line's work. */
    public void discard(int index) {
        journal.discard(works.remove(index));
    }
}
