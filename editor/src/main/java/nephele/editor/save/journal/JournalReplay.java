package nephele.editor.save.journal;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;

/** Rebuilds the last state of a log that can be read. */
final class JournalReplay {
    private final List<JournalRecord> records;

    private JournalReplay(List<JournalRecord> records) {
        this.records = records;
    }

    /** A state of a log. */
    private record State(JournalRecord.Edit edit, byte[] text) {}

    /** Returns the work of a log; empty if not even its base can be read. Without readable edits it has 0 of them. */
    static Optional<RecoverableWork> work(StoredJournal journal, byte[] log, Optional<Path> picture) {
        List<JournalRecord> records = JournalFormat.records(log);
        if (records.isEmpty() || !(records.get(0) instanceof JournalRecord.Base base)) {
            return Optional.empty();
        }
        Optional<Level> saved = level(base.text());
        if (saved.isEmpty()) {
            return Optional.empty();
        }
        var replay = new JournalReplay(records);
        State last = replay.lastState(base, state -> true);
        if (last.edit != null && level(last.text).isEmpty()) {
            last = replay.lastState(base, state -> level(state.text).isPresent());
        }
        Level level = last.edit == null ? saved.get() : level(last.text).orElseThrow();
        return Optional.of(new RecoverableWork(
                journal.folder(),
                base.title(),
                base.file(),
                saved.get(),
                level,
                last.edit == null ? base.time() : last.edit.time(),
                last.edit == null ? 0 : last.edit.number(),
                last.edit == null ? "" : last.edit.label(),
                picture));
    }

    private State lastState(JournalRecord.Base base, Predicate<State> good) {
        State last = new State(null, base.text());
        byte[] text = base.text();
        for (JournalRecord record : records.subList(1, records.size())) {
            if (!(record instanceof JournalRecord.Edit edit) || !edit.delta().fits(text)) {
                return last;
            }
            text = edit.delta().applied(text);
            State state = new State(edit, text);
            last = good.test(state) ? state : last;
        }
        return last;
    }

    private static Optional<Level> level(byte[] text) {
        try {
            return Optional.of(LevelJson.read("journal", text));
        } catch (LevelFormatException unreadable) {
            return Optional.empty();
        }
    }

    /** Returns true if a file holds this level. */
    static boolean isSaved(RecoverableWork work, byte[] content) {
        return level(content)
                .filter(level -> text(level).equals(text(work.level())))
                .isPresent();
    }

    private static String text(Level level) {
        return LevelJson.write(level);
    }
}
