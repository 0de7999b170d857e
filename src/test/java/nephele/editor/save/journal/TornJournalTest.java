package nephele.editor.save.journal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Arrays;
import java.util.Optional;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.DraftLevel;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A log that ends anywhere in its last record, or has a wrong byte there, gives the state before. */
@Execution(ExecutionMode.CONCURRENT)
class TornJournalTest {
    private static final Instant NOW = Instant.EPOCH;

    private static byte[] text(int edits) {
        return LevelJson.write(DraftLevel.after(edits)).getBytes(StandardCharsets.UTF_8);
    }

    private static JournalRecord.Edit edit(int edits) {
        return JournalRecord.Edit.of(NOW, edits, "move", text(edits - 1), text(edits));
    }

    private static byte[] log(int edits) {
        var base = new JournalRecord.Base(NOW, "t", DocumentFile.UNTITLED, text(0));
        byte[] log = JournalFormat.log(base, edit(1));
        for (int i = 2; i <= edits; i++) {
            byte[] record = JournalFormat.framed(edit(i));
            log = Arrays.copyOf(log, log.length + record.length);
            System.arraycopy(record, 0, log, log.length - record.length, record.length);
        }
        return log;
    }

    private static RecoverableWork work(byte[] log) {
        return JournalLog.work(new StoredJournal(Path.of("j")), log, Optional.empty())
                .orElseThrow();
    }

    @Test
    void aTearAtEveryByteOfTheLastRecordGivesTheStateBefore() {
        byte[] whole = log(3);
        assertEquals(DraftLevel.after(3), work(whole).level());
        for (int length = log(2).length; length < whole.length; length++) {
            RecoverableWork work = work(Arrays.copyOf(whole, length));
            assertEquals(DraftLevel.after(2), work.level(), "torn at " + length);
            assertEquals(2, work.edits());
        }
    }

    @Test
    void aWrongByteAnywhereInTheLastRecordGivesTheStateBefore() {
        byte[] whole = log(3);
        for (int at = log(2).length; at < whole.length; at++) {
            byte[] damaged = whole.clone();
            damaged[at] ^= 0x10;
            assertEquals(DraftLevel.after(2), work(damaged).level(), "wrong byte at " + at);
        }
    }

    @Test
    void whatFollowsATornRecordIsNotRead() {
        byte[] two = log(2);
        byte[] three = log(3);
        byte[] torn = Arrays.copyOf(three, three.length + 5);
        System.arraycopy(three, two.length, torn, two.length + 5, three.length - two.length);
        assertEquals(DraftLevel.after(2), work(torn).level());
    }

    @Test
    void aLogWithoutAWholeBaseIsUnreadable() {
        byte[] one = log(1);
        int base = one.length - JournalFormat.framed(edit(1)).length;
        for (int length = 0; length < base; length++) {
            var work = JournalLog.work(new StoredJournal(Path.of("j")), Arrays.copyOf(one, length), Optional.empty());
            assertTrue(work.isEmpty(), "cut at " + length);
        }
        assertEquals(0, work(Arrays.copyOf(one, base)).edits());
    }

    @Test
    void differencesOfTextsApplyBack() throws IOException {
        String[] texts = {"", "a", "aa", "aaa", "aba", "abab", "ba", "xaaay"};
        for (String old : texts) {
            for (String now : texts) {
                byte[] before = old.getBytes(StandardCharsets.UTF_8);
                JournalRecord.Edit edit =
                        JournalRecord.Edit.of(NOW, 1, "", before, now.getBytes(StandardCharsets.UTF_8));
                assertTrue(edit.fits(before), old + " to " + now);
                assertEquals(now, new String(edit.applied(before), StandardCharsets.UTF_8), old + " to " + now);
            }
        }
    }
}
